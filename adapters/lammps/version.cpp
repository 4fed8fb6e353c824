// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/version.hpp"

namespace grit::lammps {

std::string refusal(int version) {
    if (version == host_version) return {};
    return "Grit was built for LAMMPS " + std::to_string(host_version) +
           " (29 Sep 2021), this is " + std::to_string(version) + ": nothing was added to it";
}

}  // namespace grit::lammps
