// SPDX-License-Identifier: BSD-3-Clause
#include "element/material.hpp"

#include <cmath>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// For calls that fail only if this library misuses libgrit.
void expect(grit_status status, const char* function) {
    if (status != GRIT_OK)
        throw BadCase(text("%s refused the case: %s", function, grit_status_name(status)));
}

}  // namespace

Material::Material(const Case& test) {
    grit_error error{};
    if (grit_sand_prepare(&test.parameters, &sand, &error) != GRIT_OK) throw BadCase(error.message);
    expect(grit_sand_options_init(&options, sizeof options), "grit_sand_options_init");
    if (!(test.numerics.tolerance >= 1e-12 && test.numerics.tolerance <= 0.1))
        throw BadCase(text("tolerance must be in [1e-12, 0.1], got %g", test.numerics.tolerance));
    options.tolerance = test.numerics.tolerance;
    options.evaluation_limit = test.numerics.evaluation_limit;
    options.tangent = GRIT_TANGENT_CONSISTENT;
    options.intergranular_off = test.start.intergranular_strain == IntergranularStrain::off;
    if (!options.intergranular_off && std::isnan(test.parameters.elastic_strain_radius))
        throw BadCase("this sand has no parameters of the intergranular strain (m_R, m_T, R, "
                      "beta_r, chi): give them, or set intergranular_strain = \"off\"");
}

double Material::start_void_ratio(const Start& start) const {
    if (start.void_ratio.has_value() == start.void_ratio_at_zero.has_value())
        throw BadCase("give either void_ratio or void_ratio_at_zero_pressure");
    double e = start.void_ratio.value_or(0.0);
    if (!start.void_ratio)
        expect(
            grit_sand_void_ratio_at_pressure(&sand, *start.void_ratio_at_zero, start.pressure, &e),
            "grit_sand_void_ratio_at_pressure");
    double limits[3];
    expect(grit_sand_void_ratios(&sand, start.pressure, limits), "grit_sand_void_ratios");
    if (!(e >= limits[2] && e <= limits[0]))
        throw BadCase(text("void ratio at %g kPa must be in [e_d, e_i] = [%.4f, %.4f], got %g",
                           start.pressure, limits[2], limits[0], e));
    return e;
}

Point Material::start(const Start& start) const {
    if (!(start.pressure > 0.0) || !std::isfinite(start.pressure))
        throw BadCase(text("pressure must be > 0 kPa, got %g kPa", start.pressure));
    Point point;
    point.stress.head<3>().setConstant(-start.pressure);
    point.state[GRIT_SAND_VOID_RATIO] = start_void_ratio(start);
    if (start.intergranular_strain == IntergranularStrain::mobilised) {
        const double compression[6] = {-1, -1, -1, 0, 0, 0};
        expect(grit_sand_mobilise(&sand, compression, 1.0, point.state.data()),
               "grit_sand_mobilise");
    }
    return point;
}

UpdateResult Material::update(const Vector6& strain_increment, Point& point,
                              Matrix6& tangent) const {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(strain_increment.data(), 6, 1);
    q.stress = grit_mutable_view_of(point.stress.data(), 6, 1);
    q.state = grit_mutable_view_of(point.state.data(), GRIT_SAND_STATE_SIZE, 1);
    q.tangent = grit_mutable_matrix_view_of(tangent.data(), 36, 6, 1);
    q.substep = grit_mutable_view_of(&point.substep, 1, 1);
    grit_sand_report report{};
    grit_error error{};
    UpdateResult result;
    result.status = grit_sand_update(&sand, &options, 1, &q, &report, &error);
    result.evaluations = report.evaluations;
    result.stress_free = (report.flags & GRIT_SAND_STRESS_FREE) != 0;
    if (result.status == GRIT_OK) point.strain += strain_increment;
    else result.message = error.message;
    return result;
}

grit_sand_invariants Material::invariants(const Point& point) const {
    grit_sand_invariants invariants{};
    invariants.struct_size = sizeof invariants;
    expect(grit_sand_invariants_of(&sand, point.stress.data(), point.state.data(), &invariants),
           "grit_sand_invariants_of");
    return invariants;
}

}  // namespace element
