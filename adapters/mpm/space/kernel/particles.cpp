// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/kernel/particles.hpp"

#include <stdexcept>

namespace grit::mpm::space {

void Particles::add(const NewParticle& given) {
    const Vector3& l = given.half_sides;
    if (!(l[0] > 0.0 && l[1] > 0.0 && l[2] > 0.0 && given.density > 0.0))
        throw std::invalid_argument("half sides and density of a particle must be positive");
    const std::ptrdiff_t p = append();
    const ParticleView q = view();
    for (int k = 0; k < 3; ++k) {
        q[column::x + k][p] = given.centre[k];
        q[column::v_x + k][p] = given.velocity[k];
        q[column::F_xx + 4 * k][p] = 1.0;
        q[column::l_x + k][p] = l[k];
    }
    q[column::V0][p] = 8.0 * l[0] * l[1] * l[2];
    q[column::mass][p] = given.density * q[column::V0][p];
}

}  // namespace grit::mpm::space
