// SPDX-License-Identifier: BSD-3-Clause
// What is shown of material points, by name; values in the order of ids.
#pragma once

#include <string>
#include <vector>

#include <adapters/mpm/step/simulation.hpp>

namespace cli {

// Bodies that have a variable: rigid ones have no stress.
enum class ShownOf { every_body, stressed, sand, water };

struct MpmField {
    const char* name;
    const char* unit;
    const char* meaning;
    int components;  // 1, or 2: along r and z
    ShownOf of;

    std::string label() const { return std::string(name) + " [" + unit + "]"; }
};

const std::vector<MpmField>& mpm_fields();
std::vector<std::string> mpm_field_names();
// Table of the documentation, Markdown.
std::string mpm_field_table();
// Throws std::invalid_argument with the nearest name.
const MpmField& mpm_field(const std::string& name);

class MpmFields {
  public:
    // Of a simulation as it was built, before its first step or restore: displacements count from here.
    explicit MpmFields(grit::mpm::Simulation& simulation);

    grit::mpm::Simulation& simulation() const { return shown; }
    std::size_t bodies() const { return start.size(); }
    bool has(std::size_t body, const MpmField& field) const;
    // n * components. Throws std::invalid_argument if the body has no such quantity.
    std::vector<double> values(std::size_t body, const MpmField& field) const;
    // r, z of four corners, counterclockwise, as the particles are deformed [m]: 8 n.
    std::vector<double> corners(std::size_t body) const;

  private:
    grit::mpm::Simulation& shown;
    std::vector<std::vector<grit::Vector2>> start;  // positions by body and id [m]
};

}  // namespace cli
