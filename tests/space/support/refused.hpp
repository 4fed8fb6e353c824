// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include <adapters/mpm/case/build_case.hpp>

namespace space_test {

// The case is not built, and the error says why.
inline void expect_refused(const grit::mpm::Case& plan, const char* why) {
    try {
        grit::mpm::build_case(plan);
        ADD_FAILURE() << why;
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
}

}  // namespace space_test
