// SPDX-License-Identifier: BSD-3-Clause
// What an update returns as done is a point that the next one accepts, at every limit of what is accepted.
#include "../samples.hpp"
#include "support/batch.hpp"
#include "support/random_sand.hpp"

namespace {

using namespace tests;

using Rotation = std::array<double, 9>;

// Some of everything between the limits, and much of the limits themselves.
struct AtLimits {
    const Sand& sand;
    Random& random;
    bool in_plane;

    bool one_in(int n) { return random.uniform() * n < 1.0; }
    // Beside a limit: on it, some roundoff or a little below.
    double beside(double limit) {
        const double off[] = {0.0, 2e-16, 1e-12, 1e-9, 1e-6, 1e-2};
        return limit * (1.0 - off[static_cast<int>(6.0 * random.uniform())]);
    }
    double stress_component(double most) {
        return one_in(2) ? beside(most) * (one_in(4) ? 1.0 : -1.0) : most * random.uniform(-1, 1);
    }
    Vec stress() {
        const double h_s = sand.p.granulate_hardness, floor = 1e-8 * h_s;
        if (one_in(3)) return random_state(sand, random, 20.0, 500.0).T;
        if (one_in(3)) return Vec(-beside(one_in(2) ? floor : 2.0 * floor) * identity());
        if (one_in(4)) return Vec::Zero();
        Vec T;
        const double pressure = beside(10.0 * h_s);
        for (int c = 0; c < 6; ++c)
            T[c] = c < 3 ? (one_in(2) ? -pressure : stress_component(10.0 * h_s))
                         : std::sqrt(2.0) * stress_component(one_in(2) ? 10.0 * h_s : h_s);
        return T;
    }
    Vec memory() {
        const double R = sand.p.elastic_strain_radius;
        const double length[] = {0.0, random.uniform(), 1.0, 1.0 + 1e-6, 1.005, beside(1.01)};
        return R * length[static_cast<int>(6.0 * random.uniform())] * random.direction();
    }
    double void_ratio() {
        if (one_in(8)) return beside(1e9);
        if (one_in(8)) return random.log_uniform(1e-16, 1e-2);
        return random.uniform(sand.p.densest_void_ratio, sand.p.loosest_void_ratio);
    }
    double separation() { return one_in(4) ? random.log_uniform(1e-12, 1e308) : 0.0; }
    Vec increment() {
        if (one_in(3)) return Vec::Zero();
        const Vec D = one_in(3) ? Vec((one_in(2) ? 1.0 : -1.0) / std::sqrt(3.0) * identity())
                                : random.direction();
        return (one_in(4) ? beside(0.2) : random.log_uniform(1e-12, 0.2)) * D;
    }
    // Orthogonal to what is accepted, tilted out of the plane by what is accepted.
    Rotation rotation() {
        const Full turn =
            in_plane ? Full(Eigen::AngleAxisd(random.uniform(-4, 4), Eigen::Vector3d::UnitZ())
                                .toRotationMatrix())
                     : random.rotation();
        const Full Q = one_in(4) ? Full(Full::Identity()) : turn;
        Rotation q;
        for (int i = 0; i < 9; ++i)
            q[static_cast<std::size_t>(i)] = Q(i / 3, i % 3) + 1e-9 * random.uniform(-1, 1);
        for (const std::size_t i : {2U, 5U, 6U, 7U})
            if (in_plane) q[i] = one_in(2) ? 0.0 : random.log_uniform(1e-300, 1e-12);
        return q;
    }
    Point point() {
        State x{stress(), memory(), void_ratio()};
        if (in_plane) x.T[4] = x.T[5] = x.h[4] = x.h[5] = 0.0;
        Point p = point_of(x);
        p.state[GRIT_SAND_SEPARATION] = separation();
        return p;
    }
};

struct Case {
    Batch batch;
    std::vector<Rotation> rotations;
    grit_sand_options options;
    int components;

    grit_status update(const Sand& sand) {
        grit_sand_points q = batch.views();
        q.components = components;
        if (!rotations.empty()) q.rotation_increment = grit_view_of(rotations[0].data(), 9, 1);
        return batch.update(sand, options, q);
    }
};

Case case_of(const Sand& sand, Random& random, std::size_t n) {
    Case c;
    c.components = random.uniform() < 0.5 ? 4 : 6;
    AtLimits limits{sand, random, c.components == 4};
    c.options =
        options_with(random.log_uniform(1e-6, 0.1), static_cast<int>(3.0 * random.uniform()));
    c.options.evaluation_limit = 2000;
    c.options.intergranular_off = limits.one_in(4);
    c.options.stress_is_rotated = limits.one_in(4);
    const bool turns = !limits.one_in(4);
    for (std::size_t i = 0; i < n; ++i) {
        c.batch.points.push_back(limits.point());
        Vec dE = limits.increment();
        if (limits.in_plane) dE[4] = dE[5] = 0.0;
        c.batch.strain.push_back(voigt_strain(dE));
        if (turns) c.rotations.push_back(limits.rotation());
    }
    c.batch.reports.resize(n);
    c.batch.tangents.resize(n);
    c.batch.substeps.assign(n, 0.0);
    return c;
}

double memory_length(const Point& x) { return state_of(x).h.norm(); }

TEST(RepeatedCalls, AreAcceptedWhereverTheCallBeforeWasDone) {
    Random random(2311);
    std::vector<Sand> sands = four_sands();
    for (const double shift : {1.0, 1e6}) {
        grit_sand_parameters p = sands[0].p;
        p.pressure_shift = shift;
        sands.push_back(prepared("lausitz with p_t", p));
    }
    int done = 0, refused = 0;
    for (int i = 0; i < 4000; ++i) {
        const Sand& sand = sands[static_cast<std::size_t>(i) % sands.size()];
        Case c = case_of(sand, random, i % 3 == 0 ? 1 : 11);
        const Case before = c;
        c.update(sand);
        Case next = c;
        next.rotations.clear();
        next.options.tangent = GRIT_TANGENT_NONE;
        for (auto& strain : next.batch.strain) strain.fill(0.0);
        next.update(sand);
        for (std::size_t k = 0; k < c.batch.size(); ++k) {
            if (c.batch.reports[k].status != GRIT_OK) {
                EXPECT_TRUE(same_bits(c.batch.points[k], before.batch.points[k]));
                ++refused;
                continue;
            }
            ++done;
            ASSERT_EQ(next.batch.reports[k].status, GRIT_OK)
                << sand.name << ", case " << i << ": " << next.batch.error.message;
        }
    }
    EXPECT_GT(done, 10000);
    EXPECT_GT(refused, 1000);
}

// Whatever a step of the integrator left of it.
TEST(RepeatedCalls, NeverLeaveAMemoryBeyondItsRadius) {
    Random random(2313);
    int done = 0;
    for (std::size_t i = 0; i < samples(2000); ++i) {
        const Sand sand = random_sand(random);
        Case c = case_of(sand, random, i % 3 == 0 ? 1 : 11);
        c.options.intergranular_off = 0;
        c.rotations.clear();  // whose matrices stretch by 1e-9
        const Case before = c;
        c.update(sand);
        const double R = sand.p.elastic_strain_radius;
        for (std::size_t k = 0; k < c.batch.size(); ++k) {
            if (c.batch.reports[k].status != GRIT_OK) continue;
            if (memory_length(before.batch.points[k]) > R) continue;
            EXPECT_LE(memory_length(c.batch.points[k]), R * (1.0 + 2e-12));
            ++done;
        }
    }
    EXPECT_GT(done, static_cast<int>(samples(500)));
}

// Where h comes back shorter than by its own evolution, the report says why.
TEST(RepeatedCalls, SayWhereAMemoryThatIsTooLongWasScaledBack) {
    Random random(2312);
    int scaled = 0;
    for (int i = 0; i < 4000; ++i) {
        const Sand& sand = four_sands()[static_cast<std::size_t>(i) % 4];
        Case c = case_of(sand, random, i % 3 == 0 ? 1 : 11);
        c.options.intergranular_off = 0;
        for (auto& strain : c.batch.strain)
            if (i % 2) strain.fill(0.0);
        const Case before = c;
        c.update(sand);
        for (std::size_t k = 0; k < c.batch.size(); ++k) {
            const grit_sand_report& report = c.batch.reports[k];
            if (report.status != GRIT_OK) continue;
            const double R = sand.p.elastic_strain_radius;
            const double start = memory_length(before.batch.points[k]);
            const double end = memory_length(c.batch.points[k]);
            const bool too_long = start > R * (1.0 + 1.5e-6) && end <= R * (1.0 + 1e-6);
            scaled += too_long;
            if (too_long) {
                EXPECT_TRUE(report.flags & GRIT_SAND_H_CLAMPED)
                    << "|h|/R from " << start / R << " to " << end / R;
            }
            if (start < R) {
                EXPECT_FALSE(report.flags & GRIT_SAND_H_CLAMPED);
            }
        }
    }
    EXPECT_GT(scaled, 1000);
}

}  // namespace
