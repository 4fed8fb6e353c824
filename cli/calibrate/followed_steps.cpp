// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/followed_steps.hpp"

#include <algorithm>
#include <cmath>

#include "element/schedule.hpp"

namespace cli {
namespace {

// Increments of strain after a turn: a fifth of the way since, between these. The intergranular strain turns within
// some 1e-4.
constexpr double least_strain = 2e-5, largest_strain = 0.01, share_of_way = 0.2;
// Of stress: this share of what it is, but not less than that of the largest.
constexpr double share_of_stress = 0.1, least_share_of_largest = 0.005;
constexpr int more_after_turn = 6;

double increment_after(double way) {
    return std::clamp(share_of_way * way, least_strain, largest_strain);
}

// Increments from a turn to so far from it: the integral of d way/increment_after.
double increments_to(double way) {
    constexpr double even = least_strain / share_of_way, full = largest_strain / share_of_way;
    double out = std::min(way, even) / least_strain;
    if (way > even) out += std::log(std::min(way, full) / even) / share_of_way;
    if (way > full) out += (way - full) / largest_strain;
    return out;
}

// Shares of the way from row to row, from 0 to 1.
std::vector<double> shares(double exact, double first_share) {
    const int count = std::max(1, static_cast<int>(std::ceil(exact - 1e-9)));
    const bool graded = count > 1 && first_share * count < 1.0;
    return element::schedule(count, graded ? first_share : 0.0);
}

}  // namespace

Followed follow(const Way& way, const std::vector<double>& values, double resolution) {
    Followed out;
    out.step = way.step(1.0);
    element::Imported path;
    path.rows = std::get<element::Linear>(out.step.kind).rows;
    const element::Vector6& unit = std::get<element::Linear>(out.step.kind).change;
    for (std::size_t r = 0; r < 6; ++r)
        if (unit[static_cast<int>(r)] != 0.0)
            path.columns[r] = {0, way.sign * unit[static_cast<int>(r)]};
    double largest = 0.0, since = 0.0;  // the last turn
    double before = 0.0;  // the last change that was one: a row that is repeated turns nothing
    for (const double each : values) largest = std::max(largest, std::abs(each));
    path.table.push_back({values.front()});
    out.increments.push_back(0);
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double change = values[i] - values[i - 1], length = std::abs(change);
        const bool turned = i == 1 || change * before < 0.0;
        if (change != 0.0) before = change;
        if (turned) since = 0.0;
        std::vector<double> parts;
        if (way.strain()) {
            parts = shares(resolution * (increments_to(since + length) - increments_to(since)),
                           length > 0.0 ? increment_after(since) / resolution / length : 0.0);
        } else {
            const double fair =
                std::max(share_of_stress * std::min(std::abs(values[i]), std::abs(values[i - 1])),
                         least_share_of_largest * largest);
            parts = shares(resolution * (length / fair + (turned ? more_after_turn : 0)),
                           turned ? 0.02 / resolution : 0.0);
        }
        for (std::size_t k = 1; k < parts.size(); ++k)
            path.table.push_back({values[i - 1] + parts[k] * change});
        out.increments.push_back(static_cast<int>(path.table.size()) - 1);
        since += length;
    }
    out.step.kind = std::move(path);
    return out;
}

}  // namespace cli
