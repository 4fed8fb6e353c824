// SPDX-License-Identifier: GPL-2.0-only
// The fix's part of a restart file: back as it was, or refused.
#include <gtest/gtest.h>

#include <stdexcept>

#include <adapters/lammps/run_bytes.hpp>

namespace {

using namespace grit::lammps;

StoredRun some_run() {
    StoredRun out;
    out.energy_scale = 3.0;
    out.common = "what all share";
    out.nodes = {3, {}};
    out.stages.resize(2);
    out.state.stage_time = {0.0, 0.5};
    return out;
}

TEST(RestartFiles, HandBackWhatWasStored) {
    const StoredRun run = some_run();
    const auto again = from_bytes(to_bytes(&run, 7).data(), 7);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->common, run.common);
    EXPECT_EQ(again->nodes.words_each, run.nodes.words_each);
    EXPECT_EQ(again->state.stage_time, run.state.stage_time);
    EXPECT_FALSE(from_bytes(to_bytes(nullptr, 7).data(), 7));
    EXPECT_THROW(from_bytes(to_bytes(&run, 8).data(), 7), std::runtime_error);
}

// Of a length that is wrong too, which nothing else tells.
TEST(RestartFiles, WithAChangedByteAreRefused) {
    const StoredRun run = some_run();
    const std::string good = to_bytes(&run, 7);
    for (std::size_t i = 0; i < good.size(); ++i)
        for (const int bit : {0, 3, 7}) {
            std::string bad = good;
            bad[i] = static_cast<char>(bad[i] ^ 1 << bit);
            EXPECT_THROW(from_bytes(bad.data(), 7), std::runtime_error) << i;
        }
}

}  // namespace
