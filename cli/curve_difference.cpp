// SPDX-License-Identifier: BSD-3-Clause
#include "cli/curve_difference.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cli {
namespace {

using Values = std::vector<double>;

double variation(const Values& x) {
    double sum = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) sum += std::abs(x[i] - x[i - 1]);
    return sum;
}

// First rows of the monotone stretches of x, and the last row. Noise below 1e-13 is no turn.
std::vector<std::size_t> turns(const Values& x) {
    std::vector<std::size_t> out = {0};
    double direction = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double step = x[i] - x[i - 1];
        if (std::abs(step) < 1e-13) continue;
        if (step * direction < 0.0) out.push_back(i - 1);
        direction = step;
    }
    out.push_back(x.size() - 1);
    return out;
}

// y at x = at by Lagrange's cubic through four of the rows first ... last, monotone in x.
double cubic(const Values& x, const Values& y, std::size_t first, std::size_t last, double at) {
    const bool falling = x[last] < x[first];
    std::size_t right = first + 1;
    while (right < last && (falling ? x[right] > at : x[right] < at)) ++right;
    const std::size_t count = std::min<std::size_t>(4, last - first + 1);
    std::size_t from = right >= first + 2 ? right - 2 : first;
    from = std::min(from, last + 1 - count);
    double sum = 0.0;
    for (std::size_t i = from; i < from + count; ++i) {
        double weight = y[i];
        for (std::size_t j = from; j < from + count; ++j)
            if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
        sum += weight;
    }
    return sum;
}

// Rows that repeat the strain of the one before (a stage that starts anew) would divide by zero.
Table without_repetitions(const Table& table, const std::string& along) {
    const Values& x = table.at(along);
    Table out = table;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        out.columns[c].values.clear();
        for (std::size_t i = 0; i < x.size(); ++i)
            if (i == 0 || std::abs(x[i] - x[i - 1]) > 1e-14)
                out.columns[c].values.push_back(table.columns[c].values[i]);
    }
    return out;
}

std::string longest_strain(const Table& reference) {
    std::string best;
    double most = 0.0;
    for (const char* name :
         {"strain_11", "strain_22", "strain_33", "gamma_12", "gamma_13", "gamma_23"})
        if (const Values* x = reference.find(name); x && variation(*x) > most) {
            most = variation(*x);
            best = name;
        }
    return best;
}

}  // namespace

CurveDifference difference(const Table& computed, const Table& wanted) {
    CurveDifference out;
    const std::string along = longest_strain(wanted);
    if (along.empty()) {
        out.problem = "the reference has no strain components";
        return out;
    }
    const Table result = without_repetitions(computed, along);
    const Table reference = without_repetitions(wanted, along);
    const Values &x = result.at(along), &x_ref = reference.at(along);
    const auto a = turns(x), b = turns(x_ref);
    if (a.size() != b.size() || x.size() < 2) {
        out.problem = fmt::format("{} turns {} times, in the reference {} times", along,
                                  a.size() - 2, b.size() - 2);
        return out;
    }
    double largest = 0.0;
    for (const char* name : {"stress_11", "stress_22", "stress_33", "stress_12", "stress_13",
                             "stress_23", "void_ratio"}) {
        const Values* y_ref = reference.find(name);
        if (!y_ref) continue;
        const bool stress = std::string(name) != "void_ratio";
        double& worst = stress ? out.stress : out.void_ratio;
        for (std::size_t leg = 0; leg + 1 < a.size(); ++leg)
            for (std::size_t i = b[leg]; i <= b[leg + 1]; ++i) {
                const double y = cubic(x, result.at(name), a[leg], a[leg + 1], x_ref[i]);
                const double d = std::abs(y - (*y_ref)[i]);
                worst = std::isnan(d) ? d : std::max(worst, d);
                if (stress) largest = std::max(largest, std::abs((*y_ref)[i]));
            }
    }
    if (largest > 0.0) out.stress /= largest;
    return out;
}

}  // namespace cli
