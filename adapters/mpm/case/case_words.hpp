// SPDX-License-Identifier: BSD-3-Clause
// The words of a case: what its keys are called, may say and mean. The readers of case files and of fix
// grit/mpm, the writer of scripts for LAMMPS and the tables of the documentation all look here.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "adapters/mpm/case/case.hpp"
#include "adapters/mpm/case/spellings.hpp"

namespace grit::mpm {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

struct Interval {
    double low = -infinite, high = infinite;
    bool open = false;  // without its ends

    // NaN is in none.
    constexpr bool has(double x) const {
        return open ? x > low && x < high : x >= low && x <= high;
    }
    constexpr bool is_all() const { return low == -infinite && high == infinite; }
    std::string text() const;  // "> 0", "in [0, 1]"
};

enum class Kind { number, integer, yes_or_no, choice, numbers, text, texts, table };

// A key of a case file.
struct CaseWord {
    std::string_view section;  // the tables around it, "stage.until"; empty: none
    std::string_view key;      // with the unit, as it is written
    const char* text;          // what it means
    Kind kind = Kind::number;
    const char* unit = "";
    double si = 1.0;       // that unit in SI units
    Interval range = {};   // in that unit
    Spellings words = {};  // of a choice
    // If it is not given; empty: a plan's own value, or it must be there.
    const char* otherwise = "";

    // A number in SI units.
    constexpr Interval si_range() const { return {range.low * si, range.high * si, range.open}; }
    // ... of one whose otherwise is a number.
    double otherwise_number() const;
};

namespace words {

inline constexpr Interval anything;
inline constexpr Interval above_zero{0.0, infinite, true};
inline constexpr Interval density_range{1e-3, 1e9};  // [kg/m3]
// Of cfl: above 1/sqrt(2) waves along both directions at once grow.
inline constexpr Interval damping_range{0.0, 0.95}, pic_range{0.0, 1e5}, cfl_range{1e-3, 0.7},
    share_range{0.0, 1.0}, many{1, 1000000}, time_range{0.0, 1e9}, per_cell{1, 16};

// A unit of keys, in SI units.
struct Unit {
    const char* name;
    double si;
};
inline constexpr Unit none{"", 1.0}, metre{"m", 1.0}, second{"s", 1.0}, per_second{"1/s", 1.0},
    metre_per_second{"m/s", 1.0}, radian_per_second{"rad/s", 1.0}, metre_per_second_2{"m/s²", 1.0},
    kg_per_m3{"kg/m³", 1.0}, kilopascal{"kPa", 1e3};

constexpr CaseWord number(std::string_view section, std::string_view key, Interval range, Unit unit,
                          const char* text, const char* otherwise = "") {
    return {section, key, text, Kind::number, unit.name, unit.si, range, {}, otherwise};
}
constexpr CaseWord integer(std::string_view section, std::string_view key, Interval range,
                           const char* text, const char* otherwise = "") {
    return {section, key, text, Kind::integer, "", 1.0, range, {}, otherwise};
}
constexpr CaseWord yes_or_no(std::string_view section, std::string_view key, const char* text) {
    return {section, key, text, Kind::yes_or_no};
}
constexpr CaseWord choice(std::string_view section, std::string_view key, Spellings words,
                          const char* text, const char* otherwise = "") {
    return {section, key, text, Kind::choice, "", 1.0, {}, words, otherwise};
}
constexpr CaseWord numbers(std::string_view section, std::string_view key, Unit unit,
                           const char* text, const char* otherwise = "") {
    return {section, key, text, Kind::numbers, unit.name, unit.si, {}, {}, otherwise};
}
constexpr CaseWord a_text(std::string_view section, std::string_view key, const char* text,
                          const char* otherwise = "") {
    return {section, key, text, Kind::text, "", 1.0, {}, {}, otherwise};
}
constexpr CaseWord a_table(std::string_view section, std::string_view key, const char* text,
                           const char* otherwise = "") {
    return {section, key, text, Kind::table, "", 1.0, {}, {}, otherwise};
}
constexpr CaseWord texts(std::string_view section, std::string_view key, const char* text,
                         const char* otherwise) {
    return {section, key, text, Kind::texts, "", 1.0, {}, {}, otherwise};
}

inline constexpr CaseWord all[] = {
    a_text("", "name", "of the files written", "the name of the file"),
    a_text("", "title", "for people", "the name"),
    number("", "gravity_m_per_s2", {0.0, 1e6}, metre_per_second_2, "downwards"),

    choice("grid", "geometry", geometries, ""),
    number("grid", "r_from_m", anything, metre, "begin of the grid", "0"),
    number("grid", "z_from_m", anything, metre, "begin of the grid", "0"),
    number("grid", "x_from_m", anything, metre, "in space", "0"),
    number("grid", "y_from_m", anything, metre, "in space", "0"),
    a_table("grid", "r", "segments, one after the other"),
    a_table("grid", "z", "... along z"),
    a_table("grid", "x", "in space: along x, in the place of r", "in the plane none"),
    a_table("grid", "y", "in space: along y", "in the plane none"),

    number("grid.r", "to_m", anything, metre, "end of the segment"),
    integer("grid.r", "cells", {1, 100000}, "in the segment", "by `cell_m`"),
    number("grid.r", "cell_m", above_zero, metre, "about the smallest cell", "by `cells`"),
    number("grid.r", "growth", {0.5, 2.0}, none, "length of a cell / length of the one before",
           "1"),

    choice("boundary", "left", boundaries, "a side of the grid; the axis is a roller", "`free`"),
    choice("boundary", "right", boundaries, "", "`free`"),
    choice("boundary", "bottom", boundaries, "", "`free`"),
    choice("boundary", "top", boundaries, "", "`free`"),
    choice("boundary", "front", boundaries,
           "in space: where y begins; left and right are then across x", "`free`"),
    choice("boundary", "back", boundaries, "in space: where y ends", "`free`"),
    texts("boundary", "drained",
          "sides that pore water leaves freely, at no pressure; a free surface of a body always is",
          "none"),
    a_table(
        "boundary", "platen_level",
        "`{ top_m = 0.5 }`: of sides that are platens, where these begin: nodes there and beyond "
        "move as one across",
        "the side"),
    number("boundary", "p_wave_m_per_s", above_zero, metre_per_second,
           "of absorbing sides: they press with density times this speed times the velocity across",
           "needed by absorbing sides"),
    number("boundary", "s_wave_m_per_s", above_zero, metre_per_second,
           "... and drag with this one times that along", "needed by absorbing sides"),

    choice("numerics", "shape_function", shapes, ""),
    choice("numerics", "scheme", schemes, ""),
    number("numerics", "cfl", cfl_range, none,
           "share of the shortest cell that a wave may cross in a step"),
    number("numerics", "pic_rate_per_s", pic_range, per_second,
           "1 − FLIP = rate Δt; particles take an implicit pore pressure of their cell at this "
           "rate, beside cavities by half of the way in each step"),
    number("numerics", "local_damping", damping_range, none,
           "share of the nodal force, against the motion"),
    number("numerics", "largest_step_s", above_zero, second, "", "none"),
    number("numerics", "bulk_viscosity_linear", {0.0, 10.0}, none,
           "in compression: ρ l (linear c ε̇ + quadratic l ε̇²), l the shorter edge of the cell"),
    number("numerics", "bulk_viscosity_quadratic", {0.0, 10.0}, none, ""),
    yes_or_no("numerics", "cell_averaged_volume",
              "volumetric strain of a step as the mean of a cell"),
    yes_or_no("numerics", "reduced_domains",
              "of sand: where shear draws a domain out, a compact one that tiles as it did"),
    yes_or_no("numerics", "fixed_point",
              "nodal sums in integers: no order and no processes change a bit"),
    integer("numerics", "threads", {1, 1024}, "of a process; change no result"),
    number("numerics", "energy_residual_limit", {1e-6, 1e6}, none,
           "of the energy turned over: beyond, the run is stopped, as where a loss is a gain of "
           "that share"),

    a_text("body", "name", "letters, digits, _ and -"),
    integer("body", "particles_per_cell_r", per_cell, "fewer where a body ends within a cell", "2"),
    integer("body", "particles_per_cell_z", per_cell, "", "2"),
    integer("body", "particles_per_cell_x", per_cell, "in space", "2"),
    integer("body", "particles_per_cell_y", per_cell, "in space", "2"),
    number("body", "density_kg_per_m3", density_range, kg_per_m3, "",
           "needed but for rigid bodies"),
    number("body", "grain_density_kg_per_m3", density_range, kg_per_m3,
           "dry sand with a constant void_ratio, and all bodies with water",
           "by `density_kg_per_m3`"),
    numbers("body", "velocity_m_per_s", metre_per_second,
            "at the start, along r and z, in space along x, y and z", "0"),
    a_table("body", "box", "any number of boxes ...", "by `polygon`"),
    a_table("body", "polygon", "... and polygons; the first one has what they share", "by `box`"),
    a_table("body", "cylinder", "in space: any number of upright ones, besides boxes", "others"),
    a_table("body", "cone", "in space: upright", "others"),
    a_table("body", "sphere", "in space", "others"),
    a_table("body", "surface", "in space: what a closed surface of triangles encloses", "others"),
    texts("body", "outside_of", "in space: bodies before it, whose shapes it leaves out", "none"),
    a_table("body", "elastic", "a material: linear", "another one"),
    a_table("body", "neo_hooke", "a material, with the keys of `elastic`", "another one"),
    a_table("body", "rigid", "a material that moves as a table says", "another one"),
    a_table("body", "sand", "a material", "another one"),
    a_table("body", "stress_at_rest", "of sand and linear elastic bodies; with water effective",
            "no stress"),
    a_table("body", "water", "in the pores, all of which it fills", "none"),

    numbers("body.box", "r_m", metre, "of a box from, to; of a polygon its corners, in order"),
    numbers("body.box", "z_m", metre, "... along z; a particle is inside if its centre is"),
    integer("body.box", "particles_per_cell_r", per_cell, "of this one alone", "as in the body"),
    integer("body.box", "particles_per_cell_z", per_cell, "", "as in the body"),
    integer("body.box", "particles_per_cell_x", per_cell, "in space, of any shape",
            "as in the body"),
    integer("body.box", "particles_per_cell_y", per_cell, "in space, of any shape",
            "as in the body"),

    numbers("body.box", "x_m", metre, "in space: from, to", "in the plane none"),
    numbers("body.box", "y_m", metre, "in space", "in the plane none"),

    numbers("body.cylinder", "centre_m", metre, "x and y of its axis"),
    number("body.cylinder", "radius_m", above_zero, metre, "what lies beyond the grid is cut off"),
    numbers("body.cylinder", "z_m", metre, "from, to"),

    numbers("body.cone", "centre_m", metre, "x and y of its axis"),
    numbers("body.cone", "radii_m", metre, "at its lower and at its upper end"),
    numbers("body.cone", "z_m", metre, "from, to"),

    numbers("body.sphere", "centre_m", metre, "x, y and z"),
    number("body.sphere", "radius_m", above_zero, metre, ""),

    a_text("body.surface", "file", "an STL file, binary or text; beside the case"),
    number("body.surface", "unit_m", above_zero, metre, "of its numbers", "1"),
    numbers("body.surface", "offset_m", metre, "x, y and z that are added", "0"),

    number("body.elastic", "youngs_modulus_kPa", above_zero, kilopascal, ""),
    number("body.elastic", "poissons_ratio", {-1.0, 0.5, true}, none, ""),

    numbers("body.rigid", "time_s", second, "of the velocities, which are linear between",
            "0: one value, constant"),
    numbers("body.rigid", "velocity_r_m_per_s", metre_per_second, "", "0"),
    numbers("body.rigid", "velocity_z_m_per_s", metre_per_second, "", "0"),
    numbers("body.rigid", "velocity_x_m_per_s", metre_per_second, "in space", "0"),
    numbers("body.rigid", "velocity_y_m_per_s", metre_per_second, "in space", "0"),
    numbers("body.rigid", "angular_velocity_x_rad_per_s", radian_per_second,
            "in space, about the centre", "0"),
    numbers("body.rigid", "angular_velocity_y_rad_per_s", radian_per_second, "in space", "0"),
    numbers("body.rigid", "angular_velocity_z_rad_per_s", radian_per_second, "in space", "0"),
    numbers("body.rigid", "centre_m", metre, "in space, x, y and z", "of mass"),
    texts("body.rigid", "free",
          "in space: motions that weight, loads and contact decide, of x, y, z, about_x, about_y, "
          "about_z",
          "none"),
    a_text("body.rigid", "from_stage", "at rest before, time counts from its begin", "the run's"),

    a_text("body.sand", "name",
           "of `grit sand list`; parameters given besides override those of the sand, with the "
           "names of element tests",
           "all parameters are needed"),
    number("body.sand", "void_ratio", above_zero, none, "e", "by `void_ratio_at_zero_pressure`"),
    number("body.sand", "void_ratio_at_zero_pressure", above_zero, none, "e₀ exp(−(3p/h_s)ⁿ)",
           "by `void_ratio`"),
    choice("body.sand", "intergranular_strain", intergranular_starts, "",
           "`mobilised` if the sand has parameters for it"),
    numbers("body.sand", "intergranular_direction", none,
            "of h if mobilised: rr zz tt rz, in space xx yy zz xy xz yz", "vertical compression"),
    number("body.sand", "tolerance", {GRIT_SAND_LEAST_TOLERANCE, GRIT_SAND_LARGEST_TOLERANCE}, none,
           "of an update, relative", "0.001"),

    choice("body.water", "drainage", drainages, "in space undrained alone", "`undrained`"),
    choice("body.water", "pressure", pore_pressures, "in space explicit alone", "`explicit`"),
    number("body.water", "porosity", {0.01, 0.99}, none, "at the start", "needed but for sand"),
    number("body.water", "bulk_modulus_kPa", {1e-3, 1e9}, kilopascal, "K_w", "2200000"),
    number("body.water", "density_kg_per_m3", density_range, kg_per_m3, "", "1000"),
    number("body.water", "cavitation_kPa", {0.0, 1e6}, kilopascal, "largest tension", "100"),
    number("body.water", "water_table_m", anything, metre,
           "level of no pore pressure at the start, hydrostatic below and above",
           "no pore pressure"),
    number("body.water", "conductivity_m_per_s", above_zero, metre_per_second, "k of flow",
           "needed by flow"),
    choice("body.water", "conductivity_law", conductivity_laws, "", "`constant`"),

    number("body.stress_at_rest", "surface_m", anything, metre, "level of no overburden ..."),
    number("body.stress_at_rest", "surcharge_kPa", time_range, kilopascal, "... but this", "0"),
    number("body.stress_at_rest", "K0", {0.0, 10.0}, none, "",
           "sand 1 − sin φ_c, elastic ν/(1 − ν)"),

    a_text("traction", "body", "whose outermost edges of particles are loaded"),
    choice("traction", "edge", edges,
           "of the undeformed particle; in space a face, `front` and `back` too"),
    numbers("traction", "r_m", metre, "where the centres of its particles are", "anywhere"),
    numbers("traction", "z_m", metre, "", "anywhere"),
    numbers("traction", "x_m", metre, "in space", "anywhere"),
    numbers("traction", "y_m", metre, "in space", "anywhere"),
    numbers("traction", "direction", none, "", "against the edge's outward normal"),
    choice("traction", "acts_on", load_bearers, "of a body with pore water", "`grains`"),
    a_text("traction", "from_stage", "no load before, time counts from its begin", "the run's"),
    numbers("traction", "stress_kPa", kilopascal,
            "presses where it is positive; linear between its times", "by `pulses`"),
    numbers("traction", "time_s", second, "of the stresses", "0: one value, constant"),
    a_table("traction", "pulses", "", "by `stress_kPa`"),

    choice("inflow", "side", sides, "of the grid, roller or fixed: water comes in across it"),
    numbers("inflow", "speed_m_per_s", metre_per_second,
            "its volume by area and time, negative out; linear between its times"),
    numbers("inflow", "time_s", second, "of the speeds", "0: one value, constant"),
    a_text("inflow", "from_stage", "none before, time counts from its begin", "the run's"),

    number("traction.pulses", "peak_kPa", anything, kilopascal, ""),
    choice("traction.pulses", "form", pulse_forms, "", "`half_sine`"),
    number("traction.pulses", "duration_s", above_zero, second, ""),
    number("traction.pulses", "peak_time_s", above_zero, second, "of a triangle",
           "half of the duration"),
    number("traction.pulses", "interval_s", above_zero, second, "from begin to begin",
           "the duration"),
    integer("traction.pulses", "count", many, "", "1"),
    number("traction.pulses", "start_s", time_range, second, "of the first pulse", "0"),

    a_text("contact", "stiff", "the body whose surface and gradient decide"),
    a_text("contact", "soft", "the other body"),
    choice("contact", "law", contact_laws, ""),
    number("contact", "friction_coefficient", {0.0, 100.0}, none, ""),
    number("contact", "penalty_power", {1e-6, 1e6}, none, "k of the geo law alone"),
    choice("contact", "normal", normals, "of whose gradient"),
    choice("contact", "distance", distances, "none if frictional and not gated"),
    yes_or_no("contact", "gated", "bodies apart are left alone"),
    number(
        "contact", "relaxation_time_s", time_range, second,
        "of geo: f_p is of this time, whatever the step; 0: of the step, as published. Of surface: "
        "within which overlap is pressed out by `contact_stiffness_multiple`"),
    number(
        "contact", "contact_stiffness_multiple", {0.0, 1e6}, none,
        "of geo, gated, and surface: a spring of that multiple of modulus / shortest cell against "
        "overlap, with f_p as the dashpot of geo; 0: none"),
    number(
        "contact", "pressure_spacing_cells", {1.0, 4.0}, none,
        "of surface: between points that know its pressure; next to ends of a smooth stretch two "
        "at least; 1 where curved surfaces meet",
        "2"),
    number("contact", "sweep_tolerance", {1e-14, 1.0}, none,
           "of surface: sweeps over its pressures end, at most 500, once one of them changes no "
           "velocity by more than this share of the largest approach",
           "1e-6"),
    yes_or_no("contact", "after_damping",
              "of surface: once more in each step, on velocities that local damping has changed"),
    number("contact", "modulus_kPa", above_zero, kilopascal, "P-wave modulus of the softer body",
           "needed by penalty and `contact_stiffness_multiple`"),
    number("contact", "stiffness_multiple", {1e-6, 1e6}, none,
           "of penalty: of modulus / shortest cell", "1"),
    a_table(
        "contact", "stiff_line",
        "of penalty and surface: with the body on its left, closed if the last point is the first",
        "needed by penalty; of surface: the free edges of particles"),
    a_table("contact", "soft_line", "of penalty", "needed by penalty"),
    a_table("contact", "stiff_surface", "of surface, in space: a closed surface of triangles",
            "the free faces of particles"),

    numbers("contact.stiff_line", "r_m", metre, ""),
    numbers("contact.stiff_line", "z_m", metre, ""),

    a_text("contact.stiff_surface", "file", "an STL file, as of `body.surface`"),
    number("contact.stiff_surface", "unit_m", above_zero, metre, "of its numbers", "1"),
    numbers("contact.stiff_surface", "offset_m", metre, "x, y and z that are added", "0"),

    a_text("stage", "name", "letters, digits, _ and -"),
    yes_or_no("stage", "gravity", ""),
    number("stage", "local_damping", damping_range, none, "as in `numerics`", "that of `numerics`"),
    number("stage", "pic_rate_per_s", pic_range, per_second, "as in `numerics`",
           "that of `numerics`"),
    number("stage", "cfl", cfl_range, none, "as in `numerics`", "that of `numerics`"),
    a_table("stage", "until", "what ends the stage, whichever comes first"),

    number("stage.until", "time_s", above_zero, second, "since the stage began", "any"),
    number("stage.until", "depth_m", above_zero, metre, "of the driven body since the stage began",
           "any"),
    integer("stage.until", "blows", many,
            "intervals of pulses that are over since the stage began: of the train that begins "
            "with the stage, else of the one that began last, which must have as many left",
            "any"),
    number("stage.until", "unbalanced_share", share_range, none,
           "at rest: largest resultant on a node / largest nodal force of its body, and ...",
           "any"),
    number("stage.until", "kinetic_share", share_range, none,
           "... kinetic energy / energy turned over", "any"),

    a_text("history", "body", "the driven body", "the first"),
    choice("history", "depth_of", depths, "", "`lowest_point`"),
    number("history", "interval_s", time_range, second, "between rows; 0: every step",
           "a thousandth of `time_s` of the first stage that has one; needed if none has"),
    numbers("history", "profile_z_m", metre,
            "in space: from and to along z; columns of what contacts do to the driven body by "
            "height",
            "none"),
    integer("history", "profile_parts", {1, 1000}, "of equal height", "10"),

    number("fields", "interval_s", time_range, second,
           "between .vtu files; 0: the start and the ends of stages alone", "0"),
    texts("fields", "variables", "see Fields", "all"),
};

}  // namespace words

// The row of a key; one that is not there does not compile.
consteval const CaseWord& case_word(std::string_view section, std::string_view key) {
    for (const CaseWord& word : words::all)
        if (word.section == section && word.key == key) return word;
    throw "no such key of a case";
}

// A key that is one member of a plan: a number, an integer, true or false (1, 0) or the value of a word.
template <class Plan> struct Member {
    const CaseWord* word;
    std::string_view
        fix;  // its word in fix grit/mpm; empty: none. Values of two with one word follow it both
    double (*get)(const Plan&);
    void (*set)(Plan&, double);
};

std::span<const Member<Case>> numerics_members();
std::span<const Member<ContactPlan>> contact_members();
// Of a contact, the laws that have a key: "geo and surface"; empty: all of them.
std::string_view laws_with(std::string_view key);
bool has_key(std::string_view law, std::string_view key);
std::span<const Member<WaterPlan>> water_members();
std::span<const Member<StagePlan>> stage_members();
std::span<const Member<StageEnd>> end_members();

// A keyword of the fix with values of its own. {section.key} stands for the words of a choice.
struct FixKeyword {
    std::string_view word;
    const char* values;
    const char* text;
};
std::span<const FixKeyword> fix_keywords();

// Tables of the documentation, Markdown: keys of case files; words of the fix, and of fix_modify.
std::string keys_of_cases();
std::string keys_of_fix();

}  // namespace grit::mpm
