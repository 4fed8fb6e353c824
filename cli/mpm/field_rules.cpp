// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/field_rules.hpp"

#include <numbers>

#include "cli/sand/parameter_units.hpp"

namespace cli {
namespace {

namespace mpm = grit::mpm;
namespace c = grit::mpm::column;

constexpr double kilo = 1e-3;

// Per radian -> the whole ring.
double whole(const ShownParticle& x) { return x.axisymmetric ? 2.0 * std::numbers::pi : 1.0; }

double displacement(const ShownParticle& x, int k) {
    return k == 0 ? x(c::r) - x.start[0] : x(c::z) - x.start[1];
}

double pore_pressure(const ShownParticle& x) { return x.body.water->pressure(x.view(), x.p); }

double total_stress(const ShownParticle& x, int column) {
    return kilo * (x(column) - pore_pressure(x));
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

double work_density(const ShownParticle& x, int) {
    return x.body.material->energy(x.view(), x.p) / (x(c::V0) * x.view().J(x.p));
}

}  // namespace

const std::vector<MpmFieldRule>& mpm_field_rules() {
    using P = const ShownParticle&;
    static const std::vector<MpmFieldRule> all = {
        {{"id", "-", "number of the particle in its body", 1, ShownOf::every_body},
         [](P x, int) { return static_cast<double>(x.id); }},
        {{"body", "-", "number of the body in the case, from 0", 1, ShownOf::every_body},
         [](P x, int) { return static_cast<double>(x.number); }},
        {{"velocity", "m/s", "along r and z", 2, ShownOf::every_body},
         [](P x, int k) { return x(c::v_r + k); }},
        {{"displacement", "m", "since the start, along r and z", 2, ShownOf::every_body},
         displacement},
        {{"mass", "kg", "of the ring, in plane strain of a metre; without water that flows", 1,
          ShownOf::every_body},
         [](P x, int) { return whole(x) * x(c::mass); }},
        {{"density", "kg/m3", "mass by current volume", 1, ShownOf::every_body},
         [](P x, int) { return x(c::mass) / (x(c::V0) * x.view().J(x.p)); }},
        {{"J", "-", "volume by initial volume, det F", 1, ShownOf::every_body},
         [](P x, int) { return x.view().J(x.p); }},
        {{"F_rr", "-", "deformation gradient", 1, ShownOf::every_body},
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
         [](P x, int) { return kilo * x(c::S_rz); }},
        {{"p", "kPa", "mean pressure, compression positive", 1, ShownOf::stressed},
         [](P x, int) { return kilo * x.invariants.p; }},
        {{"q", "kPa", "sqrt(3/2) |deviator|", 1, ShownOf::stressed},
         [](P x, int) { return kilo * x.invariants.q; }},
        {{"work_density", "kJ/m3", "stored energy, of sand the work done on it, by volume", 1,
          ShownOf::stressed},
         [](P x, int k) { return kilo * work_density(x, k); }},
        {{"friction_angle", "deg", "mobilised, asin((s1 - s3)/(s1 + s3))", 1, ShownOf::sand},
         [](P x, int) { return x.invariants.mobilised_friction_angle / degree; }},
        {{"lode_angle", "deg", "0 triaxial compression ... 60 triaxial extension", 1,
          ShownOf::sand},
         [](P x, int) { return x.invariants.lode_angle / degree; }},
        {{"void_ratio", "-", "e", 1, ShownOf::sand},
         [](P x, int) { return x.of_state(GRIT_SAND_VOID_RATIO); }},
        {{"relative_density", "-", "(e_c - e)/(e_c - e_d) at the current p", 1, ShownOf::sand},
         [](P x, int) { return x.invariants.relative_density; }},
        {{"h_rr", "-", "intergranular strain, extension positive", 1, ShownOf::sand},
         [](P x, int) { return x.of_state(GRIT_SAND_H11); }},
        {{"h_zz", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(GRIT_SAND_H22); }},
        {{"h_tt", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(GRIT_SAND_H33); }},
        {{"h_rz", "-", "engineering shear", 1, ShownOf::sand},
         [](P x, int) { return x.of_state(GRIT_SAND_H12); }},
        {{"rho", "-", "|h|/R", 1, ShownOf::sand}, [](P x, int) { return x.invariants.rho; }},
        {{"separation", "-", "opening to be closed before stress returns", 1, ShownOf::sand},
         [](P x, int) { return x.of_state(GRIT_SAND_SEPARATION); }},
        {{"pore_pressure", "kPa", "compression positive", 1, ShownOf::water},
         [](P x, int) { return kilo * pore_pressure(x); }},
        {{"total_rr", "kPa", "total stress, effective - pore pressure; rz has none", 1,
          ShownOf::water},
         [](P x, int) { return total_stress(x, c::S_rr); }},
        {{"total_zz", "kPa", "", 1, ShownOf::water},
         [](P x, int) { return total_stress(x, c::S_zz); }},
        {{"total_tt", "kPa", "", 1, ShownOf::water},
         [](P x, int) { return total_stress(x, c::S_tt); }},
        {{"porosity", "-", "n", 1, ShownOf::water},
         [](P x, int) {
             return mpm::PoreWater::porosity_of(x.body.water->void_ratio(x.view(), x.p));
         }},
        {{"seepage", "m/s", "n (v_w - v_s), along r and z", 2, ShownOf::water}, seepage},
        {{"saturation", "-",
          "mass of the water that has come and gone by that of full pores; 1 where none flows", 1,
          ShownOf::water},
         saturation},
    };
    return all;
}

}  // namespace cli
