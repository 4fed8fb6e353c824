// SPDX-License-Identifier: GPL-2.0-only
// A stored run as bytes of a restart file.
#pragma once

#include <string>

#include "adapters/lammps/local_run.hpp"

namespace grit::lammps {

// The first eight bytes say how many there are.
std::string to_bytes(const StoredRun& run);
// Throws std::runtime_error.
StoredRun from_bytes(const char* bytes);

}  // namespace grit::lammps
