// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/particles.hpp"

#include <stdexcept>

namespace grit::mpm {

void Particles::add(const NewParticle& q, bool axisymmetric) {
    if (!(q.l_r > 0.0 && q.l_z > 0.0 && q.density > 0.0))
        throw std::invalid_argument("half sides and density of a particle must be positive");
    if (axisymmetric && !(q.r >= q.l_r * (1.0 - 1e-12)))
        throw std::invalid_argument("a particle must not reach across the axis");
    const std::ptrdiff_t p = append();
    const ParticleView v = view();
    v[column::r][p] = q.r;
    v[column::z][p] = q.z;
    v[column::v_r][p] = q.v_r;
    v[column::v_z][p] = q.v_z;
    v[column::F_rr][p] = v[column::F_zz][p] = v[column::F_tt][p] = 1.0;
    v[column::l_r][p] = q.l_r;
    v[column::l_z][p] = q.l_z;
    v[column::V0][p] = 4.0 * q.l_r * q.l_z * (axisymmetric ? q.r : 1.0);
    v[column::mass][p] = q.density * v[column::V0][p];
}

}  // namespace grit::mpm
