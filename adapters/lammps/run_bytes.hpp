// SPDX-License-Identifier: GPL-2.0-only
// A stored run as bytes of a restart file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "adapters/lammps/local_run.hpp"

namespace grit::lammps {

// run: null if it has not begun. fingerprint: of the words of its fix.
// The first bytes say how many there are: LAMMPS does not hand that over.
std::string to_bytes(const StoredRun* run, std::uint64_t fingerprint);
// Null: it had not begun. Throws std::runtime_error where bytes are damaged or the fingerprint is another one.
std::unique_ptr<StoredRun> from_bytes(const char* bytes, std::uint64_t fingerprint);

}  // namespace grit::lammps
