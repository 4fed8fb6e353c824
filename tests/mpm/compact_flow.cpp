// SPDX-License-Identifier: BSD-3-Clause
// A checkerboard of pore pressures, which moves no node, drains between its cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

// Of so many cells along each side. Where not even, their scales and the answers of nodes differ by a hundred.
struct Preconditioned {
    static constexpr std::size_t side = 12, row = side + 1, count = side * side;
    using Cells = std::array<double, count>;
    static constexpr double stiff = 1e300;  // so that nodes answer as they do
    // Of a process that counts one cell, of which it tells how it is and no pressure.
    struct Other : Exchange {
        std::size_t cell = count;
        void sum_nodes(double* values, std::ptrdiff_t, int each) override {
            if (each != 3 || cell == count) return;
            for (const std::size_t node : {std::size_t{0}, std::size_t{1}, row, row + 1}) {
                double* at = values + 3 * (cell / side * row + cell % side + node);
                at[0] += 1.0;
                at[1] += 1.0;
                at[2] += stiff;
            }
        }
    };
    Axis axis = Axis::uniform(0.0, 1.0, static_cast<int>(side));
    Other exchange;
    CompactFlow flow;
    Cells scale;

    // largest_share: of the flow in the diagonal; elsewhere: the cell of another process.
    explicit Preconditioned(double largest_share, bool even, bool fixed_point = false,
                            std::size_t elsewhere = count)
        : flow(GridView{axis.view(), axis.view()}, exchange, fixed_point) {
        exchange.cell = elsewhere;
        std::mt19937 random(7);
        const auto number = [&] { return even ? 1.0 : 0.01 + 0.99 * (random() / 4294967296.0); };
        std::vector<CompactFlow::Cell> cells;
        for (std::size_t c = 0; c < count; ++c)
            cells.push_back({static_cast<std::uint32_t>(c / side * row + c % side), true,
                             c != elsewhere, stiff});
        std::vector<CompactAnswer> answers;
        for (std::size_t n = 0; n < row * row; ++n) answers.push_back({number(), 0.0, 1.0});
        flow.begin(cells, answers);
        for (std::size_t c = 0; c < count; ++c)
            scale[c] = std::sqrt(largest_share * number() / flow.own(c));
        flow.scale_by(scale.data());
    }
    static double product(const Cells& a, const Cells& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    }
    Cells operator()(const Cells& r) {
        Cells z;
        flow.precondition(r.data(), std::sqrt(product(r, r)), z.data());
        return z;
    }
    // The matrix.
    Cells times(const Cells& z) {
        Cells scaled, flows{}, out;
        for (std::size_t c = 0; c < count; ++c) scaled[c] = scale[c] * z[c];
        flow.add_by_changes(scaled.data(), flows.data());
        for (std::size_t c = 0; c < count; ++c)
            out[c] = z[c] + scale[c] * (flows[c] - flow.own(c) * scaled[c]);
        return out;
    }
    static Cells board() {
        Cells out;
        for (std::size_t c = 0; c < count; ++c)
            out[c] = (c / side + c % side) % 2 == 0 ? 1.0 : -1.0;
        return out;
    }
    static Cells any(std::mt19937& random) {
        Cells out;
        for (double& x : out) x = random() / 2147483648.0 - 1.0;
        return out;
    }
};

// Else gradients were not conjugate. That of the largest eigenvalue as well, which a polynomial for fewer makes negative.
TEST(CompactFlow, IsPreconditionedByASymmetricPositivePolynomial) {
    std::mt19937 random(3);
    for (const bool even : {false, true})
        for (const double share : {0.1, 0.9, 0.9999}) {
            Preconditioned about(share, even);
            const auto expect_positive = [&](const Preconditioned::Cells& x) {
                EXPECT_GT(about.product(x, about(x)), 0.18 * about.product(x, x)) << share;
            };
            for (int trial = 0; trial < 20; ++trial) {
                const Preconditioned::Cells a = about.any(random), b = about.any(random);
                EXPECT_NEAR(about.product(a, about(b)), about.product(b, about(a)),
                            1e-12 * about.product(a, about(a)));
                expect_positive(a);
            }
            Preconditioned::Cells top = about.board();
            expect_positive(top);
            for (int i = 0; i < 50; ++i) {
                top = about.times(top);
                const double size = std::sqrt(about.product(top, top));
                for (double& x : top) x /= size;
            }
            expect_positive(top);
        }
}

// Of a checkerboard, which diagonals see four times too small, a quarter is left.
TEST(CompactFlow, IsPreconditionedForCheckerboards) {
    Preconditioned about(0.99, true);
    const Preconditioned::Cells board = about.board(), found = about.times(about(board));
    for (std::size_t c = 0; c < Preconditioned::count; ++c) {
        const std::size_t i = c % Preconditioned::side, j = c / Preconditioned::side;
        if (std::min(i, j) < 5 || std::max(i, j) > Preconditioned::side - 6) continue;
        EXPECT_LT(std::fabs(board[c] - found[c]), 0.26) << c;
    }
}

// In fixed point but for what is rounded, and what others count is theirs to add.
TEST(CompactFlow, IsPreconditionedInFixedPoint) {
    std::mt19937 random(5);
    Preconditioned doubles(0.9, false), integers(0.9, false, true);
    const Preconditioned::Cells r = doubles.any(random), a = doubles(r), b = integers(r);
    double most = 0.0;
    for (std::size_t c = 0; c < Preconditioned::count; ++c)
        most = std::max(most, std::fabs(a[c] - b[c]));
    EXPECT_LT(most, 1e-11);
    EXPECT_GT(most, 0.0);

    constexpr std::size_t other = 5 * Preconditioned::side + 5;
    Preconditioned shared(0.9, false, false, other);
    Preconditioned::Cells changed = r;
    changed[other] += 1.0;
    const Preconditioned::Cells c = shared(r), d = shared(changed);
    for (std::size_t cell = 0; cell < Preconditioned::count; ++cell) {
        const bool same = c[cell] == d[cell];
        EXPECT_EQ(same, cell != other) << cell;
    }
}

// Cells that do not bear are not in the system.
TEST(CompactFlow, IsPreconditionedWhereSomeOrNoCellsBear) {
    std::mt19937 random(9);
    Preconditioned about(0.9, false);
    for (const std::size_t every : {std::size_t{3}, std::size_t{1}}) {
        Preconditioned::Cells r = about.any(random);
        for (std::size_t c = 0; c < Preconditioned::count; c += every) r[c] = about.scale[c] = 0.0;
        about.flow.scale_by(about.scale.data());
        const Preconditioned::Cells z = about(r);
        for (std::size_t c = 0; c < Preconditioned::count; ++c) {
            const bool is_nothing = z[c] == 0.0;
            EXPECT_TRUE(std::isfinite(z[c]));
            EXPECT_EQ(is_nothing, c % every == 0) << c;
        }
    }
}

// Sand under its weight, whose upper cells are ten times softer than the lowest, and what falls on it.
TEST(CompactFlow, OfSoftGrainsTakesFewIterations) {
    constexpr int cells = 16, steps = 100;
    Case plan = of_sand(SaturatedColumn{
        .cells = cells, .conductivity = 1e-5, .implicit = true, .load = 1e3, .gravity = 9.81}
                            .plan());
    plan.r = {0.0, {{1.0, cells, 1.0}}};
    plan.bodies[0].outlines = {Outline{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}}};
    plan.tractions[0].r[1] = 0.5;
    plan.tractions[0].stress = TimeTable{{0.0, 0.005}, {1e3, 5e3}};
    BuiltCase built = build_case(plan);
    for (int i = 0; i < steps; ++i) built.simulation->step();
    EXPECT_LT(static_cast<double>(built.simulation->pore_water().iterations(0)) / steps, 30.0);
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
