// SPDX-License-Identifier: BSD-3-Clause
// A particle's update as a case of grit element.
#pragma once

#include <filesystem>
#include <string>

#include <adapters/mpm/kernel/material_failure.hpp>
#include <adapters/mpm/kernel/sand.hpp>
#include <adapters/mpm/space/kernel/sand.hpp>
#include <adapters/mpm/space/step/simulation.hpp>
#include <adapters/mpm/step/simulation.hpp>

namespace cli {

// Sand of the plane or of space.
struct ReplayedSand {
    ReplayedSand(const grit::mpm::Sand& sand);
    ReplayedSand(const grit::mpm::space::Sand& sand);
    const grit_sand& prepared;
    const grit_sand_options& options;
    const char* axes;  // what 11, 22 and 33 are
};

// The text of a case with this one increment: parameters and numerics of the sand, the state before it,
// turned by its rotation already. Stress in Pa becomes kPa; what a case cannot say (a separation, a start
// without pressure) is said in a comment. title: one line.
std::string replay_case(const grit::mpm::SandUpdate& update, const ReplayedSand& sand,
                        const std::string& title);

// Of a failure of that simulation; throws element::CannotWrite.
void write_replay_case(const std::filesystem::path& place,
                       const grit::mpm::MaterialFailure& failure,
                       grit::mpm::Simulation& simulation);
void write_replay_case(const std::filesystem::path& place,
                       const grit::mpm::MaterialFailure& failure,
                       grit::mpm::space::Simulation& simulation);

}  // namespace cli
