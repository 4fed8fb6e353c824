// SPDX-License-Identifier: BSD-3-Clause
#include "single_calls.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

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
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        double increment;
        Call c{};
        row >> increment;
        for (double& x : c.stress) row >> x;
        for (int i = 0; i < 7; ++i) row >> c.state[i];
        for (double& x : c.strain) row >> x;
        for (double& x : c.stress_end) row >> x;
        for (double& x : c.h_end) row >> x;
        row >> c.e_end;
        if (row) calls[increment].push_back(c);
    }
    if (calls.empty()) throw std::runtime_error("no states in " + path);
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
