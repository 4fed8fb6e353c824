// SPDX-License-Identifier: BSD-3-Clause
#include "paths/strain_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace paths {
namespace {

grit_sand_options options_of(const StrainPath& path, double tolerance) {
    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    options.tolerance = tolerance;
    options.evaluation_limit = 1000000;
    options.intergranular_off = path.intergranular_off;
    return options;
}

// |A| of a stress in the order 11 22 33 12 13 23.
double norm(const Six& A) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 6; ++c) sum += (c < 3 ? 1.0 : 2.0) * A[c] * A[c];
    return std::sqrt(sum);
}

Six difference(const Six& A, const Six& B) {
    Six r;
    for (std::size_t c = 0; c < 6; ++c) r[c] = A[c] - B[c];
    return r;
}

// One of them carries no stress, the other little more than where points open (docs/adr/0002): opening a call
// sooner or later is a jump, and no error of the integration.
bool about_to_open(const StrainPath& path, const Six& A, const Six& B) {
    const double most = 4.0 * path.opening_pressure;
    const double a = norm(A), b = norm(B);
    return (a == 0.0 || b == 0.0) && std::max(a, b) <= std::sqrt(3.0) * most;
}

}  // namespace

double opening_pressure(const grit_sand& sand) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    if (grit_sand_parameters_of(&sand, &p) != GRIT_OK)
        throw std::runtime_error("a sand that was not prepared");
    return 2e-8 * p.granulate_hardness;
}

Course run(const StrainPath& path, double tolerance) {
    const grit_sand_options options = options_of(path, tolerance);
    Six stress = path.stress, increment{};
    auto state = path.state;
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(increment.data(), 6, 1);
    q.stress = grit_mutable_view_of(stress.data(), 6, 1);
    q.state = grit_mutable_view_of(state.data(), GRIT_SAND_STATE_SIZE, 1);
    Course course;
    for (const Six& each : path.increments) {
        increment = each;
        grit_sand_report report;
        grit_error error;
        if (grit_sand_update(&path.sand, &options, 1, &q, &report, &error) != GRIT_OK)
            throw std::runtime_error(path.kind + " of " + path.sand_name + ": " + error.message);
        course.stress.push_back(stress);
        course.evaluations += report.evaluations;
    }
    return course;
}

bool opens(const Course& course) {
    return std::any_of(course.stress.begin(), course.stress.end(),
                       [](const Six& stress) { return norm(stress) == 0.0; });
}

double error(const StrainPath& path, const Course& course, const Course& exact) {
    double off = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < exact.stress.size(); ++i) {
        largest = std::max(largest, norm(exact.stress[i]));
        if (about_to_open(path, course.stress[i], exact.stress[i])) continue;
        const double here = norm(difference(course.stress[i], exact.stress[i]));
        off = here <= off ? off : here;  // what is not a number stays
    }
    return off / largest;
}

}  // namespace paths
