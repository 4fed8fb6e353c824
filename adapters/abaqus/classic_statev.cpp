// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/classic_statev.hpp"

namespace grit::abaqus {
namespace {

bool carries_separation(const UmatArguments& call) {
    return *call.nstatv > GRIT_CLASSIC_SEPARATION;
}

}  // namespace

Point read_point(const UmatArguments& call) {
    Point p{};
    p.pore_stress = call.statev[GRIT_CLASSIC_PORE_STRESS];
    for (int c = 0; c < *call.ntens; ++c) {
        p.strain_increment[c] = call.dstran[c];
        p.stress[c] = c < 3 ? call.stress[c] - p.pore_stress : call.stress[c];
        p.state[c] = call.statev[c];
    }
    p.state[GRIT_SAND_VOID_RATIO] = call.statev[GRIT_CLASSIC_VOID_RATIO];
    p.state[GRIT_SAND_SEPARATION] =
        carries_separation(call) ? call.statev[GRIT_CLASSIC_SEPARATION] : 0.0;
    p.substep = call.statev[GRIT_CLASSIC_SUBSTEP];
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
    call.statev[GRIT_CLASSIC_VOID_RATIO] = end.state[GRIT_SAND_VOID_RATIO];
    call.statev[GRIT_CLASSIC_PORE_STRESS] = end.pore_stress;
    call.statev[GRIT_CLASSIC_SUBSTEP] = end.substep;
    if (carries_separation(call))
        call.statev[GRIT_CLASSIC_SEPARATION] = end.state[GRIT_SAND_SEPARATION];
}

void write_output(const UmatArguments& call, const grit_sand& sand, const Point& end,
                  int evaluations) {
    grit_sand_invariants invariants{};
    invariants.struct_size = sizeof invariants;
    grit_sand_invariants_of(&sand, end.stress, end.state, &invariants);
    call.statev[GRIT_CLASSIC_PRESSURE] = invariants.p;
    call.statev[GRIT_CLASSIC_EVALUATIONS] = evaluations;
    call.statev[GRIT_CLASSIC_MOBILISED_ANGLE] = invariants.mobilised_friction_angle / GRIT_DEGREE;
    call.statev[GRIT_CLASSIC_RHO] = invariants.rho;
}

}  // namespace grit::abaqus
