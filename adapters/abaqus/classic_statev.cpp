// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/classic_statev.hpp"

namespace grit::abaqus {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

// Places in STATEV, counted from 0; 0 ... 5 are h.
enum {
    void_ratio = 6,
    pore_stress = 7,
    effective_pressure = 8,
    evaluation_count = 9,
    mobilised_angle = 10,
    rho = 11,
    substep = 12,
    separation = 13  // if the host allots it
};

bool carries_separation(const UmatArguments& call) { return *call.nstatv > separation; }

}  // namespace

Point read_point(const UmatArguments& call) {
    Point p{};
    p.pore_stress = call.statev[pore_stress];
    for (int c = 0; c < *call.ntens; ++c) {
        p.strain_increment[c] = call.dstran[c];
        p.stress[c] = c < 3 ? call.stress[c] - p.pore_stress : call.stress[c];
        p.state[c] = call.statev[c];
    }
    p.state[GRIT_SAND_VOID_RATIO] = call.statev[void_ratio];
    p.state[GRIT_SAND_SEPARATION] = carries_separation(call) ? call.statev[separation] : 0.0;
    p.substep = call.statev[substep];
    return p;
}

double mean_pressure(const Point& point) {
    return -(point.stress[0] + point.stress[1] + point.stress[2]) / 3.0;
}

void write_point(const UmatArguments& call, const Point& start, const Point& end) {
    const bool same_water = end.pore_stress == start.pore_stress;
    for (int c = 0; c < *call.ntens; ++c) {
        // Taking the pore pressure off and on again must not cost a bit where nothing has changed.
        if (!same_water || end.stress[c] != start.stress[c])
            call.stress[c] = c < 3 ? end.stress[c] + end.pore_stress : end.stress[c];
    }
    for (int c = 0; c < 6; ++c) call.statev[c] = end.state[c];
    call.statev[void_ratio] = end.state[GRIT_SAND_VOID_RATIO];
    call.statev[pore_stress] = end.pore_stress;
    call.statev[substep] = end.substep;
    if (carries_separation(call)) call.statev[separation] = end.state[GRIT_SAND_SEPARATION];
}

void write_output(const UmatArguments& call, const grit_sand& sand, const Point& end,
                  int evaluations) {
    grit_sand_invariants invariants{};
    invariants.struct_size = sizeof invariants;
    grit_sand_invariants_of(&sand, end.stress, end.state, &invariants);
    call.statev[effective_pressure] = invariants.p;
    call.statev[evaluation_count] = evaluations;
    call.statev[mobilised_angle] = invariants.mobilised_friction_angle / degree;
    call.statev[rho] = invariants.rho;
}

}  // namespace grit::abaqus
