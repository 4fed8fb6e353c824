// SPDX-License-Identifier: BSD-3-Clause
// Water in the pores of a body (W1, W2): it moves with the grains, or through them. Grains do not change their
// volume. Stresses of the columns S are effective, the total ones are S - p_w 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "adapters/mpm/kernel/material.hpp"
#include "adapters/mpm/kernel/nodes.hpp"

namespace grit::mpm {

// Of water, whose weight conductivities are measured with [m/s2].
inline constexpr double standard_gravity = 9.81;

// Lanes of a node's record of water.
namespace water_record {
enum : int {
    m,  // of water that flows [kg]
    p_r,
    p_z,  // ... its momentum against the grains [kg m/s]
    f_r,
    f_z,     // of the pore pressure, on grains and water together [N]
    volume,  // of the body [m3]
    drag     // [N s/m]
};
}  // namespace water_record

struct PoreWater {
    bool flows = false;  // through the grains; the mass of particles is then that of grains alone
    bool implicit = false;         // the pressure: its waves do not limit the step
    double bulk_modulus = 2.2e9;   // K_w [Pa]
    double density = 1000.0;       // rho_w [kg/m3]
    double largest_tension = 1e5;  // beyond which it cavitates [Pa]
    double porosity = 0.0;         // at F = 1, of materials without a void ratio [-]
    double conductivity = 0.0;     // k of water that flows [m/s] ...
    double conductivity_at = 0.0;  // ... at this void ratio (Kozeny-Carman); 0: at any
    int first = 0;                 // of its columns
    int void_ratio_column = -1;    // of the material; -1: it has none
    double opening_cap =
        std::numeric_limits<double>::infinity();  // void ratio beyond which that does not open

    // Columns beside those of the material. The pressure is p_w >= -largest_tension; below, it says how
    // far a cavity must close before the water bears again. The velocity is that against the grains. The content, per
    // radian or per metre [kg], is the water that has come and gone with the flow: the balance of mass. Momentum takes
    // pores as full, of water without pressure.
    int columns() const { return flows ? 4 : 1; }
    GRIT_INLINE int velocity_column() const { return first + 1; }
    GRIT_INLINE int content_column() const { return first + 3; }
    std::vector<const char*> column_names() const {
        return flows ? std::vector<const char*>{"p_w", "w_r", "w_z", "m_w"}
                     : std::vector<const char*>{"p_w"};
    }
    // Its law and each of its numbers, exactly.
    std::vector<std::string> words() const;

    // Views: of the plane or of space.
    template <class View> GRIT_INLINE double void_ratio(const View& q, std::ptrdiff_t p) const {
        return void_ratio_column >= 0 ? q[void_ratio_column][p] : q.J(p) / (1.0 - porosity) - 1.0;
    }
    static GRIT_INLINE double porosity_of(double e) { return e / (1.0 + e); }
    // K_w/n [Pa].
    GRIT_INLINE double stiffness(double e) const { return bulk_modulus * (1.0 + e) / e; }
    // Does a node with this record of water that flows have any, in pores of a body? In fixed point a few quanta say
    // nothing of a porosity.
    bool is_at(const NodeRecord& w) const {
        return w[water_record::m] > 0.0 && w[water_record::m] < density * w[water_record::volume];
    }
    // There.
    double porosity_at(const NodeRecord& w) const {
        return w[water_record::m] / (density * w[water_record::volume]);
    }
    // What bears of the column p_w, compression positive [Pa].
    GRIT_INLINE double bearing(double p_w) const {
        return p_w > -largest_tension ? p_w : -largest_tension;
    }
    template <class View> GRIT_INLINE double pressure(const View& q, std::ptrdiff_t p) const {
        return bearing(q[first][p]);
    }
    // (W1) after a strain of its cell, of water that does not flow: the strain is that of the pores too, whose middle is taken.
    GRIT_INLINE double middle_of(double e, double strain) const {
        return flows ? e : e + 0.5 * (1.0 + e) * strain;
    }
    // The column p_w after a strain from this void ratio on, with the stiffness of its middle.
    GRIT_INLINE double strained(double p_w, double e, double e_middle, double strain) const {
        if (keeps_cavity(e, p_w) && strain > 0.0) return p_w;
        return p_w - stiffness(e_middle) * strain;
    }
    // That fills pores of a volume [kg].
    GRIT_INLINE double mass_of(double e, double V) const { return porosity_of(e) * density * V; }
    // ... of a particle, per radian or per metre.
    GRIT_INLINE double mass(const ParticleView& q, std::ptrdiff_t p) const {
        return mass_of(void_ratio(q, p), q[column::V0][p] * q.J(p));
    }
    // Of the seepage [m/s]: Kozeny (1927), Carman (1937), k ~ e^3/(1 + e).
    GRIT_INLINE double conductivity_of(double e) const {
        if (!(conductivity_at > 0.0)) return conductivity;
        const double share = e / conductivity_at;
        return conductivity * share * share * share * ((1.0 + conductivity_at) / (1.0 + e));
    }
    // Pores that have opened to the cap stay as they are, and what is cavitated in them.
    GRIT_INLINE bool keeps_cavity(double e, double p_w) const {
        return e >= opening_cap && p_w <= -largest_tension;
    }
    // n^2 rho_w g/k: force on a volume for a velocity against the grains [N s/m4].
    GRIT_INLINE double drag(double e) const {
        const double largest = density * standard_gravity / conductivity, n = porosity_of(e);
        if (!(conductivity_at > 0.0)) return largest * n * n;
        const double cube = conductivity_at * conductivity_at * conductivity_at;
        return largest * (cube / (1.0 + conductivity_at)) / (e * (1.0 + e));
    }
    // Of water that flows; that of the grains is not in it [J].
    double kinetic_energy(const ParticleView& q, std::ptrdiff_t p) const {
        return flows ? 0.5 * mass(q, p) * speed_squared(q, p) : 0.0;
    }
    // The square of the velocity of water that flows [m2/s2].
    double speed_squared(const ParticleView& q, std::ptrdiff_t p) const {
        const double v_r = q[column::v_r][p] + q[velocity_column()][p];
        const double v_z = q[column::v_z][p] + q[velocity_column() + 1][p];
        return v_r * v_r + v_z * v_z;
    }
    // What it adds to M/rho, the square of the speed of waves of a skeleton whose particle has this mass by
    // volume (W3): an upper bound, c_1^2 + c_2^2, of water that flows; nothing where its pressure is implicit.
    double speed2(double e, double skeleton_density) const {
        if (implicit) return 0.0;
        const double n = porosity_of(e);
        if (!flows) return bulk_modulus / (n * skeleton_density);
        return (1.0 - n) * (1.0 - n) * bulk_modulus / (n * skeleton_density) +
               bulk_modulus / density;
    }
};

// Of a cell's integers, as close as they are; what is no number stays out.
GRIT_INLINE std::int64_t cell_share_rounded(double x) {
    return x > -1.0 && x < 1.0
               ? static_cast<std::int64_t>(x * CellIntegers::scale + (x < 0.0 ? -0.5 : 0.5))
               : 0;
}

// A particle to its cell: its volume, as a share of the reference, and what the cell averages, less than eight.
GRIT_INLINE void add_share(CellIntegers& cell, double volume, double x) {
    cell.volume += cell_share_rounded(0.125 * volume);
    cell.weighted += cell_share_rounded(0.125 * volume * x);
}

// To multiples of a power of two, such that sums of fewer than 2^room numbers up to a largest one are exact, in any order.
struct Rounding {
    double magic = 0.0;  // 0: none
    static Rounding of_sums(double largest, int room) {
        if (!(largest > 0.0 && largest < std::numeric_limits<double>::infinity())) return {};
        return {std::ldexp(1.5, std::ilogb(largest) + 1 + room)};
    }
    GRIT_INLINE double operator()(double x) const { return (x + magic) - magic; }
};

// What the particles of a cell leave at the 4 by 4 nodes around it, the first of them a row and a column before the cell,
// for a pressure of 1 Pa: the force (r, z of each node) [m2]. Its product with velocities is the rate of the cell's volume.
struct alignas(64) CellPatch {
    double force[32];
};

// Of a cell, beside what its pressure or strain is averaged from: what left it, as a share of volume, times volume.
struct WaterCell : CellIntegers {
    std::int64_t left;
};

// How the volume velocity (1 - n) v_s + n v_w of a node answers an impulse of the pressure [1/kg]: symmetric.
struct NodeAnswer {
    double rr, rz, zz;
    GRIT_INLINE Vector2 operator()(const Vector2& f) const {
        return {rr * f[0] + rz * f[1], rz * f[0] + zz * f[1]};
    }
};

// Cells by the patch each has and the first of its nodes, in arrays of nodes with rows of this length.
struct PatchedCell {
    std::size_t patch, first;
};
struct PatchCall {
    const CellPatch* patches;
    const PatchedCell* cells;
    std::size_t count, row;
    Rounding rounding = {};  // of what is added to a node
};

// In the mirror r -> -r, besides the material.
void reflect(const PoreWater& water, const ParticleView& particles, std::ptrdiff_t p);

// Sums over a strip of particles or nodes, of a step.
struct WaterSums {
    Total work;          // taken by the water's compression [J]
    Total half;          // of that, by the pressure of the end in half a step [J]
    Total drag;          // taken by drag, at nodes and within particles [J]
    Total pic_loss;      // ... by the PIC share [J]
    Total between;       // ... by what flows between cells and no node shows [J]
    Total carried;       // kinetic energy of water that left pores, less of what came into them [J]
    Total gravity_work;  // [J]
    Total side_work;     // of sides that water comes in by [J]
    Total change;        // as those of NodeSums and GatherSums, of water that flows, and ...
    Total mapped_away;
    Total kept;  // ... what it has of the grains' velocity times what it changes by [J]
};

// What a scatter leaves of water, beside the grains.
struct WaterScatter {
    const PoreWater* water;
    const WaterCell* cells;               // mean pressures, of add_pressures
    NodeRecord* nodes;                    // added to
    FixedPoint* fixed_point = nullptr;    // in place of nodes, if the grains are
    CellPatch* patches = nullptr;         // added to, of implicit pressure ...
    FixedPoint* fixed_patches = nullptr;  // ... in their place: four records a cell, its rows
};

// A particle before a gather: its pressure waits for the strain of its cell.
struct WaterPlace {
    double V, e;  // [m3], void ratio
    int cell;
};

// What a gather takes of water, beside that of the grains.
struct WaterGather {
    const PoreWater* water;
    // As nodes have it: its divergence takes pressure and water; of undrained bodies the grains'.
    const NodeMotion* volume;
    const NodeMotion* flowing;  // of water that flows: v and other
    WaterCell* cells;           // volumetric strains and what left, added to
    WaterPlace* places;         // [particles] out
    double per_volume;
    WaterSums* sums;
};

// The mean pressures of cells, as shares of K_w.
void add_pressures(const GridView& grid, const ParticleView& particles, std::ptrdiff_t begin,
                   std::ptrdiff_t end, const PoreWater& water, double per_volume, WaterCell* cells);
// A cell with an implicit pressure, after a step.
struct ImplicitCell {
    double left = 0.0;  // beside what nodes show [m3]
    // Mean that bore before it, of particles that do not keep a cavity [Pa]; K_w/n, mean of all [Pa]; the share of the way to that
    // pressure that those go whose K_w/n is the mean.
    double pressure = 0.0, stiffness = 1.0, together = 0.0;
};
// (W1), (W2) of a range, after a gather: each particle with the mean strain of its cell and its share of what else left that;
// implicit: null where the pressure is explicit. Returns what water adds to the square of the speed of waves, at the most [m2/s2].
double update_pressures(const ParticleView& particles, std::ptrdiff_t begin, std::ptrdiff_t end,
                        const PoreWater& water, const WaterCell* cells, const WaterPlace* places,
                        double per_volume, const ImplicitCell* implicit, bool fixed_point,
                        WaterSums& sums);

struct WaterNodeCall {
    NodeCall grains;      // of the body
    NodeRecord* records;  // ... which get the force of the pore pressure
    const PoreWater* water;
    const NodeRecord* water_records;
    NodeMotion* flowing;  // of the water: v and other, the velocity before the step's forces
    // (1 - n) v_s + n v_w and n (v_w - v_s); between drag and close in place of the latter the impulse of drag on the
    // grains [N s].
    NodeMotion* volume;
    const std::uint8_t*
        closed;  // bits of components that are held, some of those that are fixed ...
    const std::uint8_t* drained;  // ... but for these
    const Vector2* poured;        // filter velocity where neither is free [m/s]; null: none

    double porosity(std::ptrdiff_t i) const { return water->porosity_at(water_records[i]); }
};

// Motions and volume are those of the step before. The grains' share of the pressure's force goes to their
// records; flowing becomes v = v_old + dt (f/m + g).
void push_water(const WaterNodeCall& call, WaterSums& sums);
// Drag (W2), implicit: of grains and water as they are after the forces.
void drag_water(const WaterNodeCall& call);
// Once the grains have their velocity: volume, and the energies of water.
void close_water(const WaterNodeCall& call, WaterSums& sums);

}  // namespace grit::mpm
