// SPDX-License-Identifier: BSD-3-Clause
// Material points of one body in space, as a structure of arrays.
#pragma once

#include <iterator>

#include "adapters/mpm/kernel/particle_columns.hpp"
#include "support/vector.hpp"

namespace grit::mpm::space {

namespace column {
enum : int {
    x,
    y,
    z,  // position [m]
    v_x,
    v_y,
    v_z,  // velocity [m/s]
    F_xx,
    F_xy,
    F_xz,
    F_yx,
    F_yy,
    F_yz,
    F_zx,
    F_zy,
    F_zz,  // deformation gradient [-]
    l_x,
    l_y,
    l_z,   // initial half sides [m]
    mass,  // [kg]
    V0,    // initial volume [m3]
    S_xx,
    S_yy,
    S_zz,
    S_xy,
    S_xz,
    S_yz,  // Cauchy stress [Pa], in the order of the library
    b_x,
    b_y,
    b_z,  // body acceleration [m/s2]
    q,    // bulk viscous pressure, compression positive [Pa]
    own   // first column of the material
};
// As files have them.
inline constexpr const char* names[] = {
    "x",    "y",    "z",    "v_x",  "v_y",  "v_z",  "F_xx", "F_xy", "F_xz", "F_yx",
    "F_yy", "F_yz", "F_zx", "F_zy", "F_zz", "l_x",  "l_y",  "l_z",  "mass", "V0",
    "S_xx", "S_yy", "S_zz", "S_xy", "S_xz", "S_yz", "b_x",  "b_y",  "b_z",  "q"};
static_assert(std::size(names) == own);
}  // namespace column

// What kernels see: column c of particle p is base[c * stride + p].
struct ParticleView {
    double* base;
    std::ptrdiff_t stride;
    GRIT_INLINE double* operator[](int c) const { return base + c * stride; }
    // F_ij
    GRIT_INLINE double F(int i, int j, std::ptrdiff_t p) const {
        return (*this)[column::F_xx + 3 * i + j][p];
    }
    GRIT_INLINE double J(std::ptrdiff_t p) const {
        return F(0, 0, p) * (F(1, 1, p) * F(2, 2, p) - F(1, 2, p) * F(2, 1, p)) -
               F(0, 1, p) * (F(1, 0, p) * F(2, 2, p) - F(1, 2, p) * F(2, 0, p)) +
               F(0, 2, p) * (F(1, 0, p) * F(2, 1, p) - F(1, 1, p) * F(2, 0, p));
    }
    GRIT_INLINE double volume(std::ptrdiff_t p) const { return (*this)[column::V0][p] * J(p); }
    GRIT_INLINE Vector3 position(std::ptrdiff_t p) const { return vector(column::x, p); }
    // Of a vector's first column.
    GRIT_INLINE Vector3 vector(int first, std::ptrdiff_t p) const {
        const ParticleView& q = *this;
        return {q[first][p], q[first + 1][p], q[first + 2][p]};
    }
};

// A brick of a particle, without stress.
struct NewParticle {
    Vector3 centre, half_sides;  // [m]
    double density;              // [kg/m3]
    Vector3 velocity{0.0, 0.0, 0.0};
};

class Particles : public ParticleColumns {
  public:
    explicit Particles(int own_columns = 0) : ParticleColumns(column::own + own_columns) {}

    // The id of a particle is the order of adding.
    void add(const NewParticle& particle);
    ParticleView view() { return {data.data(), stride}; }
};

}  // namespace grit::mpm::space
