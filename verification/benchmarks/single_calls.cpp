// SPDX-License-Identifier: BSD-3-Clause
#include "single_calls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/tables/csv.hpp"

namespace benchmarks {
namespace {

double norm(const double* a, const double* b, double shear_weight) {
    double sum = 0.0;
    for (int i = 0; i < 6; ++i) {
        const double d = a[i] - (b ? b[i] : 0.0);
        sum += (i < 3 ? 1.0 : shear_weight) * d * d;
    }
    return std::sqrt(sum);
}

constexpr double R = 1e-4;  // of Lausitz sand

std::map<double, std::vector<Call>> read_calls(const std::string& path) {
    std::map<double, std::vector<Call>> calls;
    const grit::csv::Numbers table = grit::csv::read_numbers(path);
    if (table.names.size() != 33) throw std::runtime_error("not the columns of calls: " + path);
    for (const std::vector<double>& row : table.rows) {
        const double* next = row.data();
        const double increment = *next++;
        Call c{};
        const auto take = [&](double* to, int count) {
            std::copy_n(next, count, to);
            next += count;
        };
        take(c.stress, 6);
        take(c.state, 7);
        take(c.strain, 6);
        take(c.stress_end, 6);
        take(c.h_end, 6);
        take(&c.e_end, 1);
        calls[increment].push_back(c);
    }
    return calls;
}

}  // namespace

const std::map<double, std::vector<Call>>& all_calls() {
    static const auto all = read_calls(GRIT_DATA "/speed_states.csv");
    return all;
}

const std::vector<Call>& calls_of(double increment) {
    const auto& all = all_calls();
    const auto distance = [increment](const auto& entry) {
        return std::fabs(std::log(entry.first / increment));
    };
    return std::min_element(all.begin(), all.end(),
                            [&](const auto& a, const auto& b) { return distance(a) < distance(b); })
        ->second;
}

grit_sand lausitz() {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &parameters);
    grit_sand sand;
    grit_sand_prepare(&parameters, &sand, nullptr);
    return sand;
}

double stress_error(const Call& call, const double stress[6]) {
    return norm(stress, call.stress_end, 2.0) / norm(call.stress_end, nullptr, 2.0);
}

double intergranular_error(const Call& call, const double h[6]) {
    return norm(h, call.h_end, 0.5) / R;
}

double percentile(std::vector<double> x, double q) {
    if (x.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(x.begin(), x.end());
    return x[std::min(x.size() - 1, static_cast<std::size_t>(q * static_cast<double>(x.size())))];
}

}  // namespace benchmarks
