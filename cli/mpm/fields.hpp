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
    int components;  // 1, or 2: along r and z, or 3
    ShownOf of;

    std::string label() const { return std::string(name) + " [" + unit + "]"; }
};

const std::vector<MpmField>& mpm_fields(bool axisymmetric = true);
std::vector<std::string> names_of_fields(const std::vector<MpmField>& fields);
// Table of the documentation, Markdown.
std::string table_of_fields(const std::vector<MpmField>& fields);
std::string mpm_field_table();
// Throws std::invalid_argument with the nearest name.
const MpmField& field_of(const std::vector<MpmField>& fields, const std::string& name);
const MpmField& mpm_field(const std::string& name, bool axisymmetric = true);

// What a file of fields shows, in the plane or in space.
class ShownFields {
  public:
    virtual ~ShownFields() = default;
    virtual double time() const = 0;
    virtual std::size_t bodies() const = 0;
    virtual const std::string& name(std::size_t body) const = 0;
    virtual bool has(std::size_t body, const MpmField& field) const = 0;
    // n * components. Throws std::invalid_argument if the body has no such quantity.
    virtual std::vector<double> values(std::size_t body, const MpmField& field) const = 0;
    // Of domains as they are deformed [m]: r, z of four corners, counterclockwise, 8 n, or x, y, z of eight, the
    // lower four before the upper ones, 24 n.
    virtual std::vector<double> corners(std::size_t body) const = 0;
    virtual int corners_each() const = 0;
};

class MpmFields : public ShownFields {
  public:
    // Of a simulation as it was built, before its first step or restore: displacements count from here.
    explicit MpmFields(grit::mpm::Simulation& simulation);

    grit::mpm::Simulation& simulation() const { return shown; }
    double time() const override { return shown.time(); }
    std::size_t bodies() const override { return start.size(); }
    const std::string& name(std::size_t body) const override { return shown.body(body).name; }
    bool has(std::size_t body, const MpmField& field) const override;
    std::vector<double> values(std::size_t body, const MpmField& field) const override;
    std::vector<double> corners(std::size_t body) const override;
    int corners_each() const override { return 4; }

  private:
    grit::mpm::Simulation& shown;
    std::vector<std::vector<grit::Vector2>> start;  // positions by body and id [m]
};

}  // namespace cli
