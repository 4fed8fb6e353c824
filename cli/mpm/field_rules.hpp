// SPDX-License-Identifier: BSD-3-Clause
// How each variable follows from a particle.
#pragma once

#include <initializer_list>
#include <vector>

#include <adapters/mpm/kernel/sand.hpp>
#include <grit/sand_operators.h>

#include "cli/mpm/fields.hpp"
#include "cli/sand/parameter_units.hpp"

namespace cli {

inline constexpr double kilo = 1e-3;

// Of a stress [6], and of a state of sand; sand null: none, and no state is read.
grit_sand_invariants invariants_of(const grit_sand* sand, const double* stress,
                                   const double* state);

// A particle, and what its columns do not know.
struct ShownParticle {
    grit::mpm::Body& body;
    std::ptrdiff_t p;
    std::size_t number;  // of the body
    int id;
    grit::Vector2 start;  // [m]
    bool axisymmetric;
    grit_sand_invariants invariants;  // of bodies with stress

    grit::mpm::ParticleView view() const { return body.particles.view(); }
    double operator()(int column) const { return view()[column][p]; }
    double mass() const { return (*this)(grit::mpm::column::mass); }
    double volume() const { return (*this)(grit::mpm::column::V0)*view().J(p); }
    double of_state(int k) const { return (*this)(grit::mpm::Sand::state + k); }
};

template <class Particle> struct FieldRule {
    MpmField field;
    double (*value)(const Particle&, int component);
};
template <class Particle> using FieldRules = std::vector<FieldRule<Particle>>;

// What plane and space say alike, before and after their components.
template <class Particle> FieldRules<Particle> rules_of_numbers() {
    using P = const Particle&;
    return {{{"id", "-", "number of the particle in its body", 1, ShownOf::every_body},
             [](P x, int) { return static_cast<double>(x.id); }},
            {{"body", "-", "number of the body in the case, from 0", 1, ShownOf::every_body},
             [](P x, int) { return static_cast<double>(x.number); }}};
}

template <class Particle> FieldRules<Particle> rules_of_volume() {
    using P = const Particle&;
    return {{{"density", "kg/m3", "mass by current volume", 1, ShownOf::every_body},
             [](P x, int) { return x.mass() / x.volume(); }},
            {{"J", "-", "volume by initial volume, det F", 1, ShownOf::every_body},
             [](P x, int) { return x.view().J(x.p); }}};
}

template <class Particle> FieldRules<Particle> rules_of_invariants() {
    using P = const Particle&;
    return {{{"p", "kPa", "mean pressure, compression positive", 1, ShownOf::stressed},
             [](P x, int) { return kilo * x.invariants.p; }},
            {{"q", "kPa", "sqrt(3/2) |deviator|", 1, ShownOf::stressed},
             [](P x, int) { return kilo * x.invariants.q; }},
            {{"work_density", "kJ/m3", "stored energy, of sand the work done on it, by volume", 1,
              ShownOf::stressed},
             [](P x, int) { return kilo * (x.body.material->energy(x.view(), x.p) / x.volume()); }},
            {{"friction_angle", "deg", "mobilised, asin((s1 - s3)/(s1 + s3))", 1, ShownOf::sand},
             [](P x, int) { return x.invariants.mobilised_friction_angle / degree; }},
            {{"lode_angle", "deg", "0 triaxial compression ... 60 triaxial extension", 1,
              ShownOf::sand},
             [](P x, int) { return x.invariants.lode_angle / degree; }},
            {{"void_ratio", "-", "e", 1, ShownOf::sand},
             [](P x, int) { return x.of_state(GRIT_SAND_VOID_RATIO); }},
            {{"relative_density", "-", "(e_c - e)/(e_c - e_d) at the current p", 1, ShownOf::sand},
             [](P x, int) { return x.invariants.relative_density; }}};
}

template <class Particle> FieldRules<Particle> rules_of_state() {
    using P = const Particle&;
    return {{{"rho", "-", "|h|/R", 1, ShownOf::sand}, [](P x, int) { return x.invariants.rho; }},
            {{"separation", "-", "opening to be closed before stress returns", 1, ShownOf::sand},
             [](P x, int) { return x.of_state(GRIT_SAND_SEPARATION); }}};
}

template <class Particle> double pore_pressure(const Particle& x) {
    return x.body.water->pressure(x.view(), x.p);
}
// [kPa]
template <class Particle> double total_stress(const Particle& x, int column) {
    return kilo * (x(column) - pore_pressure(x));
}

template <class Particle> FieldRules<Particle> rules_of_pore_pressure() {
    return {{{"pore_pressure", "kPa", "compression positive", 1, ShownOf::water},
             [](const Particle& x, int) { return kilo * pore_pressure(x); }}};
}

template <class Particle> FieldRules<Particle> rules_of_porosity() {
    return {{{"porosity", "-", "n", 1, ShownOf::water}, [](const Particle& x, int) {
                 return grit::mpm::PoreWater::porosity_of(x.body.water->void_ratio(x.view(), x.p));
             }}};
}

template <class Particle>
FieldRules<Particle> joined(std::initializer_list<FieldRules<Particle>> parts) {
    FieldRules<Particle> out;
    for (const FieldRules<Particle>& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
}

using MpmFieldRule = FieldRule<ShownParticle>;

// In plane strain components have other names, see geometry_words.hpp.
const std::vector<MpmFieldRule>& mpm_field_rules(bool axisymmetric);

}  // namespace cli
