// SPDX-License-Identifier: BSD-3-Clause
// A grid that two processes share, here two threads: each has the particles of its part, and two cells more
// of the grid. In fixed point they get the bits of one process alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <thread>
#include <vector>

#include <adapters/mpm/run/measures.hpp>

#include "support/neighbour.hpp"
#include "support/pressed_sand.hpp"

namespace {

using namespace mpm_test;

// Within a cell, which has particles of both, as where a host hands them over now and then.
bool is_lower(const Cut& cut, const Axis& axis, const Particles& q, std::ptrdiff_t p) {
    const double at = 0.6 * axis[cut.cell] + 0.4 * axis[cut.cell + 1];
    return q(cut.direction == 0 ? column::r : column::z, p) < at;
}

// One process of the two, and its particles.
class Process {
  public:
    Process(const PressedSand& made, Mailbox& with, int number)
        : mailbox(with), rank(number), axis(made.axis(with.cut.direction)),
          neighbour(with, number, made.axis(0), made.axis(1)),
          simulation(made.build(&neighbour, neighbour.begin, neighbour.end, [this](Body& body) {
              Particles& q = body.particles;
              for (std::ptrdiff_t p = q.size(); p-- > 0;)
                  if (is_lower(mailbox.cut, axis, q, p) != (rank == 0)) q.remove(p);
          })) {}
    void step() {
        simulation->step();
        for (std::size_t b = 0; b < simulation->bodies(); ++b) migrate(b);
    }
    // Energies, and all that is global; then id and columns of each particle.
    std::vector<double> totals();
    std::vector<std::vector<double>> rows(std::size_t body);
    long migrated = 0;

  private:
    void migrate(std::size_t body) {
        Particles& q = simulation->body(body).particles;
        const auto columns = static_cast<std::size_t>(q.column_count());
        std::vector<double> leaving;
        for (std::ptrdiff_t p = q.size(); p-- > 0;) {
            if (is_lower(mailbox.cut, axis, q, p) == (rank == 0)) continue;
            leaving.push_back(q.ids()[p]);
            for (std::size_t c = 0; c < columns; ++c) leaving.push_back(q(static_cast<int>(c), p));
            q.remove(p);
        }
        const std::vector<char> in =
            mailbox.swap(rank, leaving.data(), leaving.size() * sizeof(double));
        std::vector<double> coming(in.size() / sizeof(double));
        if (!in.empty()) std::memcpy(coming.data(), in.data(), in.size());
        for (std::size_t i = 0; i < coming.size(); i += columns + 1, ++migrated)
            q.add(static_cast<int>(coming[i]), &coming[i + 1]);
        if (!leaving.empty() || !coming.empty()) simulation->particles_changed(body);
    }
    Mailbox& mailbox;
    int rank;
    Axis axis;
    Neighbour neighbour;
    std::unique_ptr<Simulation> simulation;
};

// Of the only contact.
std::vector<double> contact_totals_of(const Simulation& s) {
    if (s.surface_contact_count() > 0) {
        const grit_surface_totals& contact = s.surface_contact(0).totals();
        const Faces& faces = s.surface_contact(0).faces();
        return {contact.impulse_on_a[0],
                contact.impulse_on_a[1],
                contact.dissipation_tangential,
                contact.area,
                contact.smallest_gap,
                static_cast<double>(contact.sweeps),
                faces.along_r[0],
                faces.along_z[1]};
    }
    const grit_contact_totals& contact = s.contact(0).totals();
    const ContactPair::Measured& faces = s.contact(0).faces();
    return {contact.force_on_a[0], contact.force_on_a[1], contact.dissipation_tangential,
            faces.along_r[0],      faces.along_z[1],      faces.largest_gap};
}

std::vector<double> totals_of(Simulation& s) {
    const Energy e = s.energy();
    const grit::Vector2 load = s.traction_force(0), velocity = mean_velocity(s, 0);
    std::vector<double> out{s.time(),
                            s.next_step(),
                            e.kinetic,
                            e.stored,
                            e.kinetic_0,
                            e.stored_0,
                            e.external_work,
                            e.traction_work,
                            e.contact,
                            e.damping,
                            e.viscosity,
                            e.absorbed,
                            e.transfer,
                            e.pic,
                            load[1],
                            velocity[1],
                            stored_energy(s, 0),
                            level_of(s, 0, DepthOf::lowest_point),
                            level_of(s, 0, DepthOf::centre_of_mass),
                            base_reaction(s),
                            unbalanced_share(s, s.next_step())};
    for (const double x : contact_totals_of(s)) out.push_back(x);
    if (s.body(1).water) {
        const Faces pore = s.contact_count() > 0 ? s.pore_faces(0) : Faces{};
        const Extremes pressures = pore_pressures(s);
        out.insert(out.end(), {e.pore_water, e.half, e.drag, e.implicit, pore.along_r[0],
                               pore.along_z[1], pressures.least, pressures.largest});
    }
    return out;
}

std::vector<std::vector<double>> rows_of(Simulation& s, std::size_t body) {
    const Particles& q = s.body(body).particles;
    std::vector<std::vector<double>> out;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
        out.push_back({static_cast<double>(q.ids()[p])});
        for (int c = 0; c < q.column_count(); ++c) out.back().push_back(q(c, p));
    }
    return out;
}

std::vector<double> Process::totals() { return totals_of(*simulation); }
std::vector<std::vector<double>> Process::rows(std::size_t body) {
    return rows_of(*simulation, body);
}

struct Result {
    std::vector<double> totals[2];  // of both processes
    std::vector<std::vector<double>> rows;
    long migrated = 0;
};

std::unique_ptr<Simulation> after(const PressedSand& made, int steps) {
    auto simulation = made.build();
    for (int i = 0; i < steps; ++i) simulation->step();
    return simulation;
}

Result result_of(Simulation& simulation) {
    Result out;
    out.totals[0] = out.totals[1] = totals_of(simulation);
    for (std::size_t b = 0; b < simulation.bodies(); ++b)
        for (auto& row : rows_of(simulation, b)) out.rows.push_back(row);
    return out;
}

Result alone(const PressedSand& made, int steps) { return result_of(*after(made, steps)); }

Result together(const PressedSand& made, const Cut& cut, int steps, std::size_t bodies) {
    Mailbox mailbox(cut);
    Result out, other;
    const auto work = [&](int rank, Result& into) {
        Process process(made, mailbox, rank);
        for (int i = 0; i < steps; ++i) process.step();
        into.totals[rank] = process.totals();
        for (std::size_t b = 0; b < bodies; ++b)
            for (auto& row : process.rows(b)) into.rows.push_back(row);
        into.migrated = process.migrated;
    };
    std::thread upper(work, 1, std::ref(other));
    work(0, out);
    upper.join();
    out.totals[1] = other.totals[1];
    out.rows.insert(out.rows.end(), other.rows.begin(), other.rows.end());
    out.migrated += other.migrated;
    return out;
}

// Each id comes with its columns; ids of bodies may be the same.
bool same_bits(std::vector<std::vector<double>> a, std::vector<std::vector<double>> b) {
    const auto less = [](const std::vector<double>& x, const std::vector<double>& y) {
        return std::memcmp(x.data(), y.data(), std::min(x.size(), y.size()) * sizeof(double)) < 0;
    };
    std::sort(a.begin(), a.end(), less);
    std::sort(b.begin(), b.end(), less);
    const auto same = [](const std::vector<double>& x, const std::vector<double>& y) {
        return x.size() == y.size() &&
               std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

class SharedGrid : public testing::TestWithParam<std::tuple<Scheme, bool, bool>> {
  protected:
    static PressedSand made() {
        PressedSand out;
        out.settings.scheme = std::get<0>(GetParam());
        out.settings.cell_mean = std::get<1>(GetParam());
        out.at_surfaces = std::get<2>(GetParam());
        out.settings.linear_viscosity = 0.1;
        out.settings.fixed_point = true;
        out.growth = 1.04;
        return out;
    }
};

TEST_P(SharedGrid, InFixedPointTwoProcessesGetTheBitsOfOne) {
    const PressedSand problem = made();
    constexpr int steps = 120;
    const Result one = alone(problem, steps);
    EXPECT_GT(one.totals[0][8], 0.0);  // contact has taken energy
    long migrated = 0;
    // Across the block and the sand's surface; through the block's middle, along its way; along r.
    for (const Cut cut : {Cut{1, 10}, Cut{1, 12}, Cut{0, 3}, Cut{0, 5}}) {
        const Result two = together(problem, cut, steps, 3);
        const auto where = testing::Message() << "cut " << cut.direction << ' ' << cut.cell;
        for (const int rank : {0, 1}) {
            ASSERT_EQ(two.totals[rank].size(), one.totals[0].size());
            for (std::size_t i = 0; i < one.totals[0].size(); ++i)
                EXPECT_EQ(two.totals[rank][i], one.totals[0][i]) << where << ", total " << i;
        }
        EXPECT_TRUE(same_bits(two.rows, one.rows)) << where;
        migrated += two.migrated;
    }
    EXPECT_GT(migrated, 0);
}

TEST(SharedSprings, WorkAgainstTheSameOverlap) {
    PressedSand problem;
    problem.settings.fixed_point = true;
    problem.relaxation_time = 1e-4;
    problem.stiffness = 1e8;
    const Result one = alone(problem, 120);
    for (const Cut cut : {Cut{1, 10}, Cut{1, 12}, Cut{0, 3}, Cut{0, 5}}) {
        const Result two = together(problem, cut, 120, 3);
        EXPECT_EQ(two.totals[0], one.totals[0]) << cut.direction << ' ' << cut.cell;
        EXPECT_TRUE(same_bits(two.rows, one.rows)) << cut.direction << ' ' << cut.cell;
    }
}

// Pore water, and the contact of a block that presses on it.
class SharedWater : public testing::TestWithParam<std::tuple<bool, bool>> {};
INSTANTIATE_TEST_SUITE_P(FlowsImplicit, SharedWater,
                         testing::Combine(testing::Bool(), testing::Bool()));

TEST_P(SharedWater, HasTheBitsOfOneProcess) {
    const auto [flows, implicit] = GetParam();
    PressedSand problem;
    problem.settings.fixed_point = true;
    problem.growth = 1.04;
    problem.water = PressedSand::soft_water(flows, implicit);
    constexpr int steps = 160;
    const Result one = alone(problem, steps);
    const auto from_end = [&](std::size_t k) { return *(one.totals[0].end() - 8 + k); };
    EXPECT_NE(from_end(0), 0.0);                 // compression of water
    EXPECT_EQ(from_end(3) > 0.0, implicit);      // taken by an implicit pressure
    EXPECT_EQ(from_end(5) != 0.0, implicit);     // ... pressed on the block [N]
    EXPECT_GT(from_end(7), 2.0 * 9810.0 * 0.5);  // far beyond that at rest
    for (const Cut cut : {Cut{1, 10}, Cut{1, 7}, Cut{0, 3}, Cut{0, 5}}) {
        const Result two = together(problem, cut, steps, 3);
        EXPECT_EQ(two.totals[0], one.totals[0]) << cut.direction << ' ' << cut.cell;
        EXPECT_EQ(two.totals[1], one.totals[0]) << cut.direction << ' ' << cut.cell;
        EXPECT_TRUE(same_bits(two.rows, one.rows)) << cut.direction << ' ' << cut.cell;
    }
}

// Particles with a cavity in the cells before a cut and in those behind it.
std::array<int, 2> cavities_beside(const Cut& cut, Simulation& simulation) {
    const Body& body = simulation.body(1);
    const Axis axis = PressedSand{}.axis(cut.direction);
    std::array<int, 2> out{};
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles(body.water->first, p) >= -body.water->largest_tension) continue;
        const double at = body.particles(cut.direction == 0 ? column::r : column::z, p);
        for (const int behind : {0, 1})
            out[behind] += axis.view().cell_of(at) == cut.cell - 1 + behind;
    }
    return out;
}

// Water that cavitates on both sides of a cut: what alternates there goes from the cells of one process to those of the other.
TEST(SharedCavities, HaveTheBitsOfOneProcess) {
    for (const bool flows : {false, true}) {
        PressedSand problem;
        problem.settings.fixed_point = true;
        problem.water = PressedSand::soft_water(flows, true);
        problem.water->largest_tension = 500.0;
        problem.water->opening_cap = 0.66;  // pores that are open keep theirs
        constexpr int steps = 120;
        const auto simulation = after(problem, steps);
        const Result one = result_of(*simulation);
        for (const Cut cut : {Cut{1, 9}, Cut{0, 3}, Cut{0, 4}}) {
            const auto where = testing::Message()
                               << flows << ' ' << cut.direction << ' ' << cut.cell;
            for (const int cavities : cavities_beside(cut, *simulation))
                EXPECT_GT(cavities, 0) << where;
            const Result two = together(problem, cut, steps, 3);
            EXPECT_EQ(two.totals[0], one.totals[0]) << where;
            EXPECT_EQ(two.totals[1], one.totals[0]) << where;
            EXPECT_TRUE(same_bits(two.rows, one.rows)) << where;
        }
    }
}

// With explicit pressure surfaces are those of all processes, and so is the water behind them.
TEST(SharedWaterAtSurfaces, HasTheBitsOfOneProcess) {
    for (const bool flows : {false, true}) {
        PressedSand problem;
        problem.settings.fixed_point = true;
        problem.at_surfaces = true;
        problem.water = PressedSand::soft_water(flows, false);
        constexpr int steps = 120;
        const Result one = alone(problem, steps);
        for (const Cut cut : {Cut{1, 10}, Cut{0, 3}}) {
            const Result two = together(problem, cut, steps, 3);
            EXPECT_EQ(two.totals[0], one.totals[0]) << flows << ' ' << cut.direction;
            EXPECT_EQ(two.totals[1], one.totals[0]) << flows << ' ' << cut.direction;
            EXPECT_TRUE(same_bits(two.rows, one.rows)) << flows << ' ' << cut.direction;
        }
    }
}

// Nothing moves but by tractions, so that their last bits are seen; cuts are where several meet at a node.
TEST(SharedLoads, AddUpToTheSameBits) {
    PressedSand problem;
    problem.settings.fixed_point = true;
    problem.settings.gravity_z = 0.0;
    problem.ring = false;
    problem.block_velocity = 0.0;
    const Result one = alone(problem, 6);
    for (const Cut cut : {Cut{0, 1}, Cut{0, 2}, Cut{0, 3}, Cut{1, 14}}) {
        const Result two = together(problem, cut, 6, 2);
        EXPECT_TRUE(same_bits(two.rows, one.rows)) << cut.direction << ' ' << cut.cell;
    }
}

TEST(SharedAxis, HasTheLimitsOfTheWholeAtItsEnds) {
    const Axis whole({0.0, 1.0, 3.0, 5.0, 6.0, 8.0, 9.0}), part = whole.part(1, 5);
    ASSERT_EQ(part.cells(), 4);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(part[i], whole[i + 1]);
        EXPECT_EQ(part.view().limit[i], whole.view().limit[i + 1]);
    }
    EXPECT_EQ(part.view().limit[0], 1.0);  // the cell before is no part of it
    EXPECT_EQ(part[4], 8.0);
}

// Beside a node, where roundoff of bins that begin there would say another one.
TEST(SharedAxis, KnowsTheCellOfEveryPointAsTheWholeDoes) {
    for (const double from : {-0.8, 0.0, 0.3}) {
        const Axis whole = Axis::uniform(from, from + 1.2, 12);
        for (int begin = 0; begin < 6; ++begin)
            for (int end = begin + 1; end <= 12; ++end) {
                const Axis part = whole.part(begin, end);
                for (int node = begin + 1; node < end; ++node) {
                    double x = std::nextafter(whole[node], from - 1.0);
                    for (const int below : {1, 0}) {
                        EXPECT_EQ(whole.view().cell_of(x), node - below) << x;
                        EXPECT_EQ(part.view().cell_of(x), node - below - begin) << x;
                        x = whole[node];
                    }
                    x = whole[node] - 1e-18;  // none, but where the node is at 0
                    EXPECT_EQ(part.view().cell_of(x) + begin, whole.view().cell_of(x)) << x;
                }
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, SharedGrid,
                         testing::Combine(testing::Values(Scheme::usl, Scheme::musl, Scheme::usf),
                                          testing::Bool(), testing::Bool()));

TEST(SharedGridOfDoubles, TwoProcessesDifferByRoundoff) {
    PressedSand problem;
    problem.block_velocity = -2.0;  // a fast one in free flight brings more roundoff along
    const Result one = alone(problem, 60);
    const Result two = together(problem, {1, 11}, 60, 3);
    EXPECT_EQ(two.totals[0], two.totals[1]);  // both the same, bit by bit
    for (std::size_t i = 0; i < one.totals[0].size(); ++i)
        EXPECT_NEAR(two.totals[0][i], one.totals[0][i], 1e-9 * std::abs(one.totals[0][i])) << i;
    EXPECT_EQ(two.rows.size(), one.rows.size());
}

TEST(SharedGridOfDoubles, BothProcessesHaveTheSameContactAtSurfaces) {
    PressedSand problem;
    problem.at_surfaces = true;
    const Result two = together(problem, {0, 3}, 60, 3);
    EXPECT_GT(two.totals[0][8], 0.0);  // contact has taken energy
    EXPECT_EQ(two.totals[0], two.totals[1]);
}

TEST(SharedGridOfDoubles, PenaltyContactIsForOneProcess) {
    Exchange exchange;
    Simulation simulation(Axis::uniform(0.0, 1.0, 4), Axis::uniform(0.0, 1.0, 4), {}, &exchange);
    EXPECT_THROW(simulation.add_contact(PenaltyLaw{}), std::invalid_argument);
}

}  // namespace
