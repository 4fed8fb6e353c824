// SPDX-License-Identifier: BSD-3-Clause
// What is shown of material points in space, by name; values in the order of ids.
#pragma once

#include <string>
#include <vector>

#include <adapters/mpm/space/step/simulation.hpp>

#include "cli/mpm/fields.hpp"

namespace cli {

const std::vector<MpmField>& space_fields();
// Table of the documentation, Markdown.
std::string space_field_table();

class SpaceFields : public ShownFields {
  public:
    // Of a simulation as it was built: displacements count from here.
    explicit SpaceFields(grit::mpm::space::Simulation& simulation);
    double time() const override { return shown.time(); }
    std::size_t bodies() const override { return start.size(); }
    const std::string& name(std::size_t body) const override { return shown.body(body).name; }
    bool has(std::size_t body, const MpmField& field) const override;
    std::vector<double> values(std::size_t body, const MpmField& field) const override;
    std::vector<double> corners(std::size_t body) const override;
    int corners_each() const override { return 8; }

  private:
    grit::mpm::space::Simulation& shown;
    std::vector<std::vector<grit::Vector3>> start;  // positions by body and id [m]
};

}  // namespace cli
