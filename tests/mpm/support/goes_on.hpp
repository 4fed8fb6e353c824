// SPDX-License-Identifier: BSD-3-Clause
// Runs that go on from a checkpoint.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/io/checkpoint.hpp>

namespace mpm_test {

using namespace grit::mpm;

inline std::string saved(const Simulation& simulation) {
    std::ostringstream out;
    save(simulation, out);
    return out.str();
}

// With the bits of a run that never stopped.
inline void expect_goes_on(const Case& plan, int steps) {
    BuiltCase all = build_case(plan), first = build_case(plan), second = build_case(plan);
    for (int i = 0; i < 2 * steps; ++i) all.simulation->step();
    for (int i = 0; i < steps; ++i) first.simulation->step();
    std::istringstream in(saved(*first.simulation));
    restore(*second.simulation, in);
    for (int i = 0; i < steps; ++i) second.simulation->step();
    EXPECT_TRUE(saved(*second.simulation) == saved(*all.simulation));
}

inline void expect_refused(const Case& plan, const Case& other) {
    BuiltCase built = build_case(plan), second = build_case(other);
    std::istringstream in(saved(*built.simulation));
    EXPECT_THROW(restore(*second.simulation, in), std::runtime_error);
}

}  // namespace mpm_test
