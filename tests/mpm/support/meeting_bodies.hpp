// SPDX-License-Identifier: BSD-3-Clause
// Two bars that meet, and a block on a slope: the same for every contact.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "support/box.hpp"

namespace mpm_test {

// Elastic bars of length L that close their gap with 2v, in plane strain, without contact yet.
struct MeetingBars {
    static constexpr double E = 1000.0, rho = 1000.0, L = 1.0, h = 0.05, v = 0.01, width = 2.0 * h;
    double gap;     // at the start [m]
    double offset;  // against the grid, in cells
    double cfl = 0.1;

    double top_of_lower() const { return (8.0 + offset) * h + L; }
    double bottom_of_upper() const { return top_of_lower() + gap; }
    static double wave_speed() { return std::sqrt(E / rho); }

    std::unique_ptr<Simulation> build() const {
        Settings settings{.axisymmetric = false, .cfl = cfl};
        auto simulation = std::make_unique<Simulation>(Axis::uniform(0.0, width, 2),
                                                       Axis::uniform(0.0, 3.0, 60), settings);
        for (const int k : {0, 1}) {
            const double z = k == 0 ? top_of_lower() - L : bottom_of_upper();
            Body bar = make_box({0.0, width, z, z + L, 4, 40, rho}, false,
                                std::make_unique<LinearElastic>(E, 0.0));
            for (std::ptrdiff_t p = 0; p < bar.particles.size(); ++p)
                bar.particles.view()[column::v_z][p] = k == 0 ? v : -v;
            simulation->add_body(std::move(bar));
        }
        simulation->fix_below(0, 0.0);
        simulation->fix_above(0, width);
        return simulation;
    }
};

struct Meeting {
    double gap_at_touch;  // when the first force appeared [h]
    double force;         // its mean in the middle of the contact [rho c v]
    double duration;      // [2 L / c]
    double impulse;       // [2 rho v L]
    double residual;      // of the energy [kinetic energy at the start]
};

// Until long after they have parted. forces: on A and on B along z in the last step, [N] per metre.
inline Meeting meet(const MeetingBars& bars, Simulation& simulation,
                    const std::function<grit::Vector2()>& forces) {
    const double c = MeetingBars::wave_speed(), L = MeetingBars::L, v = MeetingBars::v;
    const double touch = bars.gap / (2.0 * v), unit = MeetingBars::rho * c * v;
    double first = NAN, last = NAN, impulse = 0.0, middle = 0.0, middle_time = 0.0;
    while (simulation.time() < touch + 4.0 * L / c) {
        const double t = simulation.time();
        simulation.step();
        const double dt = simulation.time() - t;
        const auto [on_a, on_b] = forces().c;
        EXPECT_NEAR(on_a, -on_b, 1e-12 * (1.0 + on_b));
        const double force = on_b / MeetingBars::width;
        if (force == 0.0) continue;
        if (std::isnan(first)) first = t;
        last = t + dt;
        impulse += force * dt;
        if (t > touch + 0.5 * L / c && t < touch + 1.5 * L / c) {
            middle += force * dt;
            middle_time += dt;
        }
    }
    const Energy energy = simulation.energy();
    return {(first - touch) * 2.0 * v / MeetingBars::h, middle / middle_time / unit,
            (last - first) * c / (2.0 * L), impulse / (2.0 * MeetingBars::rho * v * L),
            energy.residual() / energy.kinetic_0};
}

// A block on a rigid floor that slopes at angle theta, seen along the floor; without contact yet.
inline std::unique_ptr<Simulation> block_on_slope(double angle) {
    constexpr double g = 9.81;
    Settings settings{.axisymmetric = false,
                      .pic_rate = 20.0,
                      .gravity_r = g * std::sin(angle),
                      .gravity_z = -g * std::cos(angle)};
    auto simulation = std::make_unique<Simulation>(Axis::uniform(0.0, 3.0, 30),
                                                   Axis::uniform(0.0, 1.2, 12), settings);
    Body floor = make_box({0.0, 3.0, 0.2, 0.5, 60, 6, 1000.0}, false, nullptr);
    floor.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
    simulation->add_body(std::move(floor));
    simulation->add_body(make_box({0.5, 0.9, 0.5, 0.9, 8, 8, 1000.0}, false,
                                  std::make_unique<LinearElastic>(1e6, 0.3)));
    return simulation;
}

// After 0.5 s: its way, as a share of g t^2/2, and the residual of its energy as a share of the work of its
// weight.
struct Slide {
    double way, residual;
};

inline Slide slide(Simulation& simulation) {
    const Particles& q = simulation.body(1).particles;
    const auto middle = [&] {
        double sum = 0.0;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) sum += q(column::r, p);
        return sum / static_cast<double>(q.size());
    };
    const double start = middle();
    while (simulation.time() < 0.5) simulation.step();
    const Energy energy = simulation.energy();
    return {(middle() - start) / (0.5 * 9.81 * simulation.time() * simulation.time()),
            energy.residual() / energy.external_work};
}

}  // namespace mpm_test
