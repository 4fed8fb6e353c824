// SPDX-License-Identifier: BSD-3-Clause
// What the kernels take and give: plain data, the same for every instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "adapters/mpm/kernel/axis.hpp"
#include "adapters/mpm/kernel/particles.hpp"
#include "adapters/mpm/kernel/total.hpp"
#include "support/vector.hpp"

namespace grit::mpm {

enum class Shape {
    cpdi,            // (A1)-(A3)
    cpdi_published,  // unweighted corners, T = S / r_p: the published axisymmetric CPDI
    ugimp,           // the undeformed, upright domain, no thinner than a quarter of a cell
    point            // linear shape functions at the particle: the original method
};

namespace record {
enum : int { m, p_r, p_z, f_r, f_z, g_r, g_z, g_scale, size };
}  // namespace record

// What a body leaves at a node: mass, momentum, force, gradient for normals and its size; a cache line.
struct alignas(64) NodeRecord {
    double value[record::size];
    GRIT_INLINE double& operator[](int i) { return value[i]; }
    GRIT_INLINE double operator[](int i) const { return value[i]; }
};

namespace motion {
enum : int { v_r, v_z, other_r, other_z, size };
}  // namespace motion

// What a node gives back: its velocity, and another one; half a cache line.
struct alignas(32) NodeMotion {
    double value[motion::size];
    GRIT_INLINE double& operator[](int i) { return value[i]; }
    GRIT_INLINE double operator[](int i) const { return value[i]; }
};

struct GridView {
    AxisView r, z;
    GRIT_INLINE std::ptrdiff_t nodes_r() const { return r.cells + 1; }
    GRIT_INLINE std::ptrdiff_t cell_of(double at_r, double at_z) const {
        return z.cell_of(at_z) * static_cast<std::ptrdiff_t>(r.cells) + r.cell_of(at_r);
    }
};

// Which sums a scatter adds to.
namespace part {
enum : unsigned { mass = 1, momentum = 2, force = 4, gradient = 8, all = 15 };
}  // namespace part

// A record in fixed point: value times scale, a power of two, rounded.
template <int lanes> struct alignas(8 * lanes) IntegersOf { std::int64_t value[lanes]; };

template <int lanes> struct FixedPointOf {
    // Contributions from this size on are lost. A node has room for 2^12 of the largest.
    static constexpr double limit = 0x1p51;
    IntegersOf<lanes>* nodes;  // added to
    double scale[lanes];
    double largest[lanes];  // out: |contribution| times scale
};

using NodeIntegers = IntegersOf<record::size>;
using FixedPoint = FixedPointOf<record::size>;

// Displacement gradient of the step against its start [-]; tt is the hoop.
struct Gradient {
    double rr, rz, zr, zz, tt;
    GRIT_INLINE double trace() const { return rr + zz + tt; }
};

// Volume of a cell, and volume times what is averaged, in fixed point: no order changes a bit.
struct CellIntegers {
    static constexpr double scale = 0x1p50;  // of volumes, to reference; a cell has room for 2^13
    std::int64_t volume, weighted;
    GRIT_INLINE double mean() const {
        return static_cast<double>(weighted) / static_cast<double>(volume);
    }
    // per_volume: of the reference, of which cells have an eighth [1/m3].
    GRIT_INLINE double total(double per_volume) const {
        return 8.0 * static_cast<double>(volume) / (scale * per_volume);
    }
};

// Deformation of a particle that waits for the mean of its cell; cell -1: it wants none.
struct Deferred {
    Gradient L;
    int cell;
};

// The volumetric strain of a step as the mean over the particles of a cell, against locking: for all but
// those that are separated.
struct CellMean {
    CellIntegers* cells = nullptr;  // added to; null: each particle has its own
    Deferred* deferred = nullptr;   // [particles] out
    double per_volume = 0.0;        // 1 / volume of the largest particle [1/m3]
    double per_stress = 0.0;        // 1 / largest mean stress of the body [1/Pa]
};

// A particle without any stress is separated: it no longer opens once its void ratio is at the cap.
struct Separation {
    int void_ratio = -1;  // column; -1: nothing separates
    double cap = 0.0;     // [-]
};

struct NodeAnswer;
struct WaterScatter;
struct WaterGather;

struct ScatterCall {
    GridView grid;
    ParticleView particles;
    std::ptrdiff_t begin, end;
    NodeRecord* nodes;  // added to
    unsigned parts;
    FixedPoint* fixed_point = nullptr;  // in place of nodes
    CellMean mean = {};                 // with cells, of the mean stress
    Separation separation = {};
    const WaterScatter* water = nullptr;  // in its pores, where parts are all; null: none
};

// Mean stress and volume of the cells.
struct MeanStressCall {
    GridView grid;
    ParticleView particles;
    std::ptrdiff_t begin, end;
    CellMean mean;  // without cells, nothing is added
    Separation separation;
};

// What a gather does. In its default it does all, with the velocity v.
namespace task {
enum : unsigned {
    velocity = 1,         // v_p += S (v - other), then the PIC share
    position = 2,         // x_p += dt U v
    deformation = 4,      // F and the increments, by v ...
    deform_by_other = 8,  // ... or by other
    all = 7
};
}  // namespace task

// Increments of at most so many particles: midpoint strain, engineering shear, 11 = rr, 22 = zz, 33 = tt,
// 12 = rz, and the rotation Q, row-major, before it.
struct alignas(64) Increments {
    static constexpr int capacity = 64;
    double strain[4][capacity];
    double rotation[9][capacity];
};

struct GatherCall {
    GridView grid;
    ParticleView particles;
    std::ptrdiff_t begin, end;  // no more than Increments::capacity
    const NodeMotion* nodes;    // v and other: the velocity before the step's forces
    double dt;                  // [s]
    double pic;                 // PIC share of this step [-]
    unsigned tasks;
    Separation separation = {};
    bool reduces_domains = false;
    CellMean mean = {};                  // with cells, deformation stops there
    bool fixed_point = false;            // of the sums
    const WaterGather* water = nullptr;  // in its pores; null: none
};

// The rest of deformation, where the mean is over cells.
struct DeformCall {
    ParticleView particles;
    std::ptrdiff_t begin, end;  // no more than Increments::capacity
    const CellIntegers* cells;
    const Deferred* deferred;  // [particles]
    Separation separation;
    bool reduces_domains = false;
};

struct GatherSums {
    Total kept;            // 1/2 m (S dv)^2: what FLIP keeps of the nodes' 1/2 m dv^2 [J]
    Total pic_loss;        // kinetic energy that the PIC share takes [J]
    Total body_work;       // of the body acceleration [J]
    double most_v2 = 0.0;  // largest v^2 [m2/s2]
    double most_dz = 0.0;  // longest way along z [m]
    int reflected = 0;     // particles that are now at r < 0 ...
    int outside = 0;       // ... or outside of the grid
};

struct PatchCall;

// The kernels of one instruction set: bitwise the same results, for nothing is contracted.
struct Kernels {
    void (*scatter)(Shape, bool axisymmetric, const ScatterCall&);
    void (*gather)(Shape, bool axisymmetric, const GatherCall&, Increments&, GatherSums&);
    void (*deform)(bool axisymmetric, const DeformCall&, Increments&);
    // Returns the largest mean stress [Pa].
    double (*add_mean_stresses)(bool axisymmetric, const MeanStressCall&);
    // Of pore_water.hpp: forces of pressures, added to nodes; how fast the volumes of cells grow at velocities of nodes.
    void (*push_by_pressures)(const PatchCall&, const double* pressure, double* nodes);
    void (*find_swelling)(const PatchCall&, const double* nodes, double* swelling);
    // ... at those that a pressure of 1 Pa in the cell itself gives.
    void (*find_own_swelling)(const PatchCall&, const NodeAnswer* nodes, double* swelling);
};

// The best that this processor has, and those of any.
const Kernels& kernels();
extern const Kernels baseline_kernels;

}  // namespace grit::mpm
