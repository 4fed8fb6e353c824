// SPDX-License-Identifier: BSD-3-Clause
// A checkerboard of pore pressures, which moves no node, drains between its cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include <adapters/mpm/run/measures.hpp>

#include "support/neighbour.hpp"
#include "support/saturated_column.hpp"

namespace {

using namespace mpm_test;

// A closed block of so many cells along each side, p_w plus and minus 1 kPa from cell to cell.
struct Checkerboard {
    static constexpr int cells = 8, beside = 3;  // of its sides, whose nodes feel it
    static constexpr double size = 1e3;          // [Pa]
    double conductivity;                         // [m/s]; 0: undrained
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

// As Darcy has it between cells, 8/h^2 k/(rho_w g) K_w/n a second, beside what starts of it with grains and water, more where these are
// less tied. Steps are so short that the inertia of the flow is nothing beside the compressibility of the pores. Eight cells are too few
// for five fourth differences.
TEST(CompactFlow, DrainsACheckerboardAsBetweenCells) {
    constexpr double n = SaturatedColumn::n, rho_w = SaturatedColumn::rho_w;
    const Checkerboard problem{.conductivity = 3e-8, .cfl = 0.002, .stiffness = 2e9};
    Checkerboard tight = problem;
    tight.conductivity = 1e-6 * problem.conductivity;
    BuiltCase of[] = {tight.build(), problem.build()};
    Simulation& simulation = *of[1].simulation;
    const double before = water_mass(simulation);
    for (const BuiltCase& built : of) built.simulation->step();
    const double dt = simulation.time(), left = Checkerboard::left(*of[0].simulation);
    // Volume velocity that an impulse starts, of 1 m3.
    const auto starts = [&](double conductivity) {
        const double grains = (1.0 - n) * SaturatedColumn::rho_s, water = n * rho_w,
                     drag = dt * n * n * rho_w * standard_gravity / conductivity,
                     all = grains * water + drag * (grains + water);
        const double of_grains = ((1.0 - n) * (water + drag) + n * drag) / all,
                     of_water = ((1.0 - n) * drag + n * (grains + drag)) / all;
        return (1.0 - n) * of_grains + n * of_water;
    };
    const double rate = 8.0 * Checkerboard::cells * Checkerboard::cells * problem.conductivity /
                        (rho_w * standard_gravity) * SaturatedColumn::K_w / n;
    const double more = starts(problem.conductivity) / starts(tight.conductivity) - 1.0;
    EXPECT_NEAR(left - Checkerboard::left(simulation), rate * dt + more * (1.0 - left),
                0.05 * rate * dt);
    for (int i = 0; i < 200; ++i) simulation.step();
    EXPECT_NEAR(water_mass(simulation), before, 1e-13 * before);
    const Energy energy = simulation.energy();
    EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * std::fabs(energy.pore_water));
}

// Where no water goes through the grains it goes all the same, with the energy that it had.
TEST(CompactFlow, TakesOffAnUndrainedCheckerboard) {
    BuiltCase built = Checkerboard{.conductivity = 0.0}.build();
    Simulation& simulation = *built.simulation;
    for (int i = 0; i < 50; ++i) simulation.step();
    EXPECT_NEAR(Checkerboard::left(simulation), 0.0, 0.01);
    const Energy energy = simulation.energy();
    EXPECT_LT(energy.pore_water, 0.0);
    EXPECT_NEAR(energy.residual(), 0.0, 1e-4 * std::fabs(energy.pore_water));
}

constexpr std::size_t block_side = 16, no_cell = block_side * block_side;

// What nodes answer to changes, and cells by themselves [m3/Pa], or less of it, by up to a hundred, unless even.
struct BlockPlan {
    double step = 1e-9;
    double of_nodes = 1.0;  // nodes answer so much of it to changes,
    double pores = 0.0;     // and this to pressures [m3/Pa]
    bool even = true, all_cavitate = true;
    std::size_t dry = no_cell, cavity = no_cell;
    unsigned hole_of = 0;  // one of so many cells is not there
};

// A block of so many cells along each side.
struct Block {
    static constexpr std::size_t side = block_side, row = side + 1, count = side * side;
    using Cells = std::array<double, count>;
    Axis axis = Axis::uniform(0.0, 1.0, static_cast<int>(side));
    Exchange alone;
    CompactFlow flow{GridView{axis.view(), axis.view()}, alone, false};
    std::mt19937 random{7};
    Cells compliance{};

    bool is_hole(std::size_t c) const { return compliance[c] == 0.0; }
    // From -1/2 to 1/2, and nothing in holes.
    Cells any_pressures() {
        Cells out{};
        for (std::size_t c = 0; c < count; ++c)
            if (!is_hole(c)) out[c] = number() - 0.505;
        return out;
    }
    double number() { return 0.01 + 0.99 * (random() / 4294967296.0); }
    explicit Block(const BlockPlan& plan) {
        const auto answer = [&] { return plan.even ? plan.step : plan.step * number(); };
        std::vector<CompactFlow::Cell> cells;
        for (std::size_t c = 0; c < count; ++c) {
            compliance[c] = answer();
            if (plan.hole_of > 0 && random() % plan.hole_of == 0) compliance[c] = 0.0;
            cells.push_back({static_cast<std::uint32_t>(c / side * row + c % side), c != plan.dry,
                             !is_hole(c), plan.all_cavitate || c == plan.cavity, compliance[c]});
        }
        std::vector<CompactAnswer> answers;
        for (std::size_t n = 0; n < row * row; ++n)
            answers.push_back({plan.of_nodes * answer(), plan.pores});
        flow.begin(cells, answers);
    }
    template <class Pressure> static Cells of(const Pressure& pressure) {
        Cells out;
        for (std::size_t c = 0; c < count; ++c)
            out[c] = pressure(static_cast<int>(c % side), static_cast<int>(c / side));
        return out;
    }
    Cells leaving(const Cells& p) {
        Cells out{};
        flow.add_of_alternating(p.data(), out.data());
        return out;
    }
    static bool is_within(std::size_t c, std::size_t margin) {
        const std::size_t i = c % side, j = c / side;
        return std::min(i, j) >= margin && std::max(i, j) < side - margin;
    }
};

// Nodes with four cells answer to changes; to pressures only where all four bear.
TEST(CompactFlow, IsThatOfNodesWithFourCells) {
    constexpr double step = 1e-9, pores = 1e-10;  // [m3/Pa]
    constexpr std::size_t middle = 5 * Block::side + 5;
    const auto by_pressures = [](Block& block) {
        Block::Cells x{}, left{};
        x[middle] = 1.0;
        block.flow.add_by_pressures(x.data(), left.data());
        return left[middle];
    };
    Block wet({.step = step, .pores = pores}),
        beside_dry({.step = step, .pores = pores, .dry = 4 * Block::side + 4});
    EXPECT_DOUBLE_EQ(wet.flow.own(middle), step / 4.0);
    EXPECT_DOUBLE_EQ(wet.flow.own(0), step / 16.0);  // one node of a corner's four has four cells
    EXPECT_DOUBLE_EQ(by_pressures(wet), pores / 4.0);
    EXPECT_DOUBLE_EQ(beside_dry.flow.own(middle), step / 4.0);
    EXPECT_DOUBLE_EQ(by_pressures(beside_dry), pores * 3.0 / 16.0);
}

double product(const Block::Cells& a, const Block::Cells& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// What changes sign from cell to cell leaves: along one direction nine tenths, a checkerboard along both, and what it starts.
TEST(CompactFlow, TakesOffWhatAlternates) {
    constexpr double step = 1e-9;
    const auto sign = [](int i) { return i % 2 == 0 ? 1.0 : -1.0; };
    struct {
        Block::Cells p;
        double share;
    } const cases[] = {
        {Block::of([&](int i, int) { return sign(i); }), 0.9},
        {Block::of([&](int, int j) { return sign(j); }), 0.9},
        {Block::of([&](int i, int j) { return sign(i + j); }), 2.8},
    };
    for (const auto& [p, share] : cases) {
        const Block::Cells left = Block({.step = step}).leaving(p);
        for (std::size_t c = 0; c < Block::count; ++c) {
            if (Block::is_within(c, 4)) {
                EXPECT_NEAR(left[c], share * step * p[c], 1e-15 * step) << c;
            }
        }
    }
}

// Of a jump along one direction only where one of five cells cavitates: here of the row, and where fives that hold it reach.
TEST(CompactFlow, TakesOffJumpsBesideCavities) {
    constexpr std::size_t at = 6;
    const Block::Cells p = Block::of([](int i, int) { return i < 6 ? 1.0 : 0.0; });
    const Block::Cells left =
        Block({.all_cavitate = false, .cavity = at * Block::side + at}).leaving(p);
    for (std::size_t c = 0; c < Block::count; ++c) {
        const std::size_t i = c % Block::side;
        const bool flows = left[c] != 0.0, beside = c / Block::side == at && i >= 2 && i <= 9;
        EXPECT_EQ(flows, beside) << c;
    }
}

// Of five fourth differences in a row whose signs alternate the least, of all fives that a cell is in the most: as it is said.
Block::Cells leaving_as_said(const Block& block, const Block::Cells& p) {
    constexpr std::ptrdiff_t side = Block::side;
    constexpr double weights[] = {1.0 / 16, -4.0 / 16, 6.0 / 16, -4.0 / 16, 1.0 / 16};
    Block::Cells out{};
    for (const std::ptrdiff_t step : {std::ptrdiff_t{1}, side})
        for (std::ptrdiff_t row = 0; row < side; ++row) {
            const auto cell = [&](std::ptrdiff_t i) {
                return static_cast<std::size_t>(row * (step == 1 ? side : 1) + i * step);
            };
            std::array<double, Block::side> fourth{}, least{}, part{};
            for (std::ptrdiff_t i = 2; i < side - 2; ++i) {
                double sum = 0.0, compliance = 1.0;
                for (std::ptrdiff_t k = -2; k <= 2; ++k) {
                    sum += weights[k + 2] * p[cell(i + k)];
                    compliance = std::min(compliance, block.compliance[cell(i + k)]);
                }
                least[static_cast<std::size_t>(i)] = compliance;
                fourth[static_cast<std::size_t>(i)] = compliance > 0.0 ? sum : 0.0;
            }
            for (std::size_t first = 0; first + 5 <= Block::side; ++first) {
                double size = std::fabs(fourth[first]);
                for (std::size_t i = first; i < first + 4; ++i)
                    size = fourth[i] * fourth[i + 1] < 0.0
                               ? std::min(size, std::fabs(fourth[i + 1]))
                               : 0.0;
                for (std::size_t i = first; i < first + 5; ++i)
                    if (size > std::fabs(part[i])) part[i] = std::copysign(size, fourth[i]);
            }
            for (std::ptrdiff_t i = 2; i < side - 2; ++i)
                for (std::ptrdiff_t k = -2; k <= 2; ++k)
                    out[cell(i + k)] += 0.9 * weights[k + 2] * least[static_cast<std::size_t>(i)] *
                                        part[static_cast<std::size_t>(i)];
        }
    return out;
}

TEST(CompactFlow, TakesOffTheLeastOfFiveThatAlternate) {
    constexpr double step = 1e-9;
    int some = 0;
    for (unsigned hole_of : {0u, 30u})
        for (int draw = 0; draw < 20; ++draw) {
            Block block({.step = step,
                         .of_nodes = 0.0,
                         .even = false,
                         .all_cavitate = false,
                         .hole_of = hole_of});
            for (int skipped = 0; skipped < draw * 1000; ++skipped) block.number();
            Block::Cells p = block.any_pressures();
            for (std::size_t c = 0; c < Block::count; ++c)
                if (c % 3 != 0) p[c] += c % 2 == 0 ? 0.4 : -0.4;
            const Block::Cells left = block.leaving(p), expected = leaving_as_said(block, p);
            for (std::size_t c = 0; c < Block::count; ++c) {
                EXPECT_NEAR(left[c], block.is_hole(c) ? 0.0 : expected[c], 1e-15 * step) << c;
                some += expected[c] != 0.0;
            }
        }
    EXPECT_GT(some, 1000);
}

// Where no cell cavitates, too, but nothing of a jump; of a row of cells that stands out a sixteenth.
TEST(CompactFlow, TakesOffWhatAlternatesInFiveCells) {
    constexpr double step = 1e-9;
    for (const bool along_r : {false, true}) {
        Block block({.step = step, .all_cavitate = false});
        const auto along = [&](int i, int j) { return along_r ? i : j; };
        const Block::Cells p =
            Block::of([&](int i, int j) { return along(i, j) % 2 == 0 ? 1.0 : -1.0; });
        const Block::Cells left = block.leaving(p);
        const Block::Cells of_jump = block.leaving(Block::of(
            [&](int i, int j) { return along(i, j) < 6 ? 1.0 + 0.1 * along(i, j) : 0.0; }));
        for (std::size_t c = 0; c < Block::count; ++c) {
            EXPECT_NEAR(of_jump[c], 0.0, 1e-15 * step) << c;
            if (Block::is_within(c, 4)) {
                EXPECT_NEAR(left[c], 0.9 * step * p[c], 1e-15 * step) << c;
            }
        }
        EXPECT_NE(left[6 * Block::side + 6], 0.0);
    }
    const Block::Cells left =
        Block({.step = step, .all_cavitate = false}).leaving(Block::of([](int i, int) {
            return i == 6 ? 1.0 : 0.0;
        }));
    EXPECT_NEAR(left[6 * Block::side + 6], 0.9 * step / 16.0, 1e-15 * step);
    EXPECT_NEAR(left[6 * Block::side + 7], -0.9 * step / 16.0 * 15.0 / 16.0, 1e-15 * step);
}

// Of linear pressures and cubic ones along r or z nothing, of half a wave in eight cells a few millionths.
TEST(CompactFlow, LeavesSmoothPressures) {
    constexpr double step = 1e-9;
    const double k = std::acos(-1.0) / 8.0;
    struct {
        Block::Cells p;
        double most;
        std::size_t margin;
    } const cases[] = {
        {Block::of([](int i, int j) { return 3.0 * i - 2.0 * j + i * j; }), 1e-12, 2},
        {Block::of([](int i, int j) { return i * i * i - 7.0 * j * j * j; }), 1e-11, 0},
        {Block::of([&](int i, int j) { return std::cos(k * i) * std::cos(k * j); }), 7e-6, 4},
    };
    for (const auto& [p, most, margin] : cases) {
        const Block::Cells left = Block({.step = step}).leaving(p);
        for (std::size_t c = 0; c < Block::count; ++c) {
            if (Block::is_within(c, margin)) {
                EXPECT_NEAR(left[c], 0.0, most * step) << c;
            }
        }
    }
}

// Whatever pressures are, and what answers to them: no water is lost, pressures lose energy and none grows, for
// what leaves is no more than what changes answer and what compresses the cells' own water, this nine tenths along each direction.
TEST(CompactFlow, KeepsWaterAndDissipates) {
    Block::Cells one;
    one.fill(1.0);
    const auto expect_kept = [&](Block& block, const Block::Cells& p, double own_water) {
        const Block::Cells left = block.leaving(p);
        Block::Cells changes{}, own;
        block.flow.add_by_changes(p.data(), changes.data());
        for (std::size_t c = 0; c < Block::count; ++c) own[c] = block.compliance[c] * p[c];
        EXPECT_NEAR(product(one, left), 0.0, 1e-22);
        for (std::size_t c = 0; c < Block::count; ++c) {
            if (block.is_hole(c)) {
                EXPECT_EQ(left[c], 0.0) << c;
            }
        }
        EXPECT_GT(product(p, left), 0.0);
        EXPECT_LT(product(p, left), product(p, changes) + own_water * product(p, own));
    };
    Block cavitated({.even = false}),
        at_a_corner({.even = false, .all_cavitate = false, .cavity = 0}),
        with_holes({.even = false, .hole_of = 8}),
        bears({.even = false, .all_cavitate = false, .hole_of = 8});
    for (int trial = 0; trial < 50; ++trial)
        for (Block* block : {&cavitated, &with_holes, &bears})
            expect_kept(*block, block->any_pressures(), 1.8);
    // Beside what nodes start, by what compresses their own water pressures have no more energy after it.
    Block dry_nodes[] = {
        Block({.of_nodes = 0.0, .even = false, .hole_of = 8}),
        Block({.of_nodes = 0.0, .even = false, .all_cavitate = false, .hole_of = 8})};
    for (Block& block : dry_nodes)
        for (int trial = 0; trial < 50; ++trial) {
            const Block::Cells p = block.any_pressures(), left = block.leaving(p);
            double given = 0.0;
            for (std::size_t c = 0; c < Block::count; ++c)
                if (!block.is_hole(c)) given += left[c] * left[c] / block.compliance[c];
            EXPECT_GT(given, 0.0);
            EXPECT_LT(given, 1.8 * product(p, left));
        }
    // Of a quadrant of 1 Pa, whose one mixed difference is at a node that may answer less than all around it.
    for (int j = 6; j < 11; ++j)
        for (int i = 6; i < 11; ++i)
            expect_kept(at_a_corner,
                        Block::of([&](int r, int z) { return r >= i && z >= j ? 1.0 : 0.0; }), 0.0);
}

// Of other pressures q.Ap is p.Aq.
TEST(CompactFlow, IsSymmetric) {
    for (const unsigned hole_of : {0u, 8u}) {
        Block block({.even = false, .hole_of = hole_of});
        for (int trial = 0; trial < 50; ++trial) {
            const Block::Cells p = block.any_pressures(), q = block.any_pressures();
            const double pq = product(p, block.leaving(q)), qp = product(q, block.leaving(p));
            EXPECT_NEAR(pq, qp, 1e-13 * product(p, block.leaving(p)));
        }
    }
}

// Of two processes that share a grid, however it is cut: in fixed point the bits of one.
TEST(CompactFlow, HasTheBitsOfOneProcess) {
    constexpr int side = 16;
    const Axis axis = Axis::uniform(0.0, 1.0, side);
    std::mt19937 random{11};
    const auto number = [&] { return 0.01 + 0.99 * (random() / 4294967296.0); };
    using Whole = std::vector<double>;
    const auto any = [&](int count) {
        Whole out;
        for (int i = 0; i < count; ++i) out.push_back(number());
        return out;
    };
    const Whole p = any(side * side), compliance = any(side * side),
                answers = any((side + 1) * (side + 1));
    for (const double cavities : {0.0, 0.1}) {
        Whole cavity = any(side * side);
        const auto place = [](int i, int j, int row) {
            const int at = j * row + i;
            return static_cast<std::size_t>(at);
        };
        // What leaves the cells that it counts, at their places in the whole; nothing elsewhere.
        const auto leaving = [&](Exchange& exchange, const int* begin, const int* end) {
            const Axis r = axis.part(begin[0], end[0]), z = axis.part(begin[1], end[1]);
            CompactFlow flow{GridView{r.view(), z.view()}, exchange, true};
            const std::uint8_t* counted = exchange.counted_cells();
            std::vector<CompactFlow::Cell> cells;
            std::vector<CompactAnswer> of_nodes;
            Whole of_cells, left, out(side * side, 0.0);
            for (int j = 0; j < z.nodes(); ++j)
                for (int i = 0; i < r.nodes(); ++i) {
                    const std::size_t node = place(begin[0] + i, begin[1] + j, side + 1);
                    of_nodes.push_back({answers[node], 0.0});
                    if (i == r.cells() || j == z.cells()) continue;
                    const std::size_t cell = place(begin[0] + i, begin[1] + j, side);
                    cells.push_back({static_cast<std::uint32_t>(j * r.nodes() + i), true,
                                     !counted || counted[j * r.cells() + i],
                                     cavity[cell] < cavities, compliance[cell]});
                    of_cells.push_back(p[cell] - 0.5);
                }
            left.resize(cells.size());
            flow.begin(cells, of_nodes);
            flow.add_of_alternating(of_cells.data(), left.data());
            for (std::size_t c = 0; c < cells.size(); ++c) {
                const int i = static_cast<int>(c) % r.cells(), j = static_cast<int>(c) / r.cells();
                if (cells[c].counted) out[place(begin[0] + i, begin[1] + j, side)] = left[c];
            }
            return out;
        };
        Exchange alone;
        const int none[] = {0, 0}, all[] = {side, side};
        const Whole whole = leaving(alone, none, all);
        for (const int direction : {0, 1})
            for (int at = 3; at <= side - 3; ++at) {
                Mailbox mailbox({direction, at});
                Whole of[2];
                const auto work = [&](int rank) {
                    Neighbour neighbour(mailbox, rank, axis, axis);
                    of[rank] = leaving(neighbour, neighbour.begin, neighbour.end);
                };
                std::thread upper(work, 1);
                work(0);
                upper.join();
                for (std::size_t c = 0; c < whole.size(); ++c)
                    EXPECT_EQ(of[0][c] + of[1][c], whole[c]) << direction << ' ' << at << ' ' << c;
            }
    }
}

// Sand under its weight, whose upper cells are ten times softer than the lowest, and what falls on it.
TEST(ImplicitPressure, TakesFewIterations) {
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

// Particles of a cell, two that bear and two with a cavity: water goes from those to these, half of the way in a step, whatever the
// conductivity. Pores that are open to the cap keep their cavity, and nothing goes.
TEST(ImplicitPressure, FillsTheCavitiesOfACellWithItsWater) {
    for (const double conductivity : {0.0, 1e-7, 1e-2})
        for (const bool open : {false, true}) {
            BuiltCase built = Checkerboard{.conductivity = conductivity, .cfl = 0.1}.build();
            Simulation& simulation = *built.simulation;
            Body& body = simulation.body(0);
            if (open) body.water->opening_cap = 0.5;
            const double tension = body.water->largest_tension;
            const std::array<double, 4> first{3e5, 1e5, -tension - 4e4, -tension - 6e4};
            const ParticleView q = body.particles.view();
            const auto place = [&](std::ptrdiff_t p) {
                const auto half = [](double x) {
                    return static_cast<std::size_t>(x * 2 * Checkerboard::cells) % 2;
                };
                return 2 * half(q[column::z][p]) + half(q[column::r][p]);
            };
            for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
                q[body.water->first][p] = first[place(p)];
            std::array<double, 4> p_w = first;
            for (int i = 0; i < 10; ++i) {
                simulation.step();
                if (open || *std::min_element(p_w.begin(), p_w.end()) > -tension) continue;
                double mean = 0.0;
                for (const double p : p_w) mean += 0.25 * std::max(p, -tension);
                for (double& p : p_w) p += 0.5 * (mean - std::max(p, -tension));
            }
            EXPECT_EQ(*std::min_element(p_w.begin(), p_w.end()) > -tension, !open);
            for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
                EXPECT_NEAR(q[body.water->first][p], p_w[place(p)], 1.0) << conductivity << open;
        }
}

}  // namespace
