// SPDX-License-Identifier: BSD-3-Clause
// A run described by plain data: SI units, compression negative, z upwards.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <grit/contact.h>
#include <grit/sand.h>

#include "adapters/mpm/case/profile.hpp"
#include "adapters/mpm/case/space_plan.hpp"
#include "adapters/mpm/case/time_function.hpp"
#include "adapters/mpm/grid/graded_axis.hpp"
#include "adapters/mpm/step/absorbing.hpp"
#include "adapters/mpm/step/penalty_pair.hpp"
#include "adapters/mpm/step/settings.hpp"
#include "adapters/mpm/step/traction.hpp"

namespace grit::mpm {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

// A polygon; its corners may go round either way. A box is one of four corners.
struct Outline {
    std::vector<Vector2> corners;          // [m]
    int particles_r = 0, particles_z = 0;  // per cell along r and z; 0: as many as in the body
};

struct ElasticPlan {
    double youngs_modulus, poissons_ratio;  // [Pa], [-]
    bool neo_hooke = false;
};

// Moves as a table says.
struct RigidPlan {
    TimeTable velocity_r, velocity_z;  // in space r is x [m/s]
    std::string from_stage = {};       // at rest before, and time counts from there; empty: always
    // In space: along y, and about x, y and z through the centre, which is that of mass if none is given; and which of
    // the motions along and about x, y and z are left to weight, loads and contact.
    TimeTable velocity_y = {{0.0}, {0.0}};                                 // [m/s]
    TimeTable spin[3] = {{{0.0}, {0.0}}, {{0.0}, {0.0}}, {{0.0}, {0.0}}};  // [rad/s]
    std::optional<Vector3> centre = {};                                    // [m]
    std::array<bool, 6> free = {};
    bool any_free() const {
        return std::any_of(free.begin(), free.end(), [](bool x) { return x; });
    }
};

struct SandPlan {
    grit_sand_parameters parameters;  // Pa
    grit_sand_options options;
    double void_ratio;              // e, or e_0 ...
    bool at_zero_pressure = false;  // ... (H6)
    // |h|/R along a strain direction rr zz tt rz, in space xx yy zz xy xz yz.
    double intergranular_rho = 0.0;
    double intergranular_direction[6] = {0.0, -1.0, 0.0, 0.0, 0.0, 0.0};
};

using MaterialPlan = std::variant<ElasticPlan, RigidPlan, SandPlan>;

// Vertical stress of the weight above, the horizontal ones K0 times that.
struct Geostatic {
    double surface = 0.0;           // level [m]
    double surcharge = 0.0;         // [Pa], presses
    std::optional<double> K0 = {};  // sand: 1 - sin phi_c, elastic: nu / (1 - nu)
};

enum class Drainage {
    undrained,  // (W1)
    flow        // (W2)
};

// Water that fills the pores.
struct WaterPlan {
    Drainage drainage = Drainage::undrained;
    double bulk_modulus = 2.2e9, density = 1000.0, largest_tension = 1e5;  // [Pa], [kg/m3]
    double grain_density = 0.0;                                            // of the body [kg/m3]
    double porosity = 0.0;      // at the start, of elastic bodies; sand has its void ratio
    double conductivity = 0.0;  // of flow [m/s]
    bool kozeny_carman = false;
    double conductivity_at = 0.0;      // void ratio of the law; 0: that of the start
    bool implicit = false;             // its pressure
    std::optional<double> table = {};  // level of p_w = 0 at the start [m]; none: p_w = 0
};

struct BodyPlan {
    std::string name;
    std::vector<Outline> outlines;
    int particles_r = 2, particles_z = 2;  // per cell along r and z
    double density;                        // [kg/m3]
    MaterialPlan material;
    std::optional<Geostatic> geostatic = {};
    std::optional<WaterPlan> water = {};
    Vector2 velocity{0.0, 0.0};  // at the start [m/s]
    bool rigid() const { return std::holds_alternative<RigidPlan>(material); }
    // It has no mass that counts: nothing but its tables moves it.
    bool prescribed() const { return rigid() && !std::get<RigidPlan>(material).any_free(); }
};

// Sides of the grid.
enum class Side { left, right, bottom, top };
struct TractionPlan {
    std::string body;
    Edge edge = Edge::top;
    double r[2] = {-unlimited, unlimited}, z[2] = {-unlimited, unlimited};  // of centres [m]
    Vector2 direction{0.0, -1.0};                                           // unit
    TimeFunction stress = TimeTable{{0.0}, {0.0}};                          // [Pa]
    bool on_mixture = false;  // grains and water by their shares of the volume, or the grains alone
    std::string from_stage = {};  // nothing before, and time counts from there; empty: always
};

// Water that a side of the grid lets into all bodies with water that flows.
struct InflowPlan {
    Side side = Side::left;
    TimeTable speed;              // n (v_w - v_s) across, into the grid [m/s]
    std::string from_stage = {};  // nothing before, and time counts from there; empty: always
};

// Penalty contact: the lines that may touch, with their bodies on the left.
struct PenaltyPlan {
    double modulus;                   // P-wave modulus of the softer body [Pa]
    double stiffness_multiple = 1.0;  // of modulus / shortest cell
    BoundaryLine stiff_line, soft_line;
};

struct ContactPlan {
    std::string stiff, soft;  // bodies
    int law = 0;              // GRIT_CONTACT_...
    double friction_coefficient = 0.0, penalty_power = GRIT_CONTACT_DEFAULT_PENALTY_POWER;
    int normal = 0, measure = 0;  // GRIT_CONTACT_...
    bool gated = true;
    double relaxation_time = 0.0;  // of the Geo-contact [s], 0: a step; of a surface's stiffness
    // Of modulus / shortest cell against overlap, 0: none; P-wave modulus of the softer body [Pa].
    double contact_stiffness_multiple = 0.0, modulus = unlimited;
    std::optional<PenaltyPlan> penalty = {};  // in place of a nodal law
    bool at_surfaces = false;                 // in place of a nodal law ...
    BoundaryLine surface_line = {};  // ... along this line of the stiff body; empty: its free edges
    std::shared_ptr<const ClosedSurface> surface_mesh = {};  // ... in space, along this one
    double pressure_spacing = 2.0;                           // of that: [cells]
    double sweep_tolerance = 1e-6;                           // of that: of its largest approach
    bool after_damping = false;  // of that: once more, on what local damping has changed
};

// What ends a stage: whichever comes first.
struct StageEnd {
    double time = unlimited;   // since it began [s]
    double depth = unlimited;  // of the driven body since it began [m]
    // Intervals of pulses that are over since it began, of the train that begins with the stage, else of
    // the one that began last. 0: any number.
    int blows = 0;
    // At rest: both shares at once, see Measures. 0: never.
    double unbalanced_share = 0.0, kinetic_share = 0.0;
};

struct StagePlan {
    std::string name = {};
    bool gravity = true;
    double local_damping = 0.0, pic_rate = 0.0, cfl = 0.4;  // as in Settings
    StageEnd end = {};

    template <class Self, class Archive> static void visit(Self& stage, Archive& archive) {
        archive.list(stage.name);
        archive.value(stage.gravity);
        for (auto* number : {&stage.local_damping, &stage.pic_rate, &stage.cfl})
            archive.value(*number);
        archive.value(stage.end);
    }
};

enum class DepthOf { lowest_point, centre_of_mass };

struct HistoryPlan {
    std::string body;  // the driven one
    DepthOf depth_of = DepthOf::lowest_point;
    double interval = 0.0;     // between rows [s]; 0: every step
    ProfilePlan profile = {};  // in space
};

struct Case {
    std::string name, title;
    AxisPlan r, z;
    Settings settings;             // stages override what they name
    double gravity = 9.81;         // downwards [m/s2]
    double residual_limit = 0.05;  // share of the energy turned over
    Boundary boundary[4] = {};     // by Side
    bool drained[4] = {};          // by Side: water may leave
    std::optional<double> platen_level[4] =
        {};                // by Side: of platens, at the start; none: the side [m]
    WaveSpeeds absorbing;  // of sides that are
    std::vector<BodyPlan> bodies;
    std::vector<TractionPlan> tractions;
    std::vector<InflowPlan> inflows;
    std::vector<ContactPlan> contacts;
    std::vector<StagePlan> stages;
    HistoryPlan history;
    // In space, the place of what lies in the plane: of r, z, boundary, outlines, velocities and edges.
    std::optional<SpacePlan> space = {};

    // Is any side of this kind?
    bool has_side(Boundary kind) const;
    // Throws std::invalid_argument for a name that is not there.
    std::size_t body(const std::string& wanted) const;
    std::size_t stage(const std::string& wanted) const;
    // A stage that says nothing yet.
    StagePlan plain_stage(const std::string& name) const;
};

}  // namespace grit::mpm
