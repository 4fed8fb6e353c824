// SPDX-License-Identifier: BSD-3-Clause
#include "element/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "element/schedule.hpp"

namespace element {
namespace {

using Table = std::vector<Vector6>;  // c at the knots

// Straight between the knots.
Vector6 interpolate(const std::vector<double>& knots, const Table& values, double x) {
    const auto after = std::lower_bound(knots.begin(), knots.end(), x);
    if (after == knots.begin()) return values.front();
    if (after == knots.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - knots.begin());
    const double t = (x - knots[i - 1]) / (knots[i] - knots[i - 1]);
    return values[i - 1] + t * (values[i] - values[i - 1]);
}

// Its slope; at a knot, of what ends there.
Vector6 slope_between(const std::vector<double>& knots, const Table& values, double x) {
    const auto after = std::lower_bound(knots.begin() + 1, knots.end() - 1, x);
    const auto i = static_cast<std::size_t>(after - knots.begin());
    return (values[i] - values[i - 1]) / (knots[i] - knots[i - 1]);
}

Vector6 change_of(const Linear& linear, const Sample& sample) {
    const Vector6 total = sample.point.stress - sample.pore_pressure * unit_tensor();
    const Vector6 now = linear.rows.stress * total + linear.rows.strain * sample.strain;
    Vector6 change = linear.change;
    for (int r = 0; r < 6; ++r)
        if (linear.absolute[static_cast<std::size_t>(r)]) change[r] -= now[r];
    return change;
}

Vector6 harmonic(const Circulating& c, double x) {
    const double angle = 2.0 * std::numbers::pi * c.cycles * x;
    Vector6 out = c.drift * x;
    for (int r = 0; r < 6; ++r)
        out[r] += c.amplitude[r] * (std::sin(angle + c.phase[r]) - std::sin(c.phase[r]));
    return out;
}

Vector6 harmonic_rate(const Circulating& c, double x) {
    const double frequency = 2.0 * std::numbers::pi * c.cycles;
    Vector6 out = c.drift;
    for (int r = 0; r < 6; ++r)
        out[r] += c.amplitude[r] * frequency * std::cos(frequency * x + c.phase[r]);
    return out;
}

// What incrementalDriver makes of the amplitude in increments of equal size.
Circulating as_midpoint_rate(Circulating c, int increments) {
    const double half = std::numbers::pi * c.cycles / increments;
    if (c.rate_at_midpoint && half > 0.0) c.amplitude *= half / std::sin(half);
    return c;
}

double column(const Imported& history, std::size_t row, const Imported::Column& c) {
    if (c.index < 0) return 0.0;
    const auto i = static_cast<std::size_t>(c.index);
    return c.factor * (history.table[row][i] - history.table[0][i]);
}

Table table_of(const Imported& history) {
    Table out;
    for (std::size_t row = 0; row < history.table.size(); ++row) {
        Vector6 c;
        for (int r = 0; r < 6; ++r)
            c[r] = column(history, row, history.columns[static_cast<std::size_t>(r)]);
        out.push_back(c);
    }
    return out;
}

// splitmix64 (Steele, Lea & Flood 2014): the same numbers everywhere.
double uniform(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1.0;  // [-1, 1)
}

Table table_of(const RandomWalk& walk, int increments) {
    std::uint64_t state = walk.seed;
    Table out{Vector6::Zero()};
    for (int i = 0; i < increments; ++i) {
        Vector6 c = out.back();
        for (int r = 0; r < 6; ++r) c[r] += walk.amplitude[r] * uniform(state);
        out.push_back(c);
    }
    return out;
}

void follow(Path& path, const Table& table) {
    path.change = [knots = path.knots, table](double x) { return interpolate(knots, table, x); };
    path.rate = [knots = path.knots, table](double x) { return slope_between(knots, table, x); };
}

}  // namespace

int increments_of(const Step& step) {
    if (const auto* imported = std::get_if<Imported>(&step.kind))
        return static_cast<int>(imported->table.size()) - 1;
    return step.increments;
}

std::vector<double> knots_of(const Step& step) {
    if (std::holds_alternative<Imported>(step.kind)) return schedule(increments_of(step), 0.0);
    return schedule(step.increments, step.first_share);
}

Path path_of(const Step& step, const Sample& sample) {
    Path path;
    path.knots = knots_of(step);
    path.time = [duration = step.duration](double x) { return duration * x; };
    if (const auto* linear = std::get_if<Linear>(&step.kind)) {
        path.rows = linear->rows;
        path.straight = true;
        const Vector6 whole = change_of(*linear, sample);
        path.change = [whole](double x) { return Vector6(x * whole); };
        path.rate = [whole](double) { return whole; };
    } else if (const auto* circulating = std::get_if<Circulating>(&step.kind)) {
        path.rows = circulating->rows;
        const Circulating c = as_midpoint_rate(*circulating, step.increments);
        path.change = [c](double x) { return harmonic(c, x); };
        path.rate = [c](double x) { return harmonic_rate(c, x); };
    } else if (const auto* imported = std::get_if<Imported>(&step.kind)) {
        path.rows = imported->rows;
        follow(path, table_of(*imported));
        if (imported->time.index >= 0) {
            Table times;
            for (std::size_t row = 0; row < imported->table.size(); ++row)
                times.push_back(Vector6::Constant(column(*imported, row, imported->time)));
            path.time = [knots = path.knots, times](double x) {
                return interpolate(knots, times, x)[0];
            };
        }
    } else if (const auto* walk = std::get_if<RandomWalk>(&step.kind)) {
        path.rows = walk->rows;
        follow(path, table_of(*walk, step.increments));
    }
    return path;
}

}  // namespace element
