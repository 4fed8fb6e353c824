// SPDX-License-Identifier: BSD-3-Clause
// What of a simulation a checkpoint holds.
#pragma once

#include <string>

#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

struct CheckpointState {
    // What it is built of: a line for each thing that must be the same.
    static std::string words(const Simulation& simulation);
    static std::string bytes(const Simulation& simulation);
    // Throws std::runtime_error if these cannot be the bytes of such a simulation, which is untouched.
    static void take(Simulation& simulation, const std::string& bytes);
};

}  // namespace grit::mpm
