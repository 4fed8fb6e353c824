// SPDX-License-Identifier: BSD-3-Clause
// How each variable follows from a particle.
#pragma once

#include <adapters/mpm/kernel/sand.hpp>
#include <grit/sand_operators.h>

#include "cli/mpm/fields.hpp"

namespace cli {

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
    double of_state(int k) const { return (*this)(grit::mpm::Sand::state + k); }
};

struct MpmFieldRule {
    MpmField field;
    double (*value)(const ShownParticle&, int component);
};

const std::vector<MpmFieldRule>& mpm_field_rules();

}  // namespace cli
