// SPDX-License-Identifier: BSD-3-Clause
// Work that threads share, and what one of them throws.
#include <gtest/gtest.h>

#include <unistd.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "../few_threads.hpp"
#include "element/calibration/problem.hpp"

namespace {

using namespace calibration;

TEST(Parallel, ThrowsWhatTheLowestThrew) {
    for (std::size_t first = 0; first < 30; ++first) {
        std::string told;
        std::vector<int> done(30, 0);
        try {
            in_parallel(4, done.size(), [&](std::size_t i) {
                if (i >= first) throw std::runtime_error(std::to_string(i));
                done[i] = 1;
            });
        } catch (const std::runtime_error& error) {
            told = error.what();
        }
        ASSERT_EQ(told, std::to_string(first));
        for (std::size_t i = 0; i < first; ++i) ASSERT_EQ(done[i], 1) << i;
    }
}

TEST(Parallel, DoesWithTheThreadsThatTheSystemGives) {
    std::vector<int> done(1000, 0);
    const RoomForFewThreads room;
    in_parallel(1000, done.size(), [&](std::size_t i) {
        if (i < 64) usleep(1000);  // the first threads stay, so that there is no room for others
        done[i] += 1;
    });
    EXPECT_EQ(done, std::vector<int>(1000, 1));
}

}  // namespace
