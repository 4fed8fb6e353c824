// SPDX-License-Identifier: BSD-3-Clause
// A file with the state of a simulation and, in front of it, that of who runs it: bytes that nobody else
// reads.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <adapters/mpm/run/subject.hpp>

namespace cli {

// Written beside, on the disk before it takes the place of the one before; throws element::CannotWrite,
// which leaves that one as it is.
void write_mpm_checkpoint(const std::filesystem::path& place, const grit::mpm::Subject& simulation,
                          std::string_view runner);

class MpmCheckpoint {
  public:
    // Throws std::runtime_error with the file and what is wrong with it, as restore does.
    explicit MpmCheckpoint(const std::filesystem::path& place);

    const std::string& runner() const { return runner_state; }
    // The simulation is untouched if it is refused.
    void restore(grit::mpm::Subject& simulation,
                 grit::mpm::OtherBits bits = grit::mpm::OtherBits::refused) const;

  private:
    std::filesystem::path place;
    std::string runner_state, simulation_state;
};

}  // namespace cli
