// SPDX-License-Identifier: BSD-3-Clause
// parameters.inp and initialconditions.inp.
#include <gtest/gtest.h>

#include <element/incremental_driver/initial_conditions.hpp>
#include <element/incremental_driver/parameters.hpp>

#include "support/folder.hpp"

namespace {

incremental_driver::InitialConditions initial(const std::string& text) {
    const Folder folder;
    folder.write("i.inp", text);
    return incremental_driver::read_initial_conditions(folder.path("i.inp"));
}

TEST(IncrementalDriverParameters, AreOneValueALineAndRemarksAreIgnored) {
    const Folder folder;
    folder.write("p.inp",
                 "'Sand' some remark\r\n3 nprops\r\n 33. phi_c\r\n\r\n1.6D6, h_s\r\n+.19\r\n"
                 "lines behind are ignored\r\n");
    const auto parameters = incremental_driver::read_parameters(folder.path("p.inp"));
    EXPECT_EQ(parameters.name, "Sand");
    EXPECT_EQ(parameters.props, (std::vector<double>{33.0, 1.6e6, 0.19}));
    EXPECT_EQ(parameters.lines, (std::vector<int>{3, 5, 6}));
}

TEST(IncrementalDriverInitialConditions, MissingStateVariablesAreZero) {
    const auto conditions = initial("6 ntens\n-1\n-2\n-3\n4\n5\n6\n4 nstatv\n0.7 e\n8\n");
    EXPECT_EQ(conditions.stress, (element::Vector6() << -1, -2, -3, 4, 5, 6).finished());
    EXPECT_EQ(conditions.statev, (std::vector<double>{0.7, 8, 0, 0}));
    EXPECT_EQ(conditions.temperature, 0.0);
}

TEST(IncrementalDriverInitialConditions, TakeALineWithTheTemperature) {
    const auto conditions = initial("4\n-1\n-2\n-3\n4\n*temperature= 30.5\n1\n0.7\n");
    EXPECT_EQ(conditions.temperature, 30.5);
    EXPECT_EQ(conditions.stress[3], 4.0);
    EXPECT_EQ(conditions.stress[4], 0.0);
    EXPECT_EQ(conditions.statev, std::vector<double>{0.7});
}

}  // namespace
