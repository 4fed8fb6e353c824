// SPDX-License-Identifier: BSD-3-Clause
#include "element/grit_law.hpp"

#include <cmath>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// For calls that fail only if this library misuses libgrit.
void expect(grit_status status, const char* function) {
    if (status != GRIT_OK)
        throw BadCase(text("%s refused the call: %s", function, grit_status_name(status)));
}

Outcome outcome_of(grit_status status) {
    if (status == GRIT_OK) return Outcome::done;
    return status == GRIT_NOT_CONVERGED ? Outcome::retry_smaller : Outcome::hopeless;
}

}  // namespace

grit_sand_options usual_options() {
    grit_sand_options out;
    expect(grit_sand_options_init(&out, sizeof out), "grit_sand_options_init");
    return out;
}

GritLaw::GritLaw(const grit_sand_parameters& parameters, const GritLawOptions& given)
    : has_water(given.has_water()), names{"h_11", "h_22",       "h_33",       "h_12",   "h_13",
                                          "h_23", "void_ratio", "separation", "substep"} {
    grit_error error{};
    if (grit_sand_prepare(&parameters, &prepared, &error) != GRIT_OK) throw BadCase(error.message);
    options = usual_options();
    if (!(given.tolerance >= GRIT_SAND_LEAST_TOLERANCE &&
          given.tolerance <= GRIT_SAND_LARGEST_TOLERANCE))
        throw BadCase(text("tolerance must be in [%g, %g], got %g", GRIT_SAND_LEAST_TOLERANCE,
                           GRIT_SAND_LARGEST_TOLERANCE, given.tolerance));
    if (given.evaluation_limit < GRIT_SAND_LEAST_EVALUATION_LIMIT ||
        given.evaluation_limit > GRIT_SAND_LARGEST_EVALUATION_LIMIT)
        throw BadCase(text("evaluation_limit must be in [%d, %d], got %d",
                           GRIT_SAND_LEAST_EVALUATION_LIMIT, GRIT_SAND_LARGEST_EVALUATION_LIMIT,
                           given.evaluation_limit));
    read_water(given);
    options.tolerance = given.tolerance;
    options.evaluation_limit = given.evaluation_limit;
    options.tangent = GRIT_TANGENT_CONSISTENT;
    options.intergranular_off = !given.intergranular_strain;
    if (given.intergranular_strain && std::isnan(parameters.elastic_strain_radius))
        throw BadCase("this sand has no parameters of the intergranular strain (m_R, m_T, R, "
                      "beta_r, chi): give them, or set intergranular_strain = \"off\"");
    if (has_water) names.emplace_back("pore_pressure");
}

void GritLaw::read_water(const GritLawOptions& given) {
    for (const double K : {given.water_stiffness, given.water_bulk_modulus})
        if (!(K >= 0.0) || !std::isfinite(K))
            throw BadCase(text("the stiffness of the pore water must be >= 0 [stress], got %g", K));
    if (given.water_stiffness > 0.0 && given.water_bulk_modulus > 0.0)
        throw BadCase(
            "pore water has the stiffness of the mixture or its own bulk modulus, not both");
    if (!(given.largest_tension >= 0.0))
        throw BadCase(text("the largest tension of the pore water must be >= 0 [stress], got %g",
                           given.largest_tension));
    expect(grit_sand_water_init(&water, sizeof water), "grit_sand_water_init");
    water.bulk_modulus = given.water_stiffness + given.water_bulk_modulus;
    water.porosity = given.water_bulk_modulus > 0.0 ? 0.0 : 1.0;
    water.largest_tension = given.largest_tension;
}

MaterialPoint GritLaw::start(const Vector6& effective_stress, double void_ratio,
                             double pore_pressure) const {
    if (!(void_ratio > 0.0) || !std::isfinite(void_ratio))
        throw BadCase(text("void ratio must be > 0, got %g", void_ratio));
    if (!effective_stress.allFinite()) throw BadCase("the initial stress must be finite");
    if (!std::isfinite(pore_pressure)) throw BadCase("the initial pore pressure must be finite");
    if (pore_pressure != 0.0 && !has_water)
        throw BadCase("a pore pressure at the start needs pore water in the sand");
    MaterialPoint point;
    point.state.assign(names.size(), 0.0);
    point.state[GRIT_SAND_VOID_RATIO] = void_ratio;
    if (has_water) point.state[pore_pressure_index] = pore_pressure;
    point.stress = effective_stress - this->pore_pressure(point) * unit_tensor();
    return point;
}

void GritLaw::mobilise(MaterialPoint& point, const Vector6& direction, double rho) const {
    if (options.intergranular_off) throw BadCase("the intergranular strain is off");
    if (!(rho >= 0.0 && rho <= 1.0))
        throw BadCase(text("rho = |h|/R must be in [0, 1], got %g", rho));
    if (grit_sand_mobilise(&prepared, direction.data(), rho, point.state.data()) != GRIT_OK)
        throw BadCase("the direction of the intergranular strain must be finite and not zero");
}

double GritLaw::pore_pressure(const MaterialPoint& point) const {
    return has_water ? borne(point.state[pore_pressure_index]) : 0.0;
}

Response GritLaw::advance(const MaterialPoint& start, const StrainIncrement& increment) const {
    Response out;
    out.end = start;
    MaterialPoint& end = out.end;
    end.stress += pore_pressure(start) * unit_tensor();
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(increment.strain.data(), 6, 1);
    if (increment.rotation != Matrix3::Identity())
        q.rotation_increment = grit_view_of(increment.rotation.data(), 9, 1);
    q.stress = grit_mutable_view_of(end.stress.data(), 6, 1);
    q.state = grit_mutable_view_of(end.state.data(), GRIT_SAND_STATE_SIZE, 1);
    q.tangent = grit_mutable_matrix_view_of(out.tangent.data(), 36, 6, 1);
    q.substep = grit_mutable_view_of(&end.state[substep_index], 1, 1);
    grit_sand_report report{};
    grit_error error{};
    Vector6 total;
    double p_w = has_water ? start.state[pore_pressure_index] : 0.0;
    grit_sand_water wet = water;
    wet.pore_pressure = grit_mutable_view_of(&p_w, 1, 1);
    wet.total_stress = grit_mutable_view_of(total.data(), 6, 1);
    out.outcome =
        outcome_of(grit_sand_update_undrained(&prepared, &options, &wet, 1, &q, &report, &error));
    out.evaluations = report.evaluations;
    out.stress_free = (report.flags & GRIT_SAND_STRESS_FREE) != 0;
    if (out.outcome != Outcome::done) {
        out.message = error.message;
        out.reduction = report.step_reduction;
        return out;
    }
    end.stress = total;
    if (has_water) end.state[pore_pressure_index] = p_w;
    return out;
}

Observation GritLaw::observe(const MaterialPoint& point) const {
    Observation out;
    out.void_ratio = point.state[GRIT_SAND_VOID_RATIO];
    if (has_water) out.pore_pressure = pore_pressure(point);
    return out;
}

grit_sand_invariants GritLaw::invariants(const MaterialPoint& point) const {
    grit_sand_invariants out{};
    out.struct_size = sizeof out;
    const Vector6 effective = point.stress + pore_pressure(point) * unit_tensor();
    expect(grit_sand_invariants_of(&prepared, effective.data(), point.state.data(), &out),
           "grit_sand_invariants_of");
    return out;
}

}  // namespace element
