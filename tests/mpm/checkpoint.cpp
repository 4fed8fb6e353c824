// SPDX-License-Identifier: BSD-3-Clause
// A simulation that goes on from a checkpoint is the one that was never stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include <adapters/mpm/io/checkpoint.hpp>
#include <adapters/mpm/io/checksum.hpp>
#include <adapters/mpm/run/history.hpp>
#include <adapters/mpm/run/measures.hpp>
#include <grit/version.h>

#include "support/goes_on.hpp"
#include "support/plans.hpp"
#include "support/pressed_sand.hpp"

namespace {

using namespace mpm_test;

template <class Number> void append(std::string& to, const Number* data, std::size_t count) {
    to.append(reinterpret_cast<const char*>(data), count * sizeof *data);
}

// All that can be seen of it, the order of its particles included.
std::string seen(Simulation& simulation, std::size_t bodies) {
    std::string out;
    const Energy energy = simulation.energy();
    append(out, &energy, 1);
    const double numbers[] = {simulation.time(), simulation.next_step()};
    append(out, numbers, 2);
    out += std::to_string(simulation.steps());
    for (std::size_t b = 0; b < bodies; ++b) {
        Particles& q = simulation.body(b).particles;
        const auto n = static_cast<std::size_t>(q.size());
        append(out, q.ids(), n);
        for (int c = 0; c < (b == 1 ? Sand::work + 1 : column::own); ++c)
            append(out, q.view()[c], n);
        for (int id = 0; id < q.size(); ++id) out += std::to_string(simulation.find(b, id)) + ' ';
        append(out, simulation.records(b).data(), simulation.records(b).size());
        append(out, simulation.motions(b).data(), simulation.motions(b).size());
    }
    const grit_contact_totals& totals = simulation.contact(0).totals();
    append(out, totals.impulse_on_a, 2);
    append(out, &totals.dissipation_normal, 1);
    for (std::size_t b = 0; b < bodies; ++b) {
        const grit::Vector2 force = simulation.traction_force(b);
        append(out, &force, 1);
    }
    return out;
}

void restore_from(const std::string& file, Simulation& simulation) {
    std::istringstream in(file);
    restore(simulation, in);
}

std::string refusal(const std::string& file, Simulation& simulation) {
    try {
        restore_from(file, simulation);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

class Checkpoint : public testing::TestWithParam<std::tuple<Scheme, bool>> {
  protected:
    static constexpr int steps = 70;
    PressedSand made() const {
        PressedSand out;
        out.settings.scheme = std::get<0>(GetParam());
        out.settings.fixed_point = std::get<1>(GetParam());
        out.settings.linear_viscosity = 0.1;
        return out;
    }
};

TEST_P(Checkpoint, GoesOnBitwiseAsIfNeverStopped) {
    const PressedSand first = made();
    const auto uninterrupted = first.build();
    std::vector<std::string> files;
    for (int i = 0; i < steps; ++i) {
        files.push_back(saved(*uninterrupted));
        uninterrupted->step();
    }
    const std::string end = seen(*uninterrupted, 3);
    EXPECT_GT(uninterrupted->energy().contact, 0.0);
    const int* ids = uninterrupted->body(0).particles.ids();
    EXPECT_FALSE(std::is_sorted(ids, ids + uninterrupted->body(0).particles.size()));

    std::mt19937 generator(3);
    for (int trial = 0; trial < 4; ++trial) {
        const auto stop = std::uniform_int_distribution<std::size_t>(0, steps - 1)(generator);
        PressedSand again = first;
        again.settings.threads = 1 + trial % 2;
        // As a stage may have set them: the checkpoint knows.
        again.settings.cfl = 0.3;
        again.settings.largest_step = 1e-6;
        again.settings.pic_rate = 3.0;
        again.settings.local_damping = 0.3;
        again.settings.gravity_r = again.settings.gravity_z = -1.0;
        const auto restored = again.build();
        restore_from(files[stop], *restored);
        for (auto i = stop; i < steps; ++i) restored->step();
        EXPECT_TRUE(seen(*restored, 3) == end) << "from step " << stop;
    }
}

TEST_P(Checkpoint, ShowsWhatTheSimulationShowed) {
    const auto stopped = made().build(), restored = made().build();
    for (int i = 0; i < steps; ++i) stopped->step();
    restore_from(saved(*stopped), *restored);
    EXPECT_TRUE(seen(*restored, 3) == seen(*stopped, 3));
}

INSTANTIATE_TEST_SUITE_P(Schemes, Checkpoint,
                         testing::Combine(testing::Values(Scheme::usl, Scheme::musl, Scheme::usf),
                                          testing::Bool()));

// Two blocks in penalty contact that slide and stretch, so that their lines are split.
std::unique_ptr<Simulation> sliding_blocks() {
    Settings settings{.axisymmetric = false, .cfl = 0.2};
    auto out = std::make_unique<Simulation>(Axis::uniform(0.0, 4.0, 40),
                                            Axis::uniform(0.0, 1.0, 10), settings);
    for (const int k : {0, 1}) {
        Body block = make_box({0.5, 1.5, 0.2 + 0.3 * k, 0.5 + 0.3 * k, 20, 6, 1000.0}, false,
                              std::make_unique<NeoHooke>(1e5, 0.2));
        const ParticleView q = block.particles.view();
        for (std::ptrdiff_t p = 0; p < block.particles.size(); ++p) {
            q[column::v_r][p] = 4.0 * (q[column::r][p] - 1.0) + (k == 0 ? 0.5 : -0.5);
            q[column::v_z][p] = k == 0 ? 0.5 : -0.5;
        }
        out->add_body(std::move(block));
    }
    PenaltyLaw law = penalty_law(0.3, 1.0, 1e5, 0.1);
    law.line_a.points = {{1.5, 0.2}, {1.5, 0.5}, {0.5, 0.5}, {0.5, 0.2}};
    law.line_b = {{{0.5, 0.5}, {1.5, 0.5}, {1.5, 0.8}, {0.5, 0.8}}, true};
    out->add_contact(law);
    return out;
}

// Where its particles and vertices are, and what it has cost.
std::string slid(Simulation& simulation) {
    std::string out;
    const Energy energy = simulation.energy();
    append(out, &energy, 1);
    for (const std::size_t b : {0u, 1u}) {
        Particles& q = simulation.body(b).particles;
        for (int c = 0; c < column::own; ++c)
            append(out, q.view()[c], static_cast<std::size_t>(q.size()));
        const std::vector<double>& x = simulation.penalty_contact(0).vertices(static_cast<int>(b));
        append(out, x.data(), x.size());
    }
    return out;
}

TEST(CheckpointOfPenaltyContact, GoesOnWithLinesThatHaveBeenSplit) {
    const auto uninterrupted = sliding_blocks();
    const std::size_t vertices = uninterrupted->penalty_contact(0).vertices(1).size();
    for (int i = 0; i < 60; ++i) uninterrupted->step();
    EXPECT_GT(uninterrupted->penalty_contact(0).vertices(1).size(), vertices);
    EXPECT_GT(uninterrupted->penalty_contact(0).totals().contacts_a, 0);
    const std::string file = saved(*uninterrupted);
    for (int i = 0; i < 40; ++i) uninterrupted->step();
    const auto restored = sliding_blocks();
    restore_from(file, *restored);
    for (int i = 0; i < 40; ++i) restored->step();
    EXPECT_TRUE(slid(*restored) == slid(*uninterrupted));

    const auto untouched = sliding_blocks();
    const std::string before = slid(*untouched);
    for (std::size_t part = 1; part < 64; ++part)
        EXPECT_NE(refusal(file.substr(0, file.size() * part / 64), *untouched), "accepted");
    EXPECT_TRUE(slid(*untouched) == before);
}

// A column under a plate, in nodal or penalty contact, pushed by a traction.
Case pushed_case(bool penalty) {
    Case plan = column_case();
    plan.bodies.push_back(elastic_box("plate", 0.0, 0.2, 1.0, 1.1));
    plan.bodies[1].velocity = {0.0, -0.5};
    plan.tractions = {{.body = "plate",
                       .edge = Edge::top,
                       .direction = {0.0, -1.0},
                       .stress = TimeTable{{0.0, 0.05}, {1e3, 1e4}}}};
    ContactPlan contact{.stiff = "plate", .soft = "column"};
    contact.law = GRIT_CONTACT_GEO;
    contact.friction_coefficient = 0.3;
    if (penalty)
        contact.penalty = PenaltyPlan{
            1.3e6, 5.0, {{{0.0, 1.0}, {0.2, 1.0}}, false}, {{{0.2, 1.0}, {0.0, 1.0}}, false}};
    plan.contacts = {contact};
    plan.stages[0].local_damping = 0.1;
    plan.history.body = "plate";
    plan.history.interval = 1e9;
    return plan;
}

std::vector<double> shown(Runner& runner) {
    std::vector<double> out;
    const HistoryRow row = runner.row_so_far();
    for (const HistoryColumn& column : history_columns()) out.push_back(column.value(row));
    const ContactForces forces = contact_forces(runner.simulation(), 0);
    out.insert(out.end(),
               {forces.tip[1], forces.shaft[1], forces.largest_gap,
                base_reaction(runner.simulation()), runner.simulation().traction_force(1)[1]});
    return out;
}

TEST(CheckpointOfARun, ShowsTheRowThatItShowed) {
    for (const bool penalty : {false, true}) {
        const Case plan = pushed_case(penalty);
        Runner uninterrupted(plan);
        int pressed = 0;
        for (int i = 0; i < 120; ++i) {
            uninterrupted.step();
            if (i % 10 != 9) continue;
            Runner resumed(plan);
            resumed.resume(uninterrupted.state());
            restore_from(saved(uninterrupted.simulation()), resumed.simulation());
            const std::vector<double> before = shown(uninterrupted), after = shown(resumed);
            EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(double)), 0)
                << "penalty " << penalty << ", step " << i;
            for (std::size_t c = 0; c < before.size(); ++c)
                EXPECT_TRUE(before[c] == after[c] ||
                            (std::isnan(before[c]) && std::isnan(after[c])))
                    << c << ": " << before[c] << ", then " << after[c];
            pressed += before[before.size() - 5] != 0.0;
        }
        EXPECT_GT(pressed, 3);
    }
}

// One number of the header changed, as another program would have written it.
std::string with_header(std::string file, std::size_t at, std::int32_t number) {
    std::memcpy(file.data() + at, &number, sizeof number);
    const std::uint64_t sum = checksum(file.data(), 56);
    std::memcpy(file.data() + 56, &sum, sizeof sum);
    return file;
}

class RefusedCheckpoint : public testing::Test {
  protected:
    RefusedCheckpoint() {
        for (int i = 0; i < 3; ++i) original->step();
        file = saved(*original);
        before = seen(*target, 3);
    }
    std::unique_ptr<Simulation> original = PressedSand{}.build(), target = PressedSand{}.build();
    std::string file, before;
};

TEST_F(RefusedCheckpoint, IsOneThatWasCutOff) {
    for (std::size_t part = 0; part < 64; ++part) {
        const std::string answer = refusal(file.substr(0, file.size() * part / 64), *target);
        EXPECT_NE(answer.find(part == 0 ? "none of grit's" : "truncated"), std::string::npos)
            << answer;
    }
    EXPECT_NE(refusal(file.substr(0, file.size() - 1), *target).find("truncated"),
              std::string::npos);
    EXPECT_TRUE(seen(*target, 3) == before);
    EXPECT_EQ(refusal(file, *target), "accepted");
}

TEST_F(RefusedCheckpoint, IsOneWithAChangedByte) {
    std::mt19937 generator(4);
    std::uniform_int_distribution<std::size_t> anywhere(0, file.size() - 1);
    for (std::size_t i = 0; i < 200; ++i) {
        std::string damaged = file;
        damaged[i < 64 ? i : anywhere(generator)] ^= static_cast<char>(1 << i % 8);
        EXPECT_NE(refusal(damaged, *target), "accepted") << i;
    }
    EXPECT_TRUE(seen(*target, 3) == before);
}

TEST_F(RefusedCheckpoint, NamesWhatDiffersInTheSimulation) {
    const auto refused_by = [this](const PressedSand& other) {
        const auto simulation = other.build();
        const std::size_t bodies = other.ring ? 3 : 2;
        const std::string untouched = seen(*simulation, bodies);
        const std::string answer = refusal(file, *simulation);
        EXPECT_TRUE(seen(*simulation, bodies) == untouched);
        return answer;
    };
    PressedSand fewer, taller, musl, integers, heavier;
    fewer.ring = false;
    taller.cells_z = 26;
    musl.settings.scheme = Scheme::musl;
    integers.settings.fixed_point = true;
    heavier.block_density *= 1.0000001;
    EXPECT_NE(refused_by(fewer).find("it has 'bodies: 3', this has 'bodies: 2'"),
              std::string::npos);
    EXPECT_NE(refused_by(taller).find("'grid along z: 27 nodes"), std::string::npos);
    EXPECT_NE(refused_by(musl).find("it has 'scheme: usl', this has 'scheme: musl'"),
              std::string::npos);
    EXPECT_NE(refused_by(integers).find("this has 'sums: fixed point'"), std::string::npos);
    EXPECT_NE(refused_by(heavier).find("\"block\""), std::string::npos);
}

TEST_F(RefusedCheckpoint, IsOfAnotherFormatOrVersion) {
    EXPECT_NE(refusal(with_header(file, 12, 99), *target).find("its format is 99"),
              std::string::npos);
    EXPECT_NE(refusal(with_header(file, 16, 30201), *target).find("with grit 3.2.1, this is"),
              std::string::npos);
    EXPECT_TRUE(seen(*target, 3) == before);
}

TEST_F(RefusedCheckpoint, IsOfAnotherInstructionSetUnlessOtherBitsAreAccepted) {
    const std::string other = with_header(file, 20, GRIT_ISA_BEST);
    EXPECT_NE(refusal(other, *target).find("instruction set number 0"), std::string::npos);
    EXPECT_TRUE(seen(*target, 3) == before);
    std::istringstream in(other);
    restore(*target, in, OtherBits::accepted);
    EXPECT_TRUE(seen(*target, 3) == seen(*original, 3));
}

TEST_F(RefusedCheckpoint, IsNoneAtAll) {
    EXPECT_NE(refusal("", *target).find("none of grit's"), std::string::npos);
    EXPECT_NE(refusal(std::string(4096, 'x'), *target).find("none of grit's"), std::string::npos);
    EXPECT_TRUE(seen(*target, 3) == before);
}

TEST(CheckpointThatFindsNoRoom, SaysSo) {
    const auto simulation = PressedSand{}.build();
    std::ofstream full("/dev/full", std::ios::binary);
    try {
        save(*simulation, full);
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("not be written"), std::string::npos);
    }
}

}  // namespace
