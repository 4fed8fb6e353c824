// SPDX-License-Identifier: BSD-3-Clause
#include "element/grit_law.hpp"

#include <algorithm>
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

namespace {

// One point, whose stress and state become those of the end.
grit_sand_points points_of(const StrainIncrement& increment, MaterialPoint& end) {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(increment.strain.data(), 6, 1);
    if (increment.rotation != Matrix3::Identity())
        q.rotation_increment = grit_view_of(increment.rotation.data(), 9, 1);
    q.stress = grit_mutable_view_of(end.stress.data(), 6, 1);
    q.state = grit_mutable_view_of(end.state.data(), GRIT_SAND_STATE_SIZE, 1);
    q.substep = grit_mutable_view_of(&end.state[GritLaw::substep_index], 1, 1);
    return q;
}

// What an update has said of its point; false: not done.
bool take(const grit_sand_report& report, const grit_error& error, Response& out) {
    out.evaluations = report.evaluations;
    out.stress_free = (report.flags & GRIT_SAND_STRESS_FREE) != 0;
    if (out.outcome == Outcome::done) return true;
    out.message = error.message;
    out.reduction = report.step_reduction;
    return false;
}

}  // namespace

Response GritLaw::advance(const MaterialPoint& start, const StrainIncrement& increment) const {
    Response out;
    out.end = start;
    MaterialPoint& end = out.end;
    end.stress += pore_pressure(start) * unit_tensor();
    grit_sand_points q = points_of(increment, end);
    q.tangent = grit_mutable_matrix_view_of(out.tangent.data(), 36, 6, 1);
    grit_sand_report report{};
    grit_error error{};
    Vector6 total;
    double p_w = has_water ? start.state[pore_pressure_index] : 0.0;
    grit_sand_water wet = water;
    wet.pore_pressure = grit_mutable_view_of(&p_w, 1, 1);
    wet.total_stress = grit_mutable_view_of(total.data(), 6, 1);
    out.outcome =
        outcome_of(grit_sand_update_undrained(&prepared, &options, &wet, 1, &q, &report, &error));
    if (!take(report, error, out)) return out;
    end.stress = total;
    if (has_water) end.state[pore_pressure_index] = p_w;
    return out;
}

Response GritLaw::differentiate(const MaterialPoint& start, const StrainIncrement& increment,
                                const Directions& parameters, const Matrix6X& strain_slopes,
                                PointSlopes& slopes) const {
    const Eigen::Index count = strain_slopes.cols();
    std::vector<int> of(static_cast<std::size_t>(count), GRIT_SAND_NO_PARAMETER);
    std::copy(parameters.begin(), parameters.end(), of.begin());
    Response out;
    out.end = start;
    MaterialPoint& end = out.end;
    end.stress += pore_pressure(start) * unit_tensor();
    PointSlopes of_end = slopes;
    if (has_water)
        of_end.stress.topRows<3>().rowwise() +=
            bearing(start) * slopes.state.row(pore_pressure_index);
    const grit_sand_points q = points_of(increment, end);
    grit_sand_derivatives d{};
    d.struct_size = sizeof d;
    d.count = static_cast<int>(count);
    d.parameters = of.data();
    d.strain_increment = grit_matrix_view_of(strain_slopes.data(), 6 * count, count, 1);
    d.stress = grit_mutable_matrix_view_of(of_end.stress.data(), 6 * count, count, 1);
    d.state = grit_mutable_matrix_view_of(of_end.state.data(), of_end.state.size(), count, 1);
    grit_sand_options without_tangent = options;
    without_tangent.tangent = GRIT_TANGENT_NONE;
    grit_sand_report report{};
    grit_error error{};
    out.outcome = outcome_of(
        grit_sand_update_differentiated(&prepared, &without_tangent, &d, 1, &q, &report, &error));
    if (!take(report, error, out)) return out;
    if (has_water) {
        end.state[pore_pressure_index] = water_pressure_after(start, end, increment.strain);
        const Eigen::RowVectorXd e_before = slopes.state.row(GRIT_SAND_VOID_RATIO);
        differentiate_water(start, end, strain_slopes, e_before, of_end);
        end.stress -= pore_pressure(end) * unit_tensor();
    }
    slopes = std::move(of_end);
    return out;
}

// (W1), as in grit/sand_water.h.
double GritLaw::water_pressure_after(const MaterialPoint& start, const MaterialPoint& end,
                                     const Vector6& strain_increment) const {
    const double p = start.state[pore_pressure_index];
    if (water.porosity > 0.0)
        return p - water.bulk_modulus / water.porosity * strain_increment.head<3>().sum();
    return p - water.bulk_modulus *
                   std::log(end.state[GRIT_SAND_VOID_RATIO] / start.state[GRIT_SAND_VOID_RATIO]);
}

void GritLaw::differentiate_water(const MaterialPoint& start, const MaterialPoint& end,
                                  const Matrix6X& strain_slopes, const Eigen::RowVectorXd& e_before,
                                  PointSlopes& slopes) const {
    auto p = slopes.state.row(pore_pressure_index);
    if (water.porosity > 0.0)
        p -= water.bulk_modulus / water.porosity * strain_slopes.topRows<3>().colwise().sum();
    else
        p -= water.bulk_modulus *
             (slopes.state.row(GRIT_SAND_VOID_RATIO) / end.state[GRIT_SAND_VOID_RATIO] -
              e_before / start.state[GRIT_SAND_VOID_RATIO]);
    slopes.stress.topRows<3>().rowwise() -= bearing(end) * p;
}

double GritLaw::bearing(const MaterialPoint& point) const {
    const double p = point.state[pore_pressure_index];
    return borne(p) == p ? 1.0 : 0.0;
}

Observation GritLaw::observe(const MaterialPoint& point) const {
    Observation out;
    out.void_ratio = point.state[GRIT_SAND_VOID_RATIO];
    if (has_water) out.pore_pressure = pore_pressure(point);
    return out;
}

ObservedSlopes GritLaw::observe(const MaterialPoint& point, const PointSlopes& slopes) const {
    ObservedSlopes out;
    out.void_ratio = slopes.state.row(GRIT_SAND_VOID_RATIO);
    out.pore_pressure = Eigen::RowVectorXd::Zero(slopes.state.cols());
    if (has_water) out.pore_pressure = bearing(point) * slopes.state.row(pore_pressure_index);
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
