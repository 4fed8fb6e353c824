// SPDX-License-Identifier: BSD-3-Clause
// The words of a case: what its keys are called, may say and mean. The readers of case files and of fix
// grit/mpm, the writer of scripts for LAMMPS and the tables of the documentation all look here.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "adapters/mpm/case.hpp"

namespace grit::mpm {

// A word of an enumeration.
struct Spelling {
    std::string_view word;
    int value;
    const char* text;
    bool in_fix = true;  // fix grit/mpm has it too
};
using Spellings = std::span<const Spelling>;

template <class Value>
constexpr Spelling spelling(const char* word, Value value, const char* text) {
    return {word, static_cast<int>(value), text};
}
constexpr Spelling only_in_files(Spelling spelling) {
    spelling.in_fix = false;
    return spelling;
}

namespace words {

inline constexpr Spelling geometries[] = {
    spelling("axisymmetric", true, "per radian"),
    spelling("plane_strain", false, "per metre; r is then the horizontal coordinate")};
inline constexpr Spelling sides[] = {
    spelling("left", Side::left, ""), spelling("right", Side::right, ""),
    spelling("bottom", Side::bottom, ""), spelling("top", Side::top, "")};
inline constexpr Spelling boundaries[] = {
    spelling("free", Boundary::free, "nothing, particles that leave end the run"),
    spelling("roller", Boundary::roller, "no velocity across"),
    spelling("fixed", Boundary::fixed, "no velocity at all"),
    only_in_files(spelling("absorbing", Boundary::absorbing,
                           "dashpots, besides what holds the bodies at the first step"))};
inline constexpr Spelling shapes[] = {
    spelling("cpdi", Shape::cpdi, "corners weighted by their radii"),
    spelling("cpdi_published", Shape::cpdi_published, "unweighted corners"),
    spelling("ugimp", Shape::ugimp, "the undeformed, upright domain"),
    spelling("linear", Shape::point, "at the particle: the original method")};
inline constexpr Spelling schemes[] = {
    spelling("usl", Scheme::usl, "stress last"),
    spelling("musl", Scheme::musl, "stress last, by velocities mapped back from the particles"),
    spelling("usf", Scheme::usf, "stress first")};
inline constexpr Spelling edges[] = {
    spelling("bottom", Edge::bottom, ""), spelling("right", Edge::right, ""),
    spelling("top", Edge::top, ""), spelling("left", Edge::left, "")};
inline constexpr Spelling pulse_forms[] = {spelling("half_sine", PulseForm::half_sine, ""),
                                           spelling("triangle", PulseForm::triangle, "")};
inline constexpr int penalty_law_word = -1;  // no nodal law
inline constexpr Spelling contact_laws[] = {
    spelling("geo", GRIT_CONTACT_GEO, "at nodes, as far as s reaches"),
    spelling("frictional", GRIT_CONTACT_FRICTIONAL, "at nodes"),
    only_in_files(spelling("penalty", penalty_law_word, "along lines"))};
inline constexpr Spelling normals[] = {spelling("stiff", GRIT_CONTACT_NORMAL_OF_A, ""),
                                       spelling("soft", GRIT_CONTACT_NORMAL_OF_B, ""),
                                       spelling("average", GRIT_CONTACT_NORMAL_AVERAGE, "")};
inline constexpr Spelling distances[] = {
    spelling("support", GRIT_CONTACT_SUPPORT, "of the stiffer body's surface to the node"),
    spelling("edge", GRIT_CONTACT_EDGE, "the absolute value of that"),
    spelling("nearest_centre", GRIT_CONTACT_NEAREST_CENTRE, "of the stiffer body's particles")};
inline constexpr Spelling depths[] = {spelling("lowest_point", DepthOf::lowest_point, ""),
                                      spelling("centre_of_mass", DepthOf::centre_of_mass, "")};
enum class IntergranularStart { mobilised, zero, off };
inline constexpr Spelling intergranular_starts[] = {
    spelling("mobilised", IntergranularStart::mobilised, "|h| = R"),
    spelling("zero", IntergranularStart::zero, "h = 0"),
    spelling("off", IntergranularStart::off, "the basic model")};
inline constexpr Spelling on_off[] = {spelling("on", 0, ""), spelling("off", 1, "")};

}  // namespace words

// The word of a value that is among them.
std::string_view word_of(Spellings words, int value);
template <class Value> std::string_view word_of(Spellings words, Value value) {
    return word_of(words, static_cast<int>(value));
}

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
    const char* otherwise =
        "";  // if it is not given; empty: a plan's own value, or it must be there

    // A number in SI units.
    constexpr Interval si_range() const { return {range.low * si, range.high * si, range.open}; }
};

namespace words {

inline constexpr double kilo = 1e3;
inline constexpr Interval above_zero{0.0, infinite, true};
inline constexpr Interval damping_range{0.0, 0.95}, pic_range{0.0, 1e5}, cfl_range{1e-3, 1.0},
    share_range{0.0, 1.0}, many{1, 1000000}, time_range{0.0, 1e9}, per_cell{1, 16};

inline constexpr CaseWord all[] = {
    {"", "name", "of the files written", Kind::text, "", 1, {}, {}, "the name of the file"},
    {"", "title", "for people", Kind::text, "", 1, {}, {}, "the name"},
    {"", "gravity_m_per_s2", "downwards", Kind::number, "m/s²", 1, {0.0, 1e6}},

    {"grid", "geometry", "", Kind::choice, "", 1, {}, geometries},
    {"grid", "r_from_m", "begin of the grid", Kind::number, "m", 1, {}, {}, "0"},
    {"grid", "z_from_m", "begin of the grid", Kind::number, "m", 1, {}, {}, "0"},
    {"grid", "r", "segments, one after the other", Kind::table},
    {"grid", "z", "... along z", Kind::table},
    {"grid.r", "to_m", "end of the segment", Kind::number, "m"},
    {"grid.r", "cells", "in the segment", Kind::integer, "", 1, {1, 100000}, {}, "by `cell_m`"},
    {"grid.r",
     "cell_m",
     "about the smallest cell",
     Kind::number,
     "m",
     1,
     above_zero,
     {},
     "by `cells`"},
    {"grid.r",
     "growth",
     "length of a cell / length of the one before",
     Kind::number,
     "",
     1,
     {0.5, 2.0},
     {},
     "1"},

    {"boundary",
     "left",
     "a side of the grid; the axis is a roller",
     Kind::choice,
     "",
     1,
     {},
     boundaries,
     "`free`"},
    {"boundary", "right", "", Kind::choice, "", 1, {}, boundaries, "`free`"},
    {"boundary", "bottom", "", Kind::choice, "", 1, {}, boundaries, "`free`"},
    {"boundary", "top", "", Kind::choice, "", 1, {}, boundaries, "`free`"},
    {"boundary",
     "p_wave_m_per_s",
     "of absorbing sides: they press with density times this speed times the velocity across",
     Kind::number,
     "m/s",
     1,
     above_zero,
     {},
     "needed by absorbing sides"},
    {"boundary",
     "s_wave_m_per_s",
     "... and drag with this one times that along",
     Kind::number,
     "m/s",
     1,
     above_zero,
     {},
     "needed by absorbing sides"},

    {"numerics", "shape_function", "", Kind::choice, "", 1, {}, shapes},
    {"numerics", "scheme", "", Kind::choice, "", 1, {}, schemes},
    {"numerics", "cfl", "share of the shortest cell that a wave may cross in a step", Kind::number,
     "", 1, cfl_range},
    {"numerics", "pic_rate_per_s", "1 − FLIP = rate Δt", Kind::number, "1/s", 1, pic_range},
    {"numerics", "local_damping", "share of the nodal force, against the motion", Kind::number, "",
     1, damping_range},
    {"numerics", "largest_step_s", "", Kind::number, "s", 1, above_zero, {}, "none"},
    {"numerics",
     "bulk_viscosity_linear",
     "in compression: ρ l (linear c ε̇ + quadratic l ε̇²), l the shorter edge of the cell",
     Kind::number,
     "",
     1,
     {0.0, 10.0}},
    {"numerics", "bulk_viscosity_quadratic", "", Kind::number, "", 1, {0.0, 10.0}},
    {"numerics", "cell_averaged_volume", "volumetric strain of a step as the mean of a cell",
     Kind::yes_or_no},
    {"numerics", "fixed_point", "nodal sums in integers: no order and no processes change a bit",
     Kind::yes_or_no},
    {"numerics", "threads", "of a process; change no result", Kind::integer, "", 1, {1, 1024}},
    {"numerics",
     "energy_residual_limit",
     "of the energy turned over: beyond, the run is stopped, as where a loss is a gain of that "
     "share",
     Kind::number,
     "",
     1,
     {1e-6, 1e6}},

    {"body", "name", "letters, digits, _ and -", Kind::text},
    {"body",
     "particles_per_cell_r",
     "fewer where a body ends within a cell",
     Kind::integer,
     "",
     1,
     per_cell,
     {},
     "2"},
    {"body", "particles_per_cell_z", "", Kind::integer, "", 1, per_cell, {}, "2"},
    {"body",
     "density_kg_per_m3",
     "",
     Kind::number,
     "kg/m³",
     1,
     above_zero,
     {},
     "needed but for rigid bodies"},
    {"body",
     "grain_density_kg_per_m3",
     "dry sand with a constant void_ratio",
     Kind::number,
     "kg/m³",
     1,
     above_zero,
     {},
     "by `density_kg_per_m3`"},
    {"body",
     "velocity_m_per_s",
     "at the start, along r and z",
     Kind::numbers,
     "m/s",
     1,
     {},
     {},
     "0"},
    {"body", "box", "any number of boxes ...", Kind::table, "", 1, {}, {}, "by `polygon`"},
    {"body",
     "polygon",
     "... and polygons; the first one has what they share",
     Kind::table,
     "",
     1,
     {},
     {},
     "by `box`"},
    {"body", "elastic", "a material: linear", Kind::table, "", 1, {}, {}, "another one"},
    {"body",
     "neo_hooke",
     "a material, with the keys of `elastic`",
     Kind::table,
     "",
     1,
     {},
     {},
     "another one"},
    {"body",
     "rigid",
     "a material that moves as a table says",
     Kind::table,
     "",
     1,
     {},
     {},
     "another one"},
    {"body", "sand", "a material", Kind::table, "", 1, {}, {}, "another one"},
    {"body",
     "stress_at_rest",
     "of sand and linear elastic bodies",
     Kind::table,
     "",
     1,
     {},
     {},
     "no stress"},
    {"body.box", "r_m", "of a box from, to; of a polygon its corners, in order", Kind::numbers,
     "m"},
    {"body.box", "z_m", "... along z; a particle is inside if its centre is", Kind::numbers, "m"},
    {"body.box",
     "particles_per_cell_r",
     "of this one alone",
     Kind::integer,
     "",
     1,
     per_cell,
     {},
     "as in the body"},
    {"body.box", "particles_per_cell_z", "", Kind::integer, "", 1, per_cell, {}, "as in the body"},
    {"body.elastic", "youngs_modulus_kPa", "", Kind::number, "kPa", kilo, above_zero},
    {"body.elastic", "poissons_ratio", "", Kind::number, "", 1, {-1.0, 0.5, true}},
    {"body.rigid",
     "time_s",
     "of the velocities, which are linear between",
     Kind::numbers,
     "s",
     1,
     {},
     {},
     "0: one value, constant"},
    {"body.rigid", "velocity_r_m_per_s", "", Kind::numbers, "m/s", 1, {}, {}, "0"},
    {"body.rigid", "velocity_z_m_per_s", "", Kind::numbers, "m/s", 1, {}, {}, "0"},
    {"body.rigid",
     "from_stage",
     "at rest before, time counts from its begin",
     Kind::text,
     "",
     1,
     {},
     {},
     "the run's"},
    {"body.sand",
     "name",
     "of `grit sand list`; parameters given besides override those of the sand, with the names of "
     "element tests",
     Kind::text,
     "",
     1,
     {},
     {},
     "all parameters are needed"},
    {"body.sand",
     "void_ratio",
     "e",
     Kind::number,
     "",
     1,
     above_zero,
     {},
     "by `void_ratio_at_zero_pressure`"},
    {"body.sand",
     "void_ratio_at_zero_pressure",
     "e₀ exp(−(3p/h_s)ⁿ)",
     Kind::number,
     "",
     1,
     above_zero,
     {},
     "by `void_ratio`"},
    {"body.sand",
     "intergranular_strain",
     "",
     Kind::choice,
     "",
     1,
     {},
     intergranular_starts,
     "`mobilised` if the sand has parameters for it"},
    {"body.sand",
     "intergranular_direction",
     "of h if mobilised: rr zz tt rz",
     Kind::numbers,
     "",
     1,
     {},
     {},
     "vertical compression"},
    {"body.sand",
     "tolerance",
     "of an update, relative",
     Kind::number,
     "",
     1,
     {1e-12, 0.1},
     {},
     "0.001"},
    {"body.stress_at_rest", "surface_m", "level of no overburden ...", Kind::number, "m"},
    {"body.stress_at_rest",
     "surcharge_kPa",
     "... but this",
     Kind::number,
     "kPa",
     kilo,
     time_range,
     {},
     "0"},
    {"body.stress_at_rest",
     "K0",
     "",
     Kind::number,
     "",
     1,
     {0.0, 10.0},
     {},
     "sand 1 − sin φ_c, elastic ν/(1 − ν)"},

    {"traction", "body", "whose outermost edges of particles are loaded", Kind::text},
    {"traction", "edge", "of the undeformed particle", Kind::choice, "", 1, {}, edges},
    {"traction",
     "r_m",
     "where the centres of its particles are",
     Kind::numbers,
     "m",
     1,
     {},
     {},
     "anywhere"},
    {"traction", "z_m", "", Kind::numbers, "m", 1, {}, {}, "anywhere"},
    {"traction",
     "direction",
     "",
     Kind::numbers,
     "",
     1,
     {},
     {},
     "against the edge's outward normal"},
    {"traction",
     "from_stage",
     "no load before, time counts from its begin",
     Kind::text,
     "",
     1,
     {},
     {},
     "the run's"},
    {"traction",
     "stress_kPa",
     "presses where it is positive; linear between its times",
     Kind::numbers,
     "kPa",
     kilo,
     {},
     {},
     "by `pulses`"},
    {"traction",
     "time_s",
     "of the stresses",
     Kind::numbers,
     "s",
     1,
     {},
     {},
     "0: one value, constant"},
    {"traction", "pulses", "", Kind::table, "", 1, {}, {}, "by `stress_kPa`"},
    {"traction.pulses", "peak_kPa", "", Kind::number, "kPa", kilo},
    {"traction.pulses", "form", "", Kind::choice, "", 1, {}, pulse_forms, "`half_sine`"},
    {"traction.pulses", "duration_s", "", Kind::number, "s", 1, above_zero},
    {"traction.pulses",
     "peak_time_s",
     "of a triangle",
     Kind::number,
     "s",
     1,
     above_zero,
     {},
     "half of the duration"},
    {"traction.pulses",
     "interval_s",
     "from begin to begin",
     Kind::number,
     "s",
     1,
     above_zero,
     {},
     "the duration"},
    {"traction.pulses", "count", "", Kind::integer, "", 1, many, {}, "1"},
    {"traction.pulses", "start_s", "of the first pulse", Kind::number, "s", 1, time_range, {}, "0"},

    {"contact", "stiff", "the body whose surface and gradient decide", Kind::text},
    {"contact", "soft", "the other body", Kind::text},
    {"contact", "law", "", Kind::choice, "", 1, {}, contact_laws},
    {"contact", "friction_coefficient", "", Kind::number, "", 1, {0.0, 100.0}},
    {"contact", "penalty_power", "k of the geo law alone", Kind::number, "", 1, {1e-6, 1e6}},
    {"contact", "normal", "of whose gradient", Kind::choice, "", 1, {}, normals},
    {"contact", "distance", "none if frictional and not gated", Kind::choice, "", 1, {}, distances},
    {"contact", "gated", "bodies apart are left alone", Kind::yes_or_no},
    {"contact",
     "modulus_kPa",
     "of penalty: P-wave modulus of the softer body",
     Kind::number,
     "kPa",
     kilo,
     above_zero,
     {},
     "needed by penalty"},
    {"contact",
     "stiffness_multiple",
     "of penalty: of modulus / shortest cell",
     Kind::number,
     "",
     1,
     {1e-6, 1e6},
     {},
     "1"},
    {"contact",
     "stiff_line",
     "of penalty: with the body on its left, closed if the last point is the first",
     Kind::table,
     "",
     1,
     {},
     {},
     "needed by penalty"},
    {"contact", "soft_line", "", Kind::table, "", 1, {}, {}, "needed by penalty"},
    {"contact.stiff_line", "r_m", "", Kind::numbers, "m"},
    {"contact.stiff_line", "z_m", "", Kind::numbers, "m"},

    {"stage", "name", "letters, digits, _ and -", Kind::text},
    {"stage", "gravity", "", Kind::yes_or_no},
    {"stage",
     "local_damping",
     "as in `numerics`",
     Kind::number,
     "",
     1,
     damping_range,
     {},
     "that of `numerics`"},
    {"stage",
     "pic_rate_per_s",
     "as in `numerics`",
     Kind::number,
     "1/s",
     1,
     pic_range,
     {},
     "that of `numerics`"},
    {"stage", "cfl", "as in `numerics`", Kind::number, "", 1, cfl_range, {}, "that of `numerics`"},
    {"stage", "until", "what ends the stage, whichever comes first", Kind::table},
    {"stage.until", "time_s", "since the stage began", Kind::number, "s", 1, above_zero, {}, "any"},
    {"stage.until",
     "depth_m",
     "of the driven body since the stage began",
     Kind::number,
     "m",
     1,
     above_zero,
     {},
     "any"},
    {"stage.until",
     "blows",
     "intervals of pulses that are over since the stage began: of the train that begins with the "
     "stage, else of "
     "the one that began last, which must have as many left",
     Kind::integer,
     "",
     1,
     many,
     {},
     "any"},
    {"stage.until",
     "unbalanced_share",
     "at rest: largest resultant on a node / largest nodal force of its body, and ...",
     Kind::number,
     "",
     1,
     share_range,
     {},
     "any"},
    {"stage.until",
     "kinetic_share",
     "... kinetic energy / energy turned over",
     Kind::number,
     "",
     1,
     share_range,
     {},
     "any"},

    {"history", "body", "the driven body", Kind::text, "", 1, {}, {}, "the first"},
    {"history", "depth_of", "", Kind::choice, "", 1, {}, depths, "`lowest_point`"},
    {"history",
     "interval_s",
     "between rows; 0: every step",
     Kind::number,
     "s",
     1,
     time_range,
     {},
     "a thousandth of `time_s` of the first stage that has one; needed if none has"},

    {"fields",
     "interval_s",
     "between .vtu files; 0: the start and the ends of stages alone",
     Kind::number,
     "s",
     1,
     time_range,
     {},
     "0"},
    {"fields", "variables", "see Fields", Kind::texts, "", 1, {}, {}, "all"},
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
std::span<const Member<ContactPlan>> contact_members();  // of nodal laws
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
