// SPDX-License-Identifier: BSD-3-Clause
// What a step leaves for the next one besides particles, for hosts that store it or cut the grid anew: what all
// processes have, and what a node has. Lines of penalty contacts and forces of absorbing sides are not in it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

struct GridState {
    // The same on all processes.
    static std::string common(const Simulation& simulation);
    // Numbers of all nodes of this process, a node's one after the other.
    static std::size_t words_per_node(const Simulation& simulation);
    static std::vector<std::uint64_t> nodes(const Simulation& simulation);

    // Of a simulation of the same case. Throws std::runtime_error where it cannot be.
    static void take_common(Simulation& simulation, const std::string& bytes);
    static void take_nodes(Simulation& simulation, const std::vector<std::uint64_t>& words);
};

}  // namespace grit::mpm
