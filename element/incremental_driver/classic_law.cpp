// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/classic_law.hpp"

#include <algorithm>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

using element::unit_tensor;

}  // namespace

ClassicLaw::ClassicLaw(ClassicSand given, int nstatv) : sand(std::move(given)) {
    for (int i = 1; i <= nstatv; ++i) names.push_back(element::text("statev(%d)", i));
}

// As the law has it, in its own order of the state; effective stress where it carries no water.
element::MaterialPoint ClassicLaw::own(const element::MaterialPoint& classic) const {
    const std::vector<double>& statev = classic.state;
    element::MaterialPoint out;
    const element::Vector6 effective = classic.stress + pore_pressure(classic) * unit_tensor();
    out.stress = sand.has_water ? classic.stress : effective;
    out.state.assign(sand.law->state_names().size(), 0.0);
    std::copy_n(statev.begin(), 6, out.state.begin());
    out.state[GRIT_SAND_VOID_RATIO] = statev[GRIT_CLASSIC_VOID_RATIO];
    if (statev.size() > GRIT_CLASSIC_SEPARATION)
        out.state[GRIT_SAND_SEPARATION] = statev[GRIT_CLASSIC_SEPARATION];
    out.state[element::GritLaw::substep_index] = statev[GRIT_CLASSIC_SUBSTEP];
    if (sand.has_water)
        out.state[element::GritLaw::pore_pressure_index] = -statev[GRIT_CLASSIC_PORE_STRESS];
    if (statev[GRIT_CLASSIC_VOID_RATIO] < GRIT_CLASSIC_NO_VOID_RATIO)
        out.state[GRIT_SAND_VOID_RATIO] = void_ratio_at(sand, -effective.head<3>().sum() / 3.0);
    return out;
}

double ClassicLaw::pore_pressure(const element::MaterialPoint& classic) const {
    return sand.law->borne(-classic.state[GRIT_CLASSIC_PORE_STRESS]);
}

element::Response ClassicLaw::advance(const element::MaterialPoint& start,
                                      const element::StrainIncrement& increment) const {
    element::Response out = sand.law->advance(own(start), increment);
    if (out.outcome != element::Outcome::done) return out;
    const element::MaterialPoint end = std::move(out.end);
    const grit_sand_invariants invariants = sand.law->invariants(end);
    std::vector<double> statev = start.state;
    std::copy_n(end.state.begin(), 6, statev.begin());
    statev[GRIT_CLASSIC_VOID_RATIO] = end.state[GRIT_SAND_VOID_RATIO];
    if (sand.has_water)
        statev[GRIT_CLASSIC_PORE_STRESS] = -end.state[element::GritLaw::pore_pressure_index];
    statev[GRIT_CLASSIC_PRESSURE] = invariants.p;
    statev[GRIT_CLASSIC_EVALUATIONS] = static_cast<double>(out.evaluations);
    statev[GRIT_CLASSIC_MOBILISED_ANGLE] = invariants.mobilised_friction_angle / GRIT_DEGREE;
    statev[GRIT_CLASSIC_RHO] = invariants.rho;
    statev[GRIT_CLASSIC_SUBSTEP] = end.state[element::GritLaw::substep_index];
    if (statev.size() > GRIT_CLASSIC_SEPARATION)
        statev[GRIT_CLASSIC_SEPARATION] = end.state[GRIT_SAND_SEPARATION];
    out.end.state = std::move(statev);
    out.end.stress = end.stress;
    if (!sand.has_water) out.end.stress -= pore_pressure(out.end) * unit_tensor();
    return out;
}

element::Observation ClassicLaw::observe(const element::MaterialPoint& point) const {
    return {point.state[GRIT_CLASSIC_VOID_RATIO], pore_pressure(point)};
}

void ClassicLaw::check(const element::MaterialPoint& start) const {
    const element::Response null_step = advance(start, {});
    if (null_step.outcome != element::Outcome::done) throw element::BadCase(null_step.message);
}

}  // namespace incremental_driver
