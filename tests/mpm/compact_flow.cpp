// SPDX-License-Identifier: BSD-3-Clause
// A checkerboard of pore pressures, which moves no node, drains between its cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <adapters/mpm/run/measures.hpp>

#include "support/saturated_column.hpp"

namespace {

using namespace mpm_test;

// A closed block of so many cells along each side, p_w plus and minus 1 kPa from cell to cell.
struct Checkerboard {
    static constexpr int cells = 12, beside = 4;  // of its sides, whose nodes feel it
    static constexpr double size = 1e3;           // [Pa]
    double conductivity;                          // [m/s]; 0: undrained
    double cfl = 0.4;
    double stiffness = SaturatedColumn::E;  // of the grains [Pa]

    BuiltCase build() const {
        const SaturatedColumn column{.cells = cells,
                                     .conductivity = conductivity,
                                     .cfl = cfl,
                                     .closed = true,
                                     .implicit = true};
        Case plan = column.plan();
        plan.r = {0.0, {{1.0, cells, 1.0}}};
        plan.bodies[0].material = ElasticPlan{stiffness, 0.0};
        plan.bodies[0].outlines = {Outline{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}}};
        BuiltCase built = build_case(plan);
        Body& body = built.simulation->body(0);
        const ParticleView q = body.particles.view();
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
            q[body.water->first][p] = size * sign(q, p);
        return built;
    }
    static double sign(const ParticleView& q, std::ptrdiff_t p) {
        const int i = static_cast<int>(q[column::r][p] * cells);
        return (i + static_cast<int>(q[column::z][p] * cells)) % 2 == 0 ? 1.0 : -1.0;
    }
    // The mean of what is left of it away from the sides, by what there was.
    static double left(Simulation& simulation) {
        Body& body = simulation.body(0);
        const ParticleView q = body.particles.view();
        const auto is_beside = [](double x) {
            return x * cells < beside || x * cells > cells - beside;
        };
        double sum = 0.0;
        int count = 0;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            if (is_beside(q[column::r][p]) || is_beside(q[column::z][p])) continue;
            sum += sign(q, p) * q[body.water->first][p] / size;
            ++count;
        }
        return sum / count;
    }
};

// As Darcy has it between cells, 8/h^2 k/(rho_w g) K_w/n a second, where steps are so short that the inertia of the flow is
// nothing beside the compressibility of the pores, nor is what the grains give way by.
TEST(CompactFlow, DrainsACheckerboardAsBetweenCells) {
    const Checkerboard problem{.conductivity = 3e-8, .cfl = 0.003, .stiffness = 2e9};
    BuiltCase built = problem.build();
    Simulation& simulation = *built.simulation;
    const double rate = 8.0 * Checkerboard::cells * Checkerboard::cells * problem.conductivity /
                        (SaturatedColumn::rho_w * standard_gravity) * SaturatedColumn::K_w /
                        SaturatedColumn::n;
    const double before = water_mass(simulation);
    for (int i = 0; i < 200; ++i) simulation.step();
    EXPECT_NEAR(-std::log(Checkerboard::left(simulation)), rate * simulation.time(),
                0.05 * rate * simulation.time());
    EXPECT_NEAR(water_mass(simulation), before, 1e-13 * before);
    const Energy energy = simulation.energy();
    EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * std::fabs(energy.pore_water));
}

// Where no water goes through the grains what is there stays.
TEST(CompactFlow, LeavesUndrainedPressuresWhereTheyAre) {
    BuiltCase built = Checkerboard{.conductivity = 0.0}.build();
    for (int i = 0; i < 50; ++i) built.simulation->step();
    EXPECT_NEAR(Checkerboard::left(*built.simulation), 1.0, 0.05);
}

// A block of nine cells of 1 m2 and one Pa: what is softer than a step's inertia gives way more, up to a hundred times as much; around
// what does not bear only changes do.
TEST(CompactFlow, IsThatOfSoftGrainsOrOfAStep) {
    const Axis axis = Axis::uniform(0.0, 3.0, 3);
    Exchange alone;
    CompactFlow flow(GridView{axis.view(), axis.view()}, alone, false);
    constexpr double step = 1e-9, pores = 1e-10;  // [m3/Pa]
    const auto own = [&](double modulus, std::size_t dry, double of_corner = 0.0) {
        std::vector<CompactFlow::Cell> cells;
        for (std::uint32_t c = 0; c < 9; ++c)
            cells.push_back({c / 3 * 4 + c % 3, c != dry, true,
                             c == 0 && of_corner > 0.0 ? of_corner : modulus});
        flow.begin(cells, std::vector<CompactAnswer>(16, {step, pores, 2.0}));
        std::vector<double> x(9, 0.0), left(9, 0.0);
        x[4] = 1.0;  // in the middle, with all four nodes
        flow.add_by_pressures(x.data(), left.data());
        return std::pair{flow.own(4), left[4]};
    };
    EXPECT_DOUBLE_EQ(own(1e12, 9).first, step / 4.0);
    EXPECT_DOUBLE_EQ(own(2e8, 9).first, 1e-8 / 4.0);  // 2 m3 by 2e8 Pa
    EXPECT_DOUBLE_EQ(own(1e3, 9).first, 100.0 * step / 4.0);
    EXPECT_DOUBLE_EQ(own(1e12, 0).first, step / 4.0);
    EXPECT_DOUBLE_EQ(flow.own(0), step / 16.0);  // one node of a corner's four has four cells
    EXPECT_DOUBLE_EQ(own(2e8, 9, 1e9).first, (3.0 * 1e-8 + 2.0 / 4e8) / 16.0);
    EXPECT_DOUBLE_EQ(own(1e12, 9).second, pores / 4.0);
    EXPECT_DOUBLE_EQ(own(1e12, 0).second, pores * 3.0 / 16.0);
}

// Of so many cells along each side, beside which it says how much of r is left: a quarter of a checkerboard, which diagonals see four
// times too small. A symmetric one of positive products, else gradients were not conjugate.
struct Preconditioned {
    static constexpr int side = 12;
    static constexpr std::uint32_t row = side + 1;
    Axis axis = Axis::uniform(0.0, 1.0, side);
    Exchange alone;
    CompactFlow flow{GridView{axis.view(), axis.view()}, alone, false};
    std::vector<double> scale;

    explicit Preconditioned(double largest_share, bool even) {
        std::mt19937 random(7);
        const auto number = [&] { return even ? 1.0 : 0.01 + 0.99 * (random() / 4294967296.0); };
        std::vector<CompactFlow::Cell> cells;
        for (std::uint32_t c = 0; c < side * side; ++c)
            cells.push_back({c / side * row + c % side, true, true, 1e-300});
        std::vector<CompactAnswer> answers;
        for (std::uint32_t n = 0; n < row * row; ++n) answers.push_back({number(), 0.0, 1.0});
        flow.begin(cells, answers);
        for (std::size_t c = 0; c < cells.size(); ++c)
            scale.push_back(std::sqrt(largest_share * number() / std::max(flow.own(c), 1.0)));
        flow.scale_by(scale.data());
    }
    std::vector<double> operator()(const std::vector<double>& r) {
        std::vector<double> z(r.size());
        flow.precondition(r.data(), z.data());
        return z;
    }
    std::vector<double> left(const std::vector<double>& r) {
        const std::vector<double> z = (*this)(r);
        std::vector<double> scaled(z), flows(z.size(), 0.0), out(z.size());
        for (std::size_t c = 0; c < z.size(); ++c) scaled[c] *= scale[c];
        flow.add_by_changes(scaled.data(), flows.data());
        for (std::size_t c = 0; c < z.size(); ++c)
            out[c] = r[c] - (z[c] + scale[c] * (flows[c] - flow.own(c) * scaled[c]));
        return out;
    }
};

double product(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

TEST(CompactFlow, IsPreconditionedByASymmetricPositivePolynomial) {
    std::mt19937 random(3);
    for (const double share : {0.1, 0.9, 0.9999}) {
        Preconditioned about(share, false);
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<double> a, b;
            for (std::size_t c = 0; c < about.scale.size(); ++c) {
                a.push_back(random() / 2147483648.0 - 1.0);
                b.push_back(random() / 2147483648.0 - 1.0);
            }
            const double ab = product(a, about(b)), aa = product(a, about(a));
            EXPECT_NEAR(ab, product(b, about(a)), 1e-12 * aa) << share;
            EXPECT_GT(aa, 0.18 * product(a, a)) << share;
        }
    }
}

TEST(CompactFlow, IsPreconditionedForCheckerboards) {
    Preconditioned about(0.99, true);
    std::vector<double> board;
    for (std::size_t c = 0; c < about.scale.size(); ++c)
        board.push_back((c / Preconditioned::side + c % Preconditioned::side) % 2 == 0 ? 1.0
                                                                                       : -1.0);
    const std::vector<double> left = about.left(board);
    for (std::size_t c = 0; c < left.size(); ++c) {
        const std::size_t i = c % Preconditioned::side, j = c / Preconditioned::side;
        if (std::min(i, j) < 5 || std::max(i, j) > Preconditioned::side - 6) continue;
        EXPECT_LT(std::fabs(left[c]), 0.26) << c;
    }
}

// What particles of a cell differ by goes at the rate of PIC, and their mean stays.
TEST(ImplicitPressure, LetsParticlesOfACellComeTogether) {
    for (const double rate : {0.0, 200.0}) {
        Case plan = SaturatedColumn{.cells = 8, .closed = true, .implicit = true}.plan();
        plan.settings.pic_rate = rate;
        BuiltCase built = build_case(plan);
        Simulation& simulation = *built.simulation;
        Body& body = simulation.body(0);
        const ParticleView q = body.particles.view();
        const int p_w = body.water->first;
        const auto sign = [&](std::ptrdiff_t p) {
            return static_cast<int>(q[column::z][p] * 16.0) % 2 == 0 ? 1.0 : -1.0;
        };
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) q[p_w][p] = 5e3 + 1e3 * sign(p);
        double kept = 1.0;
        while (simulation.time() < 0.01) {
            const double t = simulation.time();
            simulation.step();
            kept *= 1.0 - rate * (simulation.time() - t);
        }
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
            EXPECT_NEAR(q[p_w][p], 5e3 + 1e3 * kept * sign(p), 1e-3) << rate;
        const bool is_together = kept < 0.2;
        EXPECT_EQ(is_together, rate > 0.0);
    }
}

}  // namespace
