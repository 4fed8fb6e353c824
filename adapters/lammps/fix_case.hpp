// SPDX-License-Identifier: GPL-2.0-only
// What the words of a fix command describe: a case of the driver, and what LAMMPS has for it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "adapters/mpm/case/case.hpp"

namespace grit::lammps {

// Equal-style variables, by name, in the place of functions of time; empty: none. Velocities along x, which is r, y
// and z, and about these.
struct MotionVariables {
    std::string along[3], about[3];
};

// The atoms of a body.
struct Members {
    int type = 0;       // 0: a group instead
    std::string group;  // its name
};

struct FixCase {
    mpm::Case plan;                       // bodies without outlines
    std::vector<Members> members;         // of each body
    std::vector<std::string> points;      // files, of each body; empty: none
    std::vector<std::string> surfaces;    // STL files, of each contact; empty: none
    std::vector<MotionVariables> motion;  // of each body
    int dimensions() const { return plan.space ? 3 : 2; }
    std::vector<std::string> traction_groups;     // of each traction
    std::vector<std::string> traction_variables;  // ... or empty
    std::uint64_t fingerprint = 0;                // of all words but names of files and threads
};

// What the box of LAMMPS is to the grid: where it begins and ends along r and z, or x, y and z.
using Box = std::array<std::array<double, 2>, 3>;
// The words after the style's name. Throws std::invalid_argument.
FixCase read_fix(const std::vector<std::string>& words, const Box& box);
// The surfaces that contacts name, from the bytes of their files: these belong to the fingerprint. Throws
// std::invalid_argument.
void read_surfaces(FixCase& plan, const std::function<std::string(const std::string&)>& bytes_of);
// Of a first word that is one of them; others are refused by read_fix.
bool is_in_space(const std::string& geometry);

// A stage of a case as fix_modify describes it; what it does not name is as before.
mpm::StagePlan read_stage(const std::vector<std::string>& words, const mpm::StagePlan& before,
                          const mpm::Case& plan);

}  // namespace grit::lammps
