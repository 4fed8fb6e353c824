// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/point.hpp"

#include <cstddef>

#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {
namespace {

bool carries_separation(const Statev& statev) { return statev.size > GRIT_CLASSIC_SEPARATION; }

}  // namespace

void read_state(const Statev& statev, int shears, const Material& material, Point& point) {
    point.pore_pressure = -statev[GRIT_CLASSIC_PORE_STRESS];
    const double p = grit_sand_water_borne(&material.water, point.pore_pressure);
    for (int c = 0; c < 3; ++c) point.stress[c] += p;
    for (int c = 0; c < 6; ++c) point.state[c] = c < 3 + shears ? statev[layout.h + c] : 0.0;
    point.state[GRIT_SAND_VOID_RATIO] = statev[layout.void_ratio];
    point.state[GRIT_SAND_SEPARATION] =
        carries_separation(statev) ? statev[GRIT_CLASSIC_SEPARATION] : 0.0;
    point.substep = statev[GRIT_CLASSIC_SUBSTEP];
}

grit_status complete_state(const Material& material, Point& point, grit_error& error) {
    double& e = point.state[GRIT_SAND_VOID_RATIO];
    if (!(e < GRIT_CLASSIC_NO_VOID_RATIO)) return GRIT_OK;
    const double p = -(point.stress[0] + point.stress[1] + point.stress[2]) / 3.0;
    return initial_void_ratio(material, p, e, error);
}

grit_sand_water water_of(const Material& material, Point* points) {
    constexpr std::ptrdiff_t stride = sizeof(Point) / sizeof(double);
    grit_sand_water water = material.water;
    water.pore_pressure = grit_mutable_view_of(&points->pore_pressure, stride, 1);
    water.total_stress = grit_mutable_view_of(points->total, stride, 1);
    return water;
}

void write_state(const Statev& statev, const Material& material, const Point& end,
                 int evaluations) {
    for (int c = 0; c < 6; ++c) statev[layout.h + c] = end.state[c];
    statev[layout.void_ratio] = end.state[GRIT_SAND_VOID_RATIO];
    statev[GRIT_CLASSIC_PORE_STRESS] = -end.pore_pressure;
    statev[GRIT_CLASSIC_SUBSTEP] = end.substep;
    if (carries_separation(statev))
        statev[GRIT_CLASSIC_SEPARATION] = end.state[GRIT_SAND_SEPARATION];

    grit_sand_invariants invariants{};
    invariants.struct_size = offsetof(grit_sand_invariants, relative_density);  // not in STATEV
    grit_sand_invariants_of(&material.sand, end.stress, end.state, &invariants);
    statev[GRIT_CLASSIC_PRESSURE] = invariants.p;
    statev[GRIT_CLASSIC_EVALUATIONS] = evaluations;
    statev[GRIT_CLASSIC_MOBILISED_ANGLE] = invariants.mobilised_friction_angle / layout.angle;
    statev[GRIT_CLASSIC_RHO] = invariants.rho;
}

}  // namespace grit::abaqus
