// SPDX-License-Identifier: BSD-3-Clause
#include "bars/impact.hpp"

#include <algorithm>
#include <cmath>

namespace bars {
namespace {

constexpr double E = 1000.0, rho = 1000.0, L = 1.0, cell = 0.05, v = 0.01;
constexpr int particles = 40;        // two a cell
constexpr double initial_gap = 2.5;  // cells

double mean_force(const std::vector<Impact::Sample>& history, double from, double to) {
    double sum = 0.0;
    int count = 0;
    for (const Impact::Sample& s : history)
        if (s.time >= from && s.time <= to) {
            sum += s.force;
            ++count;
        }
    return sum / count;
}

}  // namespace

double impact_stiffness(double multiple) {
    double stiffness = 0.0;
    grit_penalty_stiffness(multiple, E, cell, &stiffness);
    return stiffness;
}

Impact impact(const Contact& contact, double offset) {
    const double c = std::sqrt(E / rho);
    const double left = 5.0 * cell + offset * cell;
    Bar a = make_bar(left, left + L, particles, rho);
    Bar b = make_bar(a.right() + initial_gap * cell, a.right() + initial_gap * cell + L, particles,
                     rho);
    a.modulus = b.modulus = E;
    for (Particle& p : a.particles) p.v = v;
    for (Particle& p : b.particles) p.v = -v;
    Line line(0.0, cell, 60);
    const double dt = 0.1 * cell / c;
    const double touch = initial_gap * cell / (2.0 * v);
    const double before = a.energy() + b.energy();

    Impact result{};
    double first = -1.0, last = -1.0;
    for (int step = 0; step * dt < touch + 6.0 * L / c; ++step) {
        const double gap = (b.left() - a.right()) / cell, time = step * dt;
        const StepReport report = line.step(a, b, contact, dt);
        result.history.push_back({(time - touch) * c / L, report.force / (rho * c * v), gap});
        result.most_energy = std::max(result.most_energy, (a.energy() + b.energy()) / before);
        if (report.force == 0.0) continue;
        if (first < 0.0) {
            first = time;
            result.start_gap = gap;
        }
        last = time + dt;
        result.impulse += report.force * dt / (2.0 * rho * v * L);
    }
    result.duration = (last - first) / (2.0 * L / c);
    result.energy = (a.energy() + b.energy()) / before;
    result.force = mean_force(result.history, (first + 0.25 * (last - first) - touch) * c / L,
                              (first + 0.75 * (last - first) - touch) * c / L);
    return result;
}

}  // namespace bars
