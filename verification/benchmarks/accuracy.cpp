// SPDX-License-Identifier: BSD-3-Clause
// Evaluations of the rate and error delivered, per increment and tolerance, over single calls from
// 320 states (verification/data/speed_states.csv, integrated to 1e-13).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "single_calls.hpp"

namespace {

using namespace benchmarks;

double norm(const double* s, double shear_weight) {
    return std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] +
                     shear_weight * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

double percentile(std::vector<double> x, double q) {
    std::sort(x.begin(), x.end());
    return x[std::min(x.size() - 1, static_cast<std::size_t>(q * static_cast<double>(x.size())))];
}

}  // namespace

int main() {
    const auto calls = read_calls(GRIT_DATA "/speed_states.csv");
    const grit_sand sand = lausitz();

    std::printf(
        "increment  tolerance   evaluations      stress error / |stress|         h error/R  "
        "delivered <= asked\n");
    std::printf(
        "                       p50 p90  max     p50      p90      max           max        "
        "share   worst ratio\n");
    for (const auto& [increment, list] : calls)
        for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
            std::vector<double> evaluations, errors, h_errors;
            int within = 0, failures = 0;
            for (const Call& c : list) {
                Call x = c;
                grit_sand_options options;
                grit_sand_options_init(&options, sizeof options);
                options.tolerance = tolerance;
                grit_sand_points q{};
                q.struct_size = sizeof q;
                q.strain_increment = grit_view_of(x.strain, 6, 1);
                q.stress = grit_mutable_view_of(x.stress, 6, 1);
                q.state = grit_mutable_view_of(x.state, 8, 1);
                grit_sand_report report;
                if (grit_sand_update(&sand, &options, 1, &q, &report, nullptr) != GRIT_OK)
                    ++failures;
                double dT[6], dh[6];
                for (int i = 0; i < 6; ++i) {
                    dT[i] = x.stress[i] - c.stress_end[i];
                    dh[i] = x.state[i] - c.h_end[i];
                }
                const double error = norm(dT, 2.0) / norm(c.stress_end, 2.0);
                errors.push_back(error);
                h_errors.push_back(norm(dh, 0.5) / 1e-4);
                evaluations.push_back(report.evaluations);
                within += error <= tolerance;
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
