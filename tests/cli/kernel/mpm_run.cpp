// SPDX-License-Identifier: BSD-3-Clause
// A run that something ends keeps its history so far.
#include "cli/mpm/run.hpp"

#include <gtest/gtest.h>

#include <new>

#include <adapters/mpm/kernel/material_failure.hpp>

#include "support/workplace.hpp"

namespace {

using namespace grit::mpm;

Case falling_block() {
    Case out;
    out.name = "block";
    out.r = {0.0, {{0.2, 4, 1.0}}};
    out.z = {0.0, {{1.2, 24, 1.0}}};
    BodyPlan block{};
    block.name = "block";
    block.outlines = {Outline{{{0.0, 0.5}, {0.1, 0.5}, {0.1, 0.8}, {0.0, 0.8}}}};
    block.density = 1000.0;
    block.material = ElasticPlan{1e6, 0.3};
    out.bodies = {block};
    out.stages = {StagePlan{.name = "fall", .end = {.time = 0.1}}};
    out.history.body = "block";
    return out;
}

template <class Error> std::string ended_by(const Workplace& here, const Error& error) {
    Runner runner(falling_block());
    runner.simulation().set_body_force(
        [error](ParticleView, std::ptrdiff_t, std::ptrdiff_t, double t) {
            if (t > 0.01) throw error;
        });
    const cli::MpmRunOptions options{.history = here.path("x.csv"),
                                     .checkpoint = here.path("x.checkpoint"),
                                     .fields = here.path("x"),
                                     .failure = here.path("x_failure.toml"),
                                     .shown = {},
                                     .quiet = true};
    return cli::MpmRun(options, runner).go();
}

void has_history(const Workplace& here, const std::string& end) {
    EXPECT_EQ(here.files(), std::set<std::string>{"x.csv"});
    const std::string text = here.text("x.csv");
    EXPECT_NE(text.find("\n1,5,"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("# STOPPED EARLY: " + end + "\n")) << text;
}

TEST(MaterialPointRun, KeepsItsHistoryWhateverEndsIt) {
    const Workplace here;
    std::string end = ended_by(here, std::bad_alloc());
    EXPECT_TRUE(end.starts_with("std::bad_alloc (after step ")) << end;
    has_history(here, end);
    end = ended_by(here, std::logic_error("a mistake"));
    EXPECT_TRUE(end.starts_with("a mistake (after step ")) << end;
    has_history(here, end);
}

TEST(MaterialPointRun, KeepsItsHistoryIfNoReplayCaseCanBeWritten) {
    const Workplace here;
    const std::string end = ended_by(here, MaterialFailure({}, 0, "no such state"));
    EXPECT_EQ(end,
              "sand: no such state; its replay case could not be written: the body that failed "
              "is not of sand");
    has_history(here, end);
}

}  // namespace
