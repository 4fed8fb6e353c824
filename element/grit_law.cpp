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
    : water_stiffness(given.water_stiffness), names{"h_11",       "h_22",       "h_33",
                                                    "h_12",       "h_13",       "h_23",
                                                    "void_ratio", "separation", "substep"} {
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
    if (!(water_stiffness >= 0.0) || !std::isfinite(water_stiffness))
        throw BadCase(
            text("the stiffness of the pore water must be >= 0 [stress], got %g", water_stiffness));
    options.tolerance = given.tolerance;
    options.evaluation_limit = given.evaluation_limit;
    options.tangent = GRIT_TANGENT_CONSISTENT;
    options.intergranular_off = !given.intergranular_strain;
    if (given.intergranular_strain && std::isnan(parameters.elastic_strain_radius))
        throw BadCase("this sand has no parameters of the intergranular strain (m_R, m_T, R, "
                      "beta_r, chi): give them, or set intergranular_strain = \"off\"");
    if (water_stiffness > 0.0) names.emplace_back("pore_pressure");
}

MaterialPoint GritLaw::start(const Vector6& effective_stress, double void_ratio) const {
    if (!(void_ratio > 0.0) || !std::isfinite(void_ratio))
        throw BadCase(text("void ratio must be > 0, got %g", void_ratio));
    if (!effective_stress.allFinite()) throw BadCase("the initial stress must be finite");
    MaterialPoint point;
    point.stress = effective_stress;
    point.state.assign(names.size(), 0.0);
    point.state[GRIT_SAND_VOID_RATIO] = void_ratio;
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
    return water_stiffness > 0.0 ? point.state[pore_pressure_index] : 0.0;
}

Response GritLaw::advance(const MaterialPoint& start, const StrainIncrement& increment) const {
    Response out;
    out.end = start;
    MaterialPoint& end = out.end;
    const double p_w = pore_pressure(start);
    end.stress += p_w * unit_tensor();
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
    out.outcome = outcome_of(grit_sand_update(&prepared, &options, 1, &q, &report, &error));
    out.evaluations = report.evaluations;
    out.stress_free = (report.flags & GRIT_SAND_STRESS_FREE) != 0;
    if (out.outcome != Outcome::done) {
        out.message = error.message;
        out.reduction = report.step_reduction;
        return out;
    }
    if (water_stiffness > 0.0) {  // (W1)
        double& p_w_end = end.state[pore_pressure_index];
        p_w_end -= water_stiffness * increment.strain.head<3>().sum();
        end.stress -= p_w_end * unit_tensor();
        out.tangent.topLeftCorner<3, 3>().array() += water_stiffness;
    }
    return out;
}

Observation GritLaw::observe(const MaterialPoint& point) const {
    Observation out;
    out.void_ratio = point.state[GRIT_SAND_VOID_RATIO];
    if (water_stiffness > 0.0) out.pore_pressure = pore_pressure(point);
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
