// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/curve_difference.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "cli/element/turns.hpp"

namespace cli {
namespace {

using Values = std::vector<double>;

constexpr double noise = 1e-13;  // of strain

double variation(const Values& x) {
    double sum = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) sum += std::abs(x[i] - x[i - 1]);
    return sum;
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
            if (i == 0 || std::abs(x[i] - x[i - 1]) > noise / 10.0)
                out.columns[c].values.push_back(table.columns[c].values[i]);
    }
    return out;
}

constexpr const char* strains[] = {"strain_11", "strain_22", "strain_33",
                                   "gamma_12",  "gamma_13",  "gamma_23"};
constexpr const char* measured_strains[] = {"axial_strain", "shear_strain"};
constexpr const char* components[] = {"stress_11", "stress_22", "stress_33",
                                      "stress_12", "stress_13", "stress_23"};
constexpr const char* invariants[] = {"axial_deviator", "p"};

std::string longest_of(const Table& reference, std::span<const char* const> names) {
    std::string best;
    double most = 0.0;
    for (const char* name : names)
        if (const Values* x = reference.find(name); x && variation(*x) > most) {
            most = variation(*x);
            best = name;
        }
    return best;
}

std::string longest_strain(const Table& reference) {
    const std::string component = longest_of(reference, strains);
    return component.empty() ? longest_of(reference, measured_strains) : component;
}

// Where a result ends a little early or late, under stress control, the cubic may go on for so much of
// the stretch.
constexpr double little = 1e-3;

struct Stretch {
    std::size_t first, last;  // rows

    bool covers(const Values& x, double at) const {
        const auto [low, high] = std::minmax(x[first], x[last]);
        const double margin = little * (high - low);
        return at >= low - margin && at <= high + margin;
    }
};

}  // namespace

std::vector<std::string> compared_columns(const Table& reference) {
    std::vector<std::string> out = {longest_strain(reference), "void_ratio"};
    for (const char* name : components)
        if (reference.find(name)) out.emplace_back(name);
    if (out.size() > 2) return out;
    for (const char* name : invariants)
        if (reference.find(name)) out.emplace_back(name);
    return out;
}

std::string incomparable(const Table& reference) {
    if (longest_strain(reference).empty()) return "the reference has no strain that changes";
    if (compared_columns(reference).size() == 2 && !reference.find("void_ratio"))
        return "the reference has neither stress nor void ratio";
    return "";
}

CurveDifference difference(const Table& computed, const Table& wanted) {
    CurveDifference out;
    out.problem = incomparable(wanted);
    if (!out.problem.empty()) return out;
    const std::string along = longest_strain(wanted);
    const Table result = without_repetitions(computed, along);
    const Table reference = without_repetitions(wanted, along);
    const Values &x = result.at(along), &x_ref = reference.at(along);
    const auto a = turning_rows(x, noise), b = turning_rows(x_ref, noise);
    if (a.size() != b.size() || x.size() < 2) {
        out.problem = fmt::format("{} turns {} times, in the reference {} times", along,
                                  a.size() - 2, b.size() - 2);
        return out;
    }
    double largest = 0.0;
    long points = 0;
    for (const std::string& name : compared_columns(reference)) {
        const Values* y_ref = reference.find(name);
        if (!y_ref || name == along) continue;
        const bool stress = name != "void_ratio";
        double& worst = stress ? out.stress : out.void_ratio;
        for (std::size_t leg = 0; leg + 1 < a.size(); ++leg) {
            const Stretch stretch{a[leg], a[leg + 1]};
            for (std::size_t i = b[leg]; i <= b[leg + 1]; ++i) {
                if (std::isnan((*y_ref)[i])) continue;  // an empty cell
                if (!stretch.covers(x, x_ref[i])) {
                    out.problem = fmt::format("the reference has {} = {:g}, the run goes from {:g} "
                                              "to {:g}",
                                              along, x_ref[i], x[stretch.first], x[stretch.last]);
                    return out;
                }
                const double y = cubic(x, result.at(name), stretch.first, stretch.last, x_ref[i]);
                const double d = std::abs(y - (*y_ref)[i]);
                worst = std::isnan(d) || std::isnan(worst) ? NAN : std::max(worst, d);
                if (stress) largest = std::max(largest, std::abs((*y_ref)[i]));
                ++points;
            }
        }
    }
    if (points == 0) out.problem = "the reference has no point to compare";
    if (largest > 0.0) out.stress /= largest;
    return out;
}

}  // namespace cli
