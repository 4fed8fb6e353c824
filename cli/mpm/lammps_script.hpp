// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <adapters/mpm/case/case.hpp>

namespace cli {

// The numbers of the atoms that each traction acts on.
using TractionAtoms = std::vector<std::vector<int>>;

// The fix and its columns of output, for a script that has atoms, of a data file or of a restart file. stem:
// of the other files. Throws BadInput for what LAMMPS does not have.
std::string lammps_fix(const grit::mpm::Case& plan, const std::string& stem);
// The file that it asks for with the surface of the stiffer body of a contact.
std::string lammps_stl(const std::string& stem, const grit::mpm::ContactPlan& contact);
// The input script of a run from the start, which includes the other one.
std::string lammps_script(const grit::mpm::Case& plan, const std::string& stem,
                          const TractionAtoms& tractions);

}  // namespace cli
