// SPDX-License-Identifier: BSD-3-Clause
// Material points of one body as a structure of arrays. Mass and volume are per metre (plane strain) or
// per radian (axisymmetry).
#pragma once

#include <cstddef>
#include <iterator>

#include "adapters/mpm/kernel/particle_columns.hpp"
#include "support/kernel.hpp"

namespace grit::mpm {

namespace column {
enum : int {
    r,
    z,  // position [m]
    v_r,
    v_z,  // velocity [m/s]
    F_rr,
    F_rz,
    F_zr,
    F_zz,
    F_tt,  // deformation gradient [-]
    l_r,
    l_z,   // initial half sides [m]
    mass,  // [kg]
    V0,    // initial volume [m3]
    S_rr,
    S_zz,
    S_tt,
    S_rz,  // Cauchy stress [Pa], in the order of the library
    b_r,
    b_z,  // body acceleration [m/s2]
    q,    // bulk viscous pressure, compression positive [Pa]
    own   // first column of the material
};
// As files have them.
inline constexpr const char* names[] = {"r",    "z",    "v_r",  "v_z", "F_rr", "F_rz", "F_zr",
                                        "F_zz", "F_tt", "l_r",  "l_z", "mass", "V0",   "S_rr",
                                        "S_zz", "S_tt", "S_rz", "b_r", "b_z",  "q"};
static_assert(std::size(names) == own);
}  // namespace column

// What kernels see: column c of particle p is base[c * stride + p].
struct ParticleView {
    double* base;
    std::ptrdiff_t stride;
    GRIT_INLINE double* operator[](int c) const { return base + c * stride; }
    GRIT_INLINE double J(std::ptrdiff_t p) const {
        const ParticleView& q = *this;
        return (q[column::F_rr][p] * q[column::F_zz][p] - q[column::F_rz][p] * q[column::F_zr][p]) *
               q[column::F_tt][p];
    }
};

// A rectangular particle at rest, without stress.
struct NewParticle {
    double r, z;      // centre [m]
    double l_r, l_z;  // half sides [m]
    double density;   // [kg/m3]
    double v_r = 0.0, v_z = 0.0;
};

class Particles : public ParticleColumns {
  public:
    explicit Particles(int own_columns = 0) : ParticleColumns(column::own + own_columns) {}

    using ParticleColumns::add;
    // axisymmetric: mass and volume per radian. The id of a particle is the order of adding.
    void add(const NewParticle& particle, bool axisymmetric);
    ParticleView view() { return {data.data(), stride}; }
};

}  // namespace grit::mpm
