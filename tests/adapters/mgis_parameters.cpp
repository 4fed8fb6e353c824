// SPDX-License-Identifier: BSD-3-Clause
// What may be set for all points at once, and calls from several threads.
#include <grit/sand.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <thread>

#include "support/mgis_point.hpp"

namespace {

using namespace mgis_host;

constexpr std::array<double, 6> strain = {-5e-3, 1e-3, 2e-3, 3e-3, 1e-3, -2e-3};

std::string said_by(const std::function<int()>& call) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(call(), 0);
    return testing::internal::GetCapturedStderr();
}

TEST(MgisParameter, HasTheDefaultOfTheLibrary) {
    const Behaviour b = load("Tridimensional");
    EXPECT_EQ(b.real_parameters,
              (std::vector<std::string>{"tolerance", "minimal_time_step_scaling_factor",
                                        "largest_water_tension"}));
    grit_sand_options options;
    ASSERT_EQ(grit_sand_options_init(&options, sizeof options), GRIT_OK);
    EXPECT_EQ(b.real_defaults, (std::vector<double>{options.tolerance, 0.1, 0.0}));
    EXPECT_EQ(b.integer_parameters, (std::vector<std::string>{"evaluation_limit", "water_itself"}));
    EXPECT_EQ(b.integer_defaults, (std::vector<int>{options.evaluation_limit, 0}));
}

// "| tolerance | `setParameter` | 2e-4 of the stress | 1e-12 … 0.1 |"
TEST(MgisParameter, IsAsItsDocumentationSays) {
    const Behaviour b = load("Tridimensional");
    std::map<std::string, double> known;
    for (std::size_t i = 0; i < b.real_parameters.size(); ++i)
        known[b.real_parameters[i]] = b.real_defaults[i];
    for (std::size_t i = 0; i < b.integer_parameters.size(); ++i)
        known[b.integer_parameters[i]] = b.integer_defaults[i];
    const auto is_taken = [&b](const std::string& name, double value) {
        testing::internal::CaptureStderr();
        const int taken = name == "evaluation_limit" || name == "water_itself"
                              ? b.set_integer(name.c_str(), static_cast<int>(value))
                              : b.set_real(name.c_str(), value);
        testing::internal::GetCapturedStderr();
        return taken == 1;
    };
    std::ifstream page(GRIT_MGIS_PAGE);
    for (std::string line; std::getline(page, line);) {
        std::istringstream words(line);
        std::string bar, name, function, value, lowest, dots, highest;
        words >> bar >> name >> bar >> function >> bar >> value;
        if (bar != "|" || !known.contains(name)) continue;
        EXPECT_EQ(std::stod(value), known[name]) << line;
        std::getline(words, bar, '|');
        words >> lowest >> dots >> highest;
        if (dots == "…") {
            const double low = std::stod(lowest), high = std::stod(highest);
            EXPECT_TRUE(is_taken(name, low) && is_taken(name, high)) << line;
            EXPECT_FALSE(is_taken(name, 0.99 * low - 0.01) || is_taken(name, 1.01 * high)) << line;
        }
        EXPECT_TRUE(is_taken(name, known[name])) << line;
        known.erase(name);
    }
    EXPECT_TRUE(known.empty()) << known.begin()->first;
}

TEST(MgisParameter, ToleranceSharpensTheStress) {
    Point coarse = Point::lausitz("Tridimensional");
    coarse.set_strain(strain);
    Point fine = coarse, exact = coarse;
    {
        const WithParameter set(coarse.behaviour, "tolerance", 1e-11);
        ASSERT_EQ(exact.run(no_operator), 1);
    }
    {
        const WithParameter set(coarse.behaviour, "tolerance", 1e-8);
        ASSERT_EQ(fine.run(no_operator), 1);
    }
    ASSERT_EQ(coarse.run(no_operator), 1);
    const double fine_error = std::abs(fine.stress1[0] - exact.stress1[0]);
    const double coarse_error = std::abs(coarse.stress1[0] - exact.stress1[0]);
    EXPECT_GT(coarse_error, 0.0);
    EXPECT_LT(fine_error, 0.1 * coarse_error);
}

TEST(MgisParameter, EvaluationLimitEndsACallThatWouldNeedMore) {
    Point p = Point::lausitz("Tridimensional");
    p.set_strain(strain);
    ASSERT_EQ(p.behaviour.set_integer("evaluation_limit", 5), 1);
    EXPECT_EQ(p.run(no_operator), -1);
    EXPECT_NE(p.said().find("5"), std::string::npos) << p.said();
    ASSERT_EQ(p.behaviour.set_integer("evaluation_limit", 20000), 1);
    EXPECT_EQ(p.run(no_operator), 1);
}

TEST(MgisParameter, MinimalScalingFactorIsTheLeastStepAskedFor) {
    Point p = Point::lausitz("Tridimensional");
    p.strain1[0] = std::numeric_limits<double>::quiet_NaN();
    const WithParameter set(p.behaviour, "minimal_time_step_scaling_factor", 0.4);
    EXPECT_EQ(p.run(no_operator), -1);
    EXPECT_EQ(p.rdt[0], 0.4);
}

TEST(MgisParameter, IsRefusedByNameAndLimitAndThenUnchanged) {
    const Behaviour b = load("Tridimensional");
    EXPECT_EQ(said_by([&] { return b.set_real("tolerance", 0.2); }),
              "GritSand: tolerance must be in [1e-12, 0.1], got 0.2\n");
    EXPECT_EQ(said_by([&] { return b.set_real("minimal_time_step_scaling_factor", 1.0); }),
              "GritSand: minimal_time_step_scaling_factor must be in (0, 1), got 1\n");
    EXPECT_EQ(said_by([&] { return b.set_integer("evaluation_limit", 1); }),
              "GritSand: evaluation_limit must be in [2, 1000000], got 1\n");
    EXPECT_EQ(said_by([&] { return b.set_real("epsilon", 1e-9); }),
              "GritSand: there is no real parameter \"epsilon\", only tolerance, "
              "minimal_time_step_scaling_factor and largest_water_tension\n");
    EXPECT_EQ(said_by([&] { return b.set_integer(nullptr, 7); }),
              "GritSand: there is no integer parameter \"(null)\", only evaluation_limit "
              "and water_itself\n");
    EXPECT_EQ(said_by([&] { return b.set_real("largest_water_tension", -1.0); }),
              "GritSand: largest_water_tension must be in [0, 1e+30], got -1\n");
    EXPECT_EQ(said_by([&] { return b.set_integer("water_itself", 2); }),
              "GritSand: water_itself must be 0 or 1, got 2\n");
    Point p = Point::lausitz("Tridimensional"), q = p;
    p.set_strain(strain);
    ASSERT_EQ(p.run(no_operator), 1);
    q.set_strain(strain);
    said_by([&] { return b.set_real("tolerance", std::numeric_limits<double>::quiet_NaN()); });
    ASSERT_EQ(q.run(no_operator), 1);
    EXPECT_EQ(p.stress1, q.stress1);
}

// Each on points of its own, one of them with failures, while a third sets a parameter.
TEST(MgisThreads, GiveEveryPointTheBitsItHasAlone) {
    const auto walk = [](Point& p, double scale) {
        for (int i = 0; i < 200; ++i) {
            const double s = i % 20 < 10 ? scale : -0.5 * scale;
            p.set_strain({-1e-4 * s, 2e-5 * s, 0.0, 5e-5 * s, 0.0, 0.0});
            if (p.run() == 1) p.accept();
            p.view.s1.gradients = nullptr;
            EXPECT_EQ(p.call(no_operator), -1);
        }
    };
    const Point start = Point::lausitz("PlaneStrain");
    Point a = start, b = start, alone_a = start, alone_b = start;
    walk(alone_a, 1.0);
    walk(alone_b, 2.0);
    std::thread first([&] { walk(a, 1.0); }), second([&] { walk(b, 2.0); });
    std::thread third([&] {
        const double same = start.behaviour.real_defaults[0];
        for (int i = 0; i < 1000; ++i) start.behaviour.set_real("tolerance", same);
    });
    first.join();
    second.join();
    third.join();
    EXPECT_EQ(a.stress0, alone_a.stress0);
    EXPECT_EQ(b.stress0, alone_b.stress0);
    EXPECT_EQ(a.state0, alone_a.state0);
    EXPECT_EQ(b.state0, alone_b.state0);
}

}  // namespace
