// SPDX-License-Identifier: BSD-3-Clause
#include "incremental_driver/classic_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

using element::unit_tensor;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double no_void_ratio = 1e-3;  // STATEV(7) below it: not initialised

// Places in STATEV, counted from 0; 0 ... 5 are h.
enum : std::size_t {
    void_ratio = 6,
    pore_stress = 7,
    effective_pressure = 8,
    evaluation_count = 9,
    mobilised_angle = 10,
    rho = 11,
    substep = 12,
    separation = 13  // if there is room
};

}  // namespace

ClassicLaw::ClassicLaw(ClassicSand given, int nstatv) : sand(std::move(given)) {
    for (int i = 1; i <= nstatv; ++i) names.push_back(element::text("statev(%d)", i));
}

// As the library has it: effective stress, its own order of the state.
element::MaterialPoint ClassicLaw::effective(const element::MaterialPoint& classic) const {
    const std::vector<double>& statev = classic.state;
    element::MaterialPoint out;
    out.stress = classic.stress - statev[pore_stress] * unit_tensor();
    out.state.assign(sand.law->state_names().size(), 0.0);
    std::copy_n(statev.begin(), 6, out.state.begin());
    out.state[GRIT_SAND_VOID_RATIO] = statev[void_ratio];
    if (statev.size() > separation) out.state[GRIT_SAND_SEPARATION] = statev[separation];
    out.state[element::GritLaw::substep_index] = statev[substep];
    if (statev[void_ratio] < no_void_ratio)
        out.state[GRIT_SAND_VOID_RATIO] = void_ratio_at(sand, -out.stress.head<3>().sum() / 3.0);
    return out;
}

element::Response ClassicLaw::advance(const element::MaterialPoint& start,
                                      const element::StrainIncrement& increment) const {
    element::Response out = sand.law->advance(effective(start), increment);
    if (out.outcome != element::Outcome::done) return out;
    const element::MaterialPoint end = std::move(out.end);
    const grit_sand_invariants invariants = sand.law->invariants(end);
    std::vector<double> statev = start.state;
    std::copy_n(end.state.begin(), 6, statev.begin());
    statev[void_ratio] = end.state[GRIT_SAND_VOID_RATIO];
    statev[pore_stress] += sand.K_w * increment.strain.head<3>().sum();  // (W1)
    statev[effective_pressure] = invariants.p;
    statev[evaluation_count] = out.evaluations;
    statev[mobilised_angle] = invariants.mobilised_friction_angle / degree;
    statev[rho] = invariants.rho;
    statev[substep] = end.state[element::GritLaw::substep_index];
    if (statev.size() > separation) statev[separation] = end.state[GRIT_SAND_SEPARATION];
    out.end.stress = end.stress + statev[pore_stress] * unit_tensor();
    out.end.state = std::move(statev);
    out.tangent.topLeftCorner<3, 3>().array() += sand.K_w;
    return out;
}

element::Observation ClassicLaw::observe(const element::MaterialPoint& point) const {
    return {point.state[void_ratio], -point.state[pore_stress]};
}

void ClassicLaw::check(const element::MaterialPoint& start) const {
    const element::Response null_step = advance(start, {});
    if (null_step.outcome != element::Outcome::done) throw element::BadCase(null_step.message);
}

}  // namespace incremental_driver
