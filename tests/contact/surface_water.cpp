// SPDX-License-Identifier: BSD-3-Clause
// Surface contact of a body through which water flows (V7): none of it passes, drag binds it to the grains within the
// step, and what it bears does not rub.
#include <algorithm>

#include "support/meeting_grids.hpp"

namespace {

using namespace tests;

struct WetBody : GridBody {
    std::vector<double> pores, seepage, seepage_old, pressure;
    std::vector<int> water_fixed;

    void soak(std::mt19937_64& random, double drag) {
        const auto dice = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        for (const double m : mass) {
            pores.insert(pores.end(), {m * dice(0.1, 0.4), m * drag, dice(0.3, 0.5)});
            for (int c = 0; c < components; ++c) seepage.push_back(dice(-0.3, 0.3));
        }
        seepage_old = seepage;
    }
    grit_surface surface() {
        grit_surface s = GridBody::surface();
        if (!pores.empty()) {
            s.pores = grit_view_of(pores.data(), 3, 1);
            s.seepage = grit_mutable_view_of(seepage.data(), components, 1);
            s.previous_seepage = grit_view_of(seepage_old.data(), components, 1);
        }
        if (!water_fixed.empty()) s.water_fixed = water_fixed.data();
        if (!pressure.empty()) s.pore_pressure = pressure.data();
        return s;
    }
    // sum(i, c, m, m_w, v, u)
    template <class Of> double sum(const Of& of) const {
        double out = 0.0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const std::size_t at = i / static_cast<std::size_t>(components);
            out += of(i, mass[at], pores.empty() ? 0.0 : pores[3 * at], v[i],
                      pores.empty() ? 0.0 : seepage[i]);
        }
        return out;
    }
    double momentum_along(int c) const {
        return sum([&](std::size_t i, double m, double m_w, double now, double u) {
            return static_cast<int>(i) % components == c ? m * now + m_w * (now + u) : 0.0;
        });
    }
    double energy() const {
        return sum([](std::size_t, double m, double m_w, double now, double u) {
            return 0.5 * (m * now * now + m_w * (now + u) * (now + u));
        });
    }
    // Taken by drag, from the start on.
    double dragged() const {
        double out = 0.0;
        for (std::size_t i = 0; i < seepage.size(); ++i)
            out += 0.5 * pores[3 * (i / static_cast<std::size_t>(components)) + 1] *
                   (seepage[i] * seepage[i] - seepage_old[i] * seepage_old[i]);
        return out;
    }
};

struct WetMeeting {
    WetBody a, b;
    WetMeeting(int components, std::uint64_t seed, double drag) {
        std::mt19937_64 random(seed);
        a.components = b.components = components;
        const double level = 3.2 + 0.01 * static_cast<double>(seed);
        const auto wave = [level](double x, double y) {
            return level + 0.1 * std::sin(0.9 * x + 0.7 * y);
        };
        add_face(a, false, 0.5, 6.4, components == 2 ? 11 : 4, wave);
        add_face(b, true, 0.2, 6.1, components == 2 ? 7 : 5, wave);
        a.fill(random, 1.0, 1.0);
        b.fill(random, 1.0, 1.0);
        const auto last = static_cast<std::size_t>(components) - 1;
        for (std::size_t i = last; i < a.v.size(); i += last + 1) a.v[i] += 2.0;
        a.v_old = a.v;
        b.soak(random, drag);
    }
};

double direction(const grit_surface_term& term, int k, int c) { return term.direction[k][c]; }

// Flow of the water of b out of it, around a row's point.
double flow(const grit_surface_totals& totals, std::ptrdiff_t row, const WetBody& b) {
    double q = 0.0;
    for (std::ptrdiff_t i = 0; i < totals.row[row].terms; ++i) {
        const grit_surface_term& term = totals.term[totals.row[row].first_term + i];
        if (!term.of_b) continue;
        for (int c = 0; c < b.components; ++c)
            q += b.pores[3 * static_cast<std::size_t>(term.node) + 2] * direction(term, 0, c) *
                 b.seepage[static_cast<std::size_t>(term.node * b.components + c)];
    }
    return q;
}

TEST(SurfaceOfWetBody, KeepsMomentumAndEnergyAndLetsNoWaterThrough) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < (components == 2 ? 60u : 12u); ++seed)
            for (const double drag : {0.0, 1e-2, 1.0, 1e3, 1e9}) {
                WetMeeting m(components, seed, drag);
                const double mu = seed % 2 == 0 ? 0.0 : 0.4;
                SurfaceCall call(components, mu);
                double momentum[3], start = m.a.energy() + m.b.energy();
                for (int c = 0; c < components; ++c)
                    momentum[c] = m.a.momentum_along(c) + m.b.momentum_along(c);
                ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
                ASSERT_GT(call.totals.pressures, 0);
                double scale = 0.0, most = 0.0;
                for (const double mass : m.b.mass) scale += mass;
                for (int c = 0; c < components; ++c)
                    EXPECT_NEAR(m.a.momentum_along(c) + m.b.momentum_along(c), momentum[c],
                                1e-12 * scale);
                const double lost = start - m.a.energy() - m.b.energy();
                // Drag's impulse follows the flow at the end, and cancels where it is strong.
                EXPECT_NEAR(call.totals.dissipation_normal + call.totals.dissipation_tangential,
                            lost - m.b.dragged(), 1e-10 * (start + std::fabs(m.b.dragged())));
                EXPECT_GE(call.totals.dissipation_normal + call.totals.dissipation_tangential, 0.0);
                for (const double u : m.b.seepage_old) most = std::max(most, std::fabs(u));
                for (std::ptrdiff_t r = 0; r < call.totals.rows; ++r)
                    EXPECT_LE(std::fabs(flow(call.totals, r, m.b)), 1e-8 * most);
            }
}

// Where drag is strong the body meets the other one with all its mass, and the smallest flow has a definite impulse.
TEST(SurfaceOfWetBody, IsAsHeavyAsItsWaterWhereDragIsStrong) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        WetMeeting wet(2, seed, 1e12);
        std::fill(wet.b.seepage.begin(), wet.b.seepage.end(), 0.0);
        WetMeeting heavy(2, seed, 0.0);
        for (std::size_t i = 0; i < heavy.b.mass.size(); ++i)
            heavy.b.mass[i] += heavy.b.pores[3 * i];
        heavy.b.pores.clear();
        SurfaceCall call(2, 0.3), other(2, 0.3);
        ASSERT_EQ(call(wet.a, wet.b), GRIT_OK);
        ASSERT_EQ(other(heavy.a, heavy.b), GRIT_OK);
        for (std::size_t i = 0; i < wet.b.v.size(); ++i)
            EXPECT_NEAR(wet.b.v[i], heavy.b.v[i], 1e-9);
        for (std::size_t i = 0; i < wet.a.v.size(); ++i)
            EXPECT_NEAR(wet.a.v[i], heavy.a.v[i], 1e-9);
    }
}

TEST(SurfaceOfWetBody, RubsWithWhatItsGrainsCarry) {
    double friction = 0.0, of_drier = 0.0;
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        WetMeeting m(2, seed, 1.0);
        SurfaceCall call(2, 0.35);
        m.b.pressure.assign(m.b.facet.size() / 2, 100.0);
        ASSERT_EQ(call(m.a, m.b), GRIT_OK);
        for (std::ptrdiff_t r = 0; r < call.totals.rows; ++r) {
            const grit_surface_row& row = call.totals.row[r];
            EXPECT_LE(std::fabs(row.impulse[1]), 0.35 * row.impulse[0]);
            friction += std::fabs(row.impulse[1]);
        }
        WetMeeting same(2, seed, 1.0);
        SurfaceCall drier(2, 0.35);
        ASSERT_EQ(drier(same.a, same.b), GRIT_OK);
        for (std::ptrdiff_t r = 0; r < drier.totals.rows; ++r)
            of_drier += std::fabs(drier.totals.row[r].impulse[1]);
        WetMeeting drowned(2, seed, 1.0);
        drowned.b.pressure.assign(drowned.b.facet.size() / 2, 1e9);
        SurfaceCall slippery(2, 0.35);
        ASSERT_EQ(slippery(drowned.a, drowned.b), GRIT_OK);
        for (std::ptrdiff_t r = 0; r < slippery.totals.rows; ++r)
            EXPECT_EQ(slippery.totals.row[r].impulse[1], 0.0);
    }
    EXPECT_LT(friction, 0.9 * of_drier);
}

// Suction presses the grains together where the surfaces meet, and does nothing where they part.
TEST(SurfaceOfWetBody, RubsBySuctionOnlyWhereItIsPressed) {
    double sucked = 0.0, dry = 0.0;
    int open = 0;
    for (std::uint64_t seed = 1; seed < 20; ++seed)
        for (const double pressure : {0.0, -100.0}) {
            WetMeeting m(2, seed, 1.0);
            m.b.pressure.assign(m.b.facet.size() / 2, pressure);
            SurfaceCall call(2, 0.35);
            ASSERT_EQ(call(m.a, m.b), GRIT_OK);
            for (std::ptrdiff_t r = 0; r < call.totals.rows; ++r) {
                const grit_surface_row& row = call.totals.row[r];
                (pressure < 0.0 ? sucked : dry) += std::fabs(row.impulse[1]);
                if (row.impulse[0] > 0.0) continue;
                ++open;
                EXPECT_EQ(row.impulse[1], 0.0) << seed;
            }
        }
    EXPECT_GT(open, 0);
    EXPECT_GT(sucked, 1.1 * dry);
}

// A host that gives the rows' impulses to the velocities it began with has those that the call left.
TEST(SurfaceOfWetBody, TellsWhatEachOfItsPointsDid) {
    WetMeeting m(2, 7, 0.0);
    m.b.pores.clear();
    WetMeeting start = m;
    SurfaceCall call(2, 0.3);
    ASSERT_EQ(call(m.a, m.b), GRIT_OK);
    ASSERT_GT(call.totals.rows, 0);
    for (std::ptrdiff_t r = 0; r < call.totals.rows; ++r) {
        const grit_surface_row& row = call.totals.row[r];
        double approach = row.rigid[0];
        for (std::ptrdiff_t i = row.first_term; i < row.first_term + row.terms; ++i) {
            const grit_surface_term& term = call.totals.term[i];
            WetBody& body = term.of_b ? start.b : start.a;
            const WetBody& end = term.of_b ? m.b : m.a;
            for (int c = 0; c < 2; ++c) {
                const auto at = static_cast<std::size_t>(2 * term.node + c);
                approach += direction(term, 0, c) * end.v[at];
                for (int k = 0; k < 2; ++k)
                    body.v[at] -= row.impulse[k] * direction(term, k, c) /
                                  body.mass[static_cast<std::size_t>(term.node)];
            }
        }
        EXPECT_LE(approach, row.bound + 1e-9);
        if (row.impulse[0] > 0.0) {
            EXPECT_NEAR(approach, row.bound, 1e-9);
        }
    }
    for (std::size_t i = 0; i < m.b.v.size(); ++i) EXPECT_NEAR(start.b.v[i], m.b.v[i], 1e-10);
    for (std::size_t i = 0; i < m.a.v.size(); ++i) EXPECT_NEAR(start.a.v[i], m.a.v[i], 1e-10);
}

// Grains that a side holds, beside water that may leave across it.
TEST(SurfaceOfWetBody, HoldsItsWaterApartFromItsGrains) {
    WetMeeting m(2, 5, 1.0);
    std::fill(m.b.fixed.begin(), m.b.fixed.end(), 2);
    m.b.water_fixed.assign(m.b.fixed.size(), 0);
    const WetMeeting before = m;
    SurfaceCall call(2);
    ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
    for (std::size_t i = 1; i < m.b.v.size(); i += 2) EXPECT_EQ(m.b.v[i], before.b.v[i]);
    EXPECT_NE(m.b.seepage, before.b.seepage);
    m = before;
    m.b.water_fixed.assign(m.b.fixed.size(), 3);
    std::fill(m.b.fixed.begin(), m.b.fixed.end(), 3);
    ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
    EXPECT_EQ(m.b.seepage, before.b.seepage);
}

TEST(SurfaceOfWetBody, LetsNoWaterThroughWhereAllGrainsAreHeld) {
    for (const int components : {2, 3}) {
        WetMeeting m(components, 5, 1.0);
        for (WetBody* body : {&m.a, &m.b})
            std::fill(body->fixed.begin(), body->fixed.end(), (1 << components) - 1);
        m.b.water_fixed.assign(m.b.fixed.size(), 0);
        SurfaceCall call(components);
        ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
        ASSERT_GT(call.totals.rows, 2);
        for (std::ptrdiff_t k = 0; k < call.totals.rows; ++k) {
            EXPECT_EQ(call.totals.row[k].impulse[0], 0.0);
            EXPECT_NEAR(flow(call.totals, k, m.b), 0.0, 1e-12);
        }
    }
}

TEST(SurfaceOfWetBody, MayBeWaterAlone) {
    WetMeeting m(2, 3, 1.0);
    for (std::size_t i = 2; i < m.b.pores.size(); i += 3) m.b.pores[i] = 1.0;  // porosity
    SurfaceCall call(2);
    EXPECT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
}

TEST(SurfaceOfWetBody, NamesWhatIsWrongWithItsWater) {
    const auto says = [](auto spoil, const char* text) {
        WetMeeting m(2, 3, 1.0);
        m.b.pressure.assign(m.b.facet.size() / 2, 0.0);
        spoil(m.b);
        const WetBody before = m.b;
        SurfaceCall call(2);
        EXPECT_NE(call(m.a, m.b), GRIT_OK);
        EXPECT_NE(std::string(call.error.message).find(text), std::string::npos)
            << call.error.message;
        EXPECT_EQ(m.b.v, before.v);
    };
    says([](WetBody& b) { std::fill(b.pores.begin(), b.pores.end(), -1.0); },
         "mass of water must be in [0, 1e30] (mass), got -1");
    says(
        [](WetBody& b) {
            for (std::size_t i = 1; i < b.pores.size(); i += 3) b.pores[i] = 1e31;
        },
        "drag must be in [0, 1e30] (mass), got 1e+31");
    says(
        [](WetBody& b) {
            for (std::size_t i = 2; i < b.pores.size(); i += 3) b.pores[i] = 1.5;
        },
        "porosity must be in [0, 1], got 1.5");
    says([](WetBody& b) { std::fill(b.seepage.begin(), b.seepage.end(), 1e31); },
         "seepage 0 must be within +-1e30 (length / time), got 1e+31");
    says([](WetBody& b) { b.water_fixed.assign(b.mass.size(), 8); }, "water_fixed");
    says([](WetBody& b) { b.pressure[0] = 1e31; },
         "pore_pressure must be within +-1e30 (stress), got 1e+31");
}

}  // namespace
