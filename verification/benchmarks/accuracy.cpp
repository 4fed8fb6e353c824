// SPDX-License-Identifier: BSD-3-Clause
// Evaluations of the rate and error delivered, per increment and tolerance, over single calls from
// 320 states (verification/data/speed_states.csv, integrated to 1e-13).
#include <cstdio>
#include <vector>

#include "sand_points.hpp"

using namespace benchmarks;

int main() {
    const grit_sand sand = lausitz();

    std::printf(
        "increment  tolerance   evaluations      stress error / |stress|         h error/R  "
        "delivered <= asked\n");
    std::printf(
        "                       p50 p90  max     p50      p90      max           max        "
        "share   worst ratio\n");
    for (const auto& [increment, list] : all_calls())
        for (const double tolerance :
             {1e-2, 5e-3, 3e-3, 1e-3, GRIT_SAND_DEFAULT_TOLERANCE, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
            std::vector<double> evaluations, errors, h_errors;
            int within = 0, failures = 0;
            SandPoints points = SandPoints::structures(list, list.size());
            const grit_sand_options options = SandRequest{increment, tolerance}.options();
            update(sand, options, points, 0, list.size(), 1);
            for (std::size_t i = 0; i < list.size(); ++i) {
                failures += points.reports[i].status != GRIT_OK;
                errors.push_back(stress_error(list[i], &points.stress[6 * i]));
                h_errors.push_back(intergranular_error(list[i], &points.state[8 * i]));
                evaluations.push_back(points.reports[i].evaluations);
                within += errors.back() <= tolerance;
            }
            std::printf("%9.0e  %9.0e  %4.0f %4.0f %4.0f  %8.1e %8.1e %8.1e  %8.1e   %7.4f  %8.2g",
                        increment, tolerance, percentile(evaluations, 0.5),
                        percentile(evaluations, 0.9), percentile(evaluations, 1.0),
                        percentile(errors, 0.5), percentile(errors, 0.9), percentile(errors, 1.0),
                        percentile(h_errors, 1.0), within / static_cast<double>(list.size()),
                        percentile(errors, 1.0) / tolerance);
            std::printf(failures ? "  %d FAILED\n" : "\n", failures);
        }
}
