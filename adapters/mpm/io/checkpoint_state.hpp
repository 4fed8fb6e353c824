// SPDX-License-Identifier: BSD-3-Clause
// What of a simulation a checkpoint holds.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "adapters/mpm/io/archive.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

// What must be the same, in words: of an axis, of a body, of a contact at nodes.
std::string word_of_axis(const Axis& axis);
std::string word_of_body(const std::string& name, bool rigid, const ParticleColumns& particles,
                         int mass_column);
std::string word_of_contact(const ContactLaw& law);
std::string word_of_surface(const grit_surface_options& options);

// Of a simulation that has visit and index_ids.
template <class Simulated> std::string state_bytes(const Simulated& simulation) {
    ByteWriter archive;
    Simulated::visit(simulation, archive);
    return std::move(archive.out);
}
// Throws std::runtime_error if these cannot be the bytes of such a simulation, which is untouched.
template <class Simulated> void take_state(Simulated& simulation, const std::string& bytes) {
    ByteChecker check(bytes.data(), bytes.size());
    Simulated::visit(static_cast<const Simulated&>(simulation), check);
    if (check.left() > 0)
        throw std::runtime_error("its state has " + std::to_string(bytes.size()) +
                                 " bytes, that of the simulation " +
                                 std::to_string(bytes.size() - check.left()));
    ByteReader archive(bytes.data(), bytes.size());
    Simulated::visit(simulation, archive);
    simulation.index_ids();
}

struct CheckpointState {
    // What it is built of: a line for each thing that must be the same.
    static std::string words(const Simulation& simulation);
    static std::string bytes(const Simulation& simulation);
    // Throws std::runtime_error if these cannot be the bytes of such a simulation, which is untouched.
    static void take(Simulation& simulation, const std::string& bytes);
};

}  // namespace grit::mpm
