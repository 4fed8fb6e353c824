// SPDX-License-Identifier: BSD-3-Clause
// What a case file says otherwise in space.
#pragma once

#include <memory>

#include <adapters/mpm/case/case.hpp>
#include <adapters/mpm/case/case_words.hpp>

#include "cli/toml/toml_table.hpp"

namespace cli {

void read_space_grid(TomlTable table, grit::mpm::Case& plan);
void read_space_boundary(TomlTable table, grit::mpm::Case& plan);
// Refuses what of [numerics] is not there.
void check_space_numerics(const TomlTable& table, const grit::mpm::Case& plan);

// Shapes, particles per cell and velocity of a body, which is not finished.
grit::mpm::SolidPlan read_solid(TomlTable& body, const grit::mpm::Case& plan);
// What a rigid body has in space besides; does anything of it move?
bool read_rigid_in_space(TomlTable& table, grit::mpm::RigidPlan& plan);
// Faces, range and direction of a traction, which is not finished.
grit::mpm::FacePlan read_face(TomlTable& traction);

// Refuses a key by name.
// A table with file, this unit and offset_m.
std::shared_ptr<const grit::mpm::ClosedSurface>
read_closed_surface(TomlTable& table, const grit::mpm::CaseWord& unit);

void refuse_in_space(const TomlTable& table, const std::string& key);

}  // namespace cli
