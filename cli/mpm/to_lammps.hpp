// SPDX-License-Identifier: BSD-3-Clause
// A case for the other host, LAMMPS with fix grit/mpm: docs/lammps.md.
#pragma once

#include <filesystem>

#include <adapters/mpm/case/case.hpp>

namespace cli {

// Writes FOLDER/<case>.in, .fix, .data, and _<body>.points for each body. Throws BadInput for what the other host
// does not have.
void write_lammps_files(const grit::mpm::Case& plan, const std::filesystem::path& folder);

}  // namespace cli
