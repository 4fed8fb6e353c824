// SPDX-License-Identifier: BSD-3-Clause
// A grid that two processes share, here two threads: each has the particles of its part, and two cells more
// of the grid. In fixed point they get the bits of one process alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <cstring>
#include <thread>
#include <vector>

#include <adapters/mpm/measures.hpp>

#include "support/pressed_sand.hpp"

namespace {

using namespace mpm_test;

constexpr int halo = 2;  // cells

// Two ranges of cells along r (0) or z (1), which meet at a grid line.
struct Cut {
    int direction;
    int cell;  // the first of the upper part
};

// What both hand to each other. Both are at the same call.
class Meeting {
  public:
    explicit Meeting(const Cut& where) : cut(where) {}
    // Gives bytes, gets those of the other.
    std::vector<char> swap(int rank, const void* data, std::size_t size) {
        const auto* bytes = static_cast<const char*>(data);
        mail[rank].assign(bytes, bytes + size);
        both.arrive_and_wait();
        std::vector<char> out = mail[1 - rank];
        both.arrive_and_wait();
        return out;
    }
    const Cut cut;

  private:
    std::vector<char> mail[2];
    std::barrier<> both{2};
};

class Neighbour : public Exchange {
  public:
    Neighbour(Meeting& with, int number, int global_r, int global_z) : meeting(with), rank(number) {
        const Cut& cut = meeting.cut;
        const int cells[] = {global_r, global_z};
        for (const int k : {0, 1}) {
            const bool is_cut = k == cut.direction;
            begin[k] = is_cut && rank == 1 ? cut.cell - halo : 0;
            end[k] = is_cut && rank == 0 ? cut.cell + halo : cells[k];
        }
        const int n_r = end[0] - begin[0] + 1, n_z = end[1] - begin[1] + 1;
        mine.assign(static_cast<std::size_t>(n_r * n_z), 1);
        for (int j = 0; j < n_z; ++j)
            for (int i = 0; i < n_r; ++i) {
                const int at = (cut.direction == 0 ? i : j) + begin[cut.direction];
                const auto node = static_cast<std::size_t>(j * n_r + i);
                mine[node] = (at < cut.cell) == (rank == 0);
                if (std::abs(at - cut.cell) <= halo) shared_nodes.push_back(node);
                const bool is_cell = i + 1 < n_r && j + 1 < n_z;
                if (is_cell && at >= cut.cell - halo && at < cut.cell + halo)
                    shared_cells.push_back(static_cast<std::size_t>(j * (n_r - 1) + i));
            }
    }
    const std::uint8_t* counted() const override { return mine.data(); }
    void sum_nodes(NodeRecord* x, std::ptrdiff_t) override { add<8>(x->value, shared_nodes); }
    void sum_nodes(NodeIntegers* x, std::ptrdiff_t) override { add<8>(x->value, shared_nodes); }
    void sum_nodes(Vector* x, std::ptrdiff_t) override { add<2>(&x->r, shared_nodes); }
    void sum_cells(CellIntegers* x, std::ptrdiff_t) override { add<2>(&x->volume, shared_cells); }
    void min_nodes(double* x, std::ptrdiff_t, int per_node) override {
        const auto smaller = [](double a, double b) { return std::min(a, b); };
        ASSERT_EQ(per_node, 2);
        reduce<2>(x, shared_nodes, smaller);
    }
    void max(double* x, int count) override {
        reduce<1>(x, all(count), [](double a, double b) { return std::max(a, b); });
    }
    void sum(double* x, int count) override { add<1>(x, all(count)); }
    void sum(std::int64_t* x, int count) override { add<1>(x, all(count)); }

    int begin[2], end[2];  // cells

  private:
    static std::vector<std::size_t> all(int count) {
        std::vector<std::size_t> out;
        for (int i = 0; i < count; ++i) out.push_back(static_cast<std::size_t>(i));
        return out;
    }
    template <int each, class Number> void add(Number* x, const std::vector<std::size_t>& places) {
        // The lower one's first, so that both get the same.
        reduce<each>(x, places, [this](Number a, Number b) { return rank == 0 ? a + b : b + a; });
    }
    template <int each, class Number, class Operation>
    void reduce(Number* x, const std::vector<std::size_t>& places, const Operation& operation) {
        std::vector<Number> out;
        for (const std::size_t place : places)
            out.insert(out.end(), x + each * place, x + each * (place + 1));
        const std::vector<char> in = meeting.swap(rank, out.data(), out.size() * sizeof(Number));
        ASSERT_EQ(in.size(), out.size() * sizeof(Number));
        std::size_t at = 0;
        for (const std::size_t place : places)
            for (int c = 0; c < each; ++c, at += sizeof(Number)) {
                Number other;
                std::memcpy(&other, in.data() + at, sizeof other);
                Number& own = x[each * place + static_cast<std::size_t>(c)];
                own = operation(own, other);
            }
    }
    Meeting& meeting;
    int rank;
    std::vector<std::uint8_t> mine;
    std::vector<std::size_t> shared_nodes, shared_cells;
};

bool is_lower(const Cut& cut, const Axis& axis, const Particles& q, std::ptrdiff_t p) {
    return q(cut.direction == 0 ? column::r : column::z, p) < axis[cut.cell];
}

// One process of the two, and its particles.
class Process {
  public:
    Process(const PressedSand& made, Meeting& with, int number)
        : meeting(with), rank(number), axis(made.axis(with.cut.direction)),
          neighbour(with, number, made.axis(0).cells(), made.axis(1).cells()),
          simulation(made.build(&neighbour, neighbour.begin, neighbour.end, [this](Body& body) {
              Particles& q = body.particles;
              for (std::ptrdiff_t p = q.size(); p-- > 0;)
                  if (is_lower(meeting.cut, axis, q, p) != (rank == 0)) q.remove(p);
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
            if (is_lower(meeting.cut, axis, q, p) == (rank == 0)) continue;
            leaving.push_back(q.ids()[p]);
            for (std::size_t c = 0; c < columns; ++c) leaving.push_back(q(static_cast<int>(c), p));
            q.remove(p);
        }
        const std::vector<char> in =
            meeting.swap(rank, leaving.data(), leaving.size() * sizeof(double));
        std::vector<double> coming(in.size() / sizeof(double));
        if (!in.empty()) std::memcpy(coming.data(), in.data(), in.size());
        for (std::size_t i = 0; i < coming.size(); i += columns + 1, ++migrated)
            q.add(static_cast<int>(coming[i]), &coming[i + 1]);
        if (!leaving.empty() || !coming.empty()) simulation->particles_changed(body);
    }
    Meeting& meeting;
    int rank;
    Axis axis;
    Neighbour neighbour;
    std::unique_ptr<Simulation> simulation;
};

std::vector<double> totals_of(Simulation& s) {
    const Energy e = s.energy();
    const grit_contact_totals& contact = s.contact(0).totals();
    const ContactPair::Faces& faces = s.contact(0).faces();
    const Vector load = s.traction_force(0), velocity = mean_velocity(s, 0);
    return {s.time(),
            s.next_step(),
            e.kinetic,
            e.stored,
            e.kinetic_0,
            e.stored_0,
            e.external_work,
            e.contact,
            e.damping,
            e.viscosity,
            e.absorbed,
            e.transfer,
            e.pic,
            contact.force_on_a[0],
            contact.force_on_a[1],
            contact.dissipation_tangential,
            faces.along_r.r,
            faces.along_z.z,
            faces.largest_gap,
            load.z,
            velocity.z,
            level_of(s, 0, DepthOf::lowest_point),
            level_of(s, 0, DepthOf::centre_of_mass),
            base_reaction(s),
            unbalanced_share(s, s.next_step())};
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

Result alone(const PressedSand& made, int steps) {
    const auto simulation = made.build();
    for (int i = 0; i < steps; ++i) simulation->step();
    Result out;
    out.totals[0] = out.totals[1] = totals_of(*simulation);
    for (std::size_t b = 0; b < simulation->bodies(); ++b)
        for (auto& row : rows_of(*simulation, b)) out.rows.push_back(row);
    return out;
}

Result together(const PressedSand& made, const Cut& cut, int steps, std::size_t bodies) {
    Meeting meeting(cut);
    Result out, other;
    const auto work = [&](int rank, Result& into) {
        Process process(made, meeting, rank);
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

class SharedGrid : public testing::TestWithParam<std::tuple<Scheme, bool>> {
  protected:
    static PressedSand made() {
        PressedSand out;
        out.settings.scheme = std::get<0>(GetParam());
        out.settings.cell_mean = std::get<1>(GetParam());
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
    EXPECT_GT(one.totals[0][7], 0.0);  // contact has taken energy
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

INSTANTIATE_TEST_SUITE_P(Schemes, SharedGrid,
                         testing::Combine(testing::Values(Scheme::usl, Scheme::musl, Scheme::usf),
                                          testing::Bool()));

TEST(SharedGridOfDoubles, TwoProcessesDifferByRoundoff) {
    PressedSand problem;
    const Result one = alone(problem, 60);
    const Result two = together(problem, {1, 11}, 60, 3);
    EXPECT_EQ(two.totals[0], two.totals[1]);  // both the same, bit by bit
    for (std::size_t i = 0; i < one.totals[0].size(); ++i)
        EXPECT_NEAR(two.totals[0][i], one.totals[0][i], 1e-9 * std::abs(one.totals[0][i])) << i;
    EXPECT_EQ(two.rows.size(), one.rows.size());
}

TEST(SharedGridOfDoubles, PenaltyContactIsForOneProcess) {
    Exchange exchange;
    Simulation simulation(Axis::uniform(0.0, 1.0, 4), Axis::uniform(0.0, 1.0, 4), {}, &exchange);
    EXPECT_THROW(simulation.add_contact(PenaltyLaw{}), std::invalid_argument);
}

}  // namespace
