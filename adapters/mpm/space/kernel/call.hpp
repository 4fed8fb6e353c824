// SPDX-License-Identifier: BSD-3-Clause
// What the kernels take and give in space: plain data, the same for every instruction set.
#pragma once

#include <cstddef>

#include "adapters/mpm/kernel/call.hpp"
#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/space/kernel/particles.hpp"

namespace grit::mpm::space {

namespace record {
enum : int { m, p_x, p_y, p_z, f_x, f_y, f_z, size = 8 };
}  // namespace record

// What a body leaves at a node: mass, momentum, force; a cache line.
struct alignas(64) NodeRecord {
    double value[record::size];
    GRIT_INLINE double& operator[](int i) { return value[i]; }
    GRIT_INLINE double operator[](int i) const { return value[i]; }
};

namespace slope {
enum : int { g_x, g_y, g_z, scale, size };
}  // namespace slope

// ... and, where bodies may meet, the gradient for normals and its size; of one with pore water also the force of its pressure
// [N], in the first three.
struct alignas(32) NodeSlope {
    double value[slope::size];
    GRIT_INLINE double& operator[](int i) { return value[i]; }
    GRIT_INLINE double operator[](int i) const { return value[i]; }
};

namespace motion {
enum : int { v_x, v_y, v_z, other_x = 4, other_y, other_z, size = 8 };
}  // namespace motion

// What a node gives back: its velocity, and the one before the step's forces; a cache line.
struct alignas(64) NodeMotion {
    double value[motion::size];
    GRIT_INLINE double& operator[](int i) { return value[i]; }
    GRIT_INLINE double operator[](int i) const { return value[i]; }
};

struct GridView {
    AxisView axis[3];
    GRIT_INLINE std::ptrdiff_t nodes(int direction) const { return axis[direction].cells + 1; }
    // From a node to the next one along a direction.
    GRIT_INLINE std::ptrdiff_t step(int direction) const {
        return direction == 0 ? 1 : direction == 1 ? nodes(0) : nodes(0) * nodes(1);
    }
    GRIT_INLINE std::ptrdiff_t cell(int i, int j, int k) const {
        return (k * std::ptrdiff_t{axis[1].cells} + j) * axis[0].cells + i;
    }
    GRIT_INLINE std::ptrdiff_t cell_of(const Vector3& at) const {
        return cell(axis[0].cell_of(at[0]), axis[1].cell_of(at[1]), axis[2].cell_of(at[2]));
    }
    GRIT_INLINE bool has(const Vector3& at) const {
        bool inside = true;  // positive conditions, so that NaN fails them
        for (int d = 0; d < 3; ++d)
            inside = inside && at[d] >= axis[d].node[0] && at[d] <= axis[d].node[axis[d].cells];
        return inside;
    }
};

// Displacement gradient of the step against its start [-].
struct Gradient {
    double of[3][3];
    GRIT_INLINE double trace() const { return of[0][0] + of[1][1] + of[2][2]; }
};

// Deformation of a particle that waits for the mean of its cell; cell -1: it wants none.
struct Deferred {
    Gradient L;
    std::ptrdiff_t cell;
};

// As in the plane: the volumetric strain of a step as the mean over the particles of a cell.
struct CellMean {
    CellIntegers* cells = nullptr;  // added to; null: each particle has its own
    Deferred* deferred = nullptr;   // [particles] out
    double per_volume = 0.0;        // 1 / volume of the largest particle [1/m3]
    double per_stress = 0.0;        // 1 / largest mean stress of the body [1/Pa]
};

using FixedRecords = FixedPointOf<record::size>;
using FixedSlopes = FixedPointOf<slope::size>;

// The mean pore pressures of cells, as shares of the bulk modulus [Pa].
struct PorePressures {
    const CellIntegers* cells = nullptr;  // null: no pore water
    double bulk_modulus = 0.0;
    // Compression positive [Pa].
    GRIT_INLINE double of(std::ptrdiff_t cell) const {
        return cells[cell].volume > 0 ? cells[cell].mean() * bulk_modulus : 0.0;
    }
};

struct ScatterCall {
    GridView grid;
    ParticleView particles;
    std::ptrdiff_t begin, end;
    NodeRecord* nodes;   // added to
    NodeSlope* slopes;   // added to; null: nobody asks for normals
    CellMean mean = {};  // with cells, of the mean stress
    Separation separation = {};
    FixedRecords* fixed_records = nullptr;  // in place of nodes ...
    FixedSlopes* fixed_slopes = nullptr;    // ... and of slopes
    PorePressures pore_pressures = {};      // which press besides the stresses
    NodeSlope* pore_forces =
        nullptr;  // of these, added to, beside slopes; null: nobody asks for them
    FixedSlopes* fixed_pore_forces = nullptr;
};

struct MeanStressCall {
    GridView grid;
    ParticleView particles;
    std::ptrdiff_t begin, end;
    CellMean mean;  // without cells, nothing is added
    Separation separation;
};

// A particle before a gather, and how the nodes strain it: its pore pressure waits for the strain of its cell.
struct PorePlace {
    double V, e, strain;  // [m3], void ratio, volumetric strain of the step
    std::ptrdiff_t cell;
};
struct PoreStrains {
    const PoreWater* water = nullptr;  // null: there is none
    PorePlace* places = nullptr;       // [particles] out
};

// Increments of at most so many particles: midpoint strain, engineering shear, and the rotation Q, row-major, before
// it.
struct alignas(64) Increments {
    static constexpr int capacity = 64;
    double strain[6][capacity];
    double rotation[9][capacity];
};

struct GatherCall {
    GridView grid;
    ParticleView particles;
    std::ptrdiff_t begin, end;  // no more than Increments::capacity
    const NodeMotion* nodes;
    double dt;   // [s]
    double pic;  // PIC share of this step [-]
    Separation separation = {};
    CellMean mean = {};        // with cells, deformation stops there
    bool fixed_point = false;  // of the sums
    PoreStrains pores = {};
};

// The rest of deformation, where the mean is over cells.
struct DeformCall {
    ParticleView particles;
    std::ptrdiff_t begin, end;  // no more than Increments::capacity
    const CellIntegers* cells;
    const Deferred* deferred;  // [particles]
    Separation separation;
};

struct GatherSums {
    Total kept;                  // 1/2 m (S dv)^2: what FLIP keeps of the nodes' 1/2 m dv^2 [J]
    Total pic_loss;              // kinetic energy that the PIC share takes [J]
    Total body_work;             // of the body acceleration [J]
    double most_v2 = 0.0;        // largest v^2 [m2/s2]
    double farthest[2] = {};     // longest way along y and z [m]
    std::ptrdiff_t outside = 0;  // particles that are now outside of the grid
};

// The kernels of one instruction set: bitwise the same results, for nothing is contracted. Shapes: cpdi, ugimp, point.
struct Kernels {
    void (*scatter)(Shape, const ScatterCall&);
    void (*gather)(Shape, const GatherCall&, Increments&, GatherSums&);
    void (*deform)(const DeformCall&, Increments&);
    // Returns the largest mean stress [Pa].
    double (*add_mean_stresses)(const MeanStressCall&);
};

// The best that this processor has, and those of any.
const Kernels& kernels();
extern const Kernels baseline_kernels;

}  // namespace grit::mpm::space
