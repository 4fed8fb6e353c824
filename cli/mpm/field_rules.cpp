// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/field_rules.hpp"

#include <deque>
#include <numbers>
#include <string>

#include "cli/mpm/geometry_words.hpp"
#include "cli/sand/parameter_units.hpp"

namespace cli {
namespace {

namespace mpm = grit::mpm;
namespace c = grit::mpm::column;

// Per radian -> the whole ring.
double whole(const ShownParticle& x) { return x.axisymmetric ? 2.0 * std::numbers::pi : 1.0; }

double displacement(const ShownParticle& x, int k) {
    return k == 0 ? x(c::r) - x.start[0] : x(c::z) - x.start[1];
}

// Of the water against the sand that is at rest, by the volume of both.
double seepage(const ShownParticle& x, int k) {
    const grit::mpm::PoreWater& water = *x.body.water;
    if (!water.flows) return 0.0;
    return grit::mpm::PoreWater::porosity_of(water.void_ratio(x.view(), x.p)) *
           x(water.velocity_column() + k);
}

double saturation(const ShownParticle& x, int) {
    const grit::mpm::PoreWater& water = *x.body.water;
    return water.flows ? x(water.content_column()) / water.mass(x.view(), x.p) : 1.0;
}

const std::vector<MpmFieldRule>& rules_around_an_axis() {
    using P = const ShownParticle&;
    static const std::vector<MpmFieldRule> all = joined<ShownParticle>({
        rules_of_numbers<ShownParticle>(),
        {{{"velocity", "m/s", "along r and z", 2, ShownOf::every_body},
          [](P x, int k) { return x(c::v_r + k); }},
         {{"displacement", "m", "since the start, along r and z", 2, ShownOf::every_body},
          displacement},
         {{"mass", "kg", "of the ring, in plane strain of a metre; without water that flows", 1,
           ShownOf::every_body},
          [](P x, int) { return whole(x) * x(c::mass); }}},
        rules_of_volume<ShownParticle>(),
        {{{"F_rr", "-", "deformation gradient", 1, ShownOf::every_body},
          [](P x, int) { return x(c::F_rr); }},
         {{"F_rz", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(c::F_rz); }},
         {{"F_zr", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(c::F_zr); }},
         {{"F_zz", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(c::F_zz); }},
         {{"F_tt", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(c::F_tt); }},
         {{"stress_rr", "kPa", "Cauchy stress, tension positive; with water effective", 1,
           ShownOf::stressed},
          [](P x, int) { return kilo * x(c::S_rr); }},
         {{"stress_zz", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(c::S_zz); }},
         {{"stress_tt", "kPa", "hoop, in plane strain across the plane", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(c::S_tt); }},
         {{"stress_rz", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(c::S_rz); }}},
        rules_of_invariants<ShownParticle>(),
        {{{"h_rr", "-", "intergranular strain, extension positive", 1, ShownOf::sand},
          [](P x, int) { return x.of_state(GRIT_SAND_H11); }},
         {{"h_zz", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(GRIT_SAND_H22); }},
         {{"h_tt", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(GRIT_SAND_H33); }},
         {{"h_rz", "-", "engineering shear", 1, ShownOf::sand},
          [](P x, int) { return x.of_state(GRIT_SAND_H12); }}},
        rules_of_state<ShownParticle>(),
        rules_of_pore_pressure<ShownParticle>(),
        {{{"total_rr", "kPa", "total stress, effective - pore pressure; rz has none", 1,
           ShownOf::water},
          [](P x, int) { return total_stress(x, c::S_rr); }},
         {{"total_zz", "kPa", "", 1, ShownOf::water},
          [](P x, int) { return total_stress(x, c::S_zz); }},
         {{"total_tt", "kPa", "", 1, ShownOf::water},
          [](P x, int) { return total_stress(x, c::S_tt); }}},
        rules_of_porosity<ShownParticle>(),
        {{{"seepage", "m/s", "n (v_w - v_s), along r and z", 2, ShownOf::water}, seepage},
         {{"saturation", "-",
           "mass of the water that has come and gone by that of full pores; 1 where none flows", 1,
           ShownOf::water},
          saturation}},
    });
    return all;
}

}  // namespace

const std::vector<MpmFieldRule>& mpm_field_rules(bool axisymmetric) {
    if (axisymmetric) return rules_around_an_axis();
    static std::deque<std::string> names;
    static const std::vector<MpmFieldRule> in_a_plane = [] {
        std::vector<MpmFieldRule> out = rules_around_an_axis();
        for (MpmFieldRule& rule : out)
            rule.field.name = names.emplace_back(name_in_plane_strain(rule.field.name)).c_str();
        return out;
    }();
    return in_a_plane;
}

}  // namespace cli
