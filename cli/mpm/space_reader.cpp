// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/space_reader.hpp"

#include <cmath>
#include <utility>

#include <adapters/mpm/space/step/settings.hpp>
#include <fmt/format.h>

#include "cli/mpm/grid_reader.hpp"
#include "cli/mpm/words.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

constexpr const char* axis_names[] = {"x", "y", "z"};

std::vector<double> ascending(TomlTable& table, const std::string& key) {
    std::vector<double> out = table.numbers(key, 2);
    if (!(out[0] < out[1]))
        table.fail(
            key, fmt::format("{} must ascend, got [{:g}, {:g}]", table.full(key), out[0], out[1]));
    return out;
}

BoxShape read_box(TomlTable table) {
    BoxShape out;
    for (int d = 0; d < 3; ++d) {
        const std::vector<double> range = ascending(table, axis_names[d] + std::string("_m"));
        out.from[d] = range[0];
        out.to[d] = range[1];
    }
    table.finish();
    return out;
}

ConeShape read_upright(TomlTable& table) {
    const std::vector<double> centre = table.numbers("centre_m", 2), z = ascending(table, "z_m");
    return {{centre[0], centre[1]}, {z[0], z[1]}, {0.0, 0.0}};
}

ConeShape read_cylinder(TomlTable table) {
    ConeShape out = read_upright(table);
    out.radius[0] = out.radius[1] = number(table, case_word("body.cylinder", "radius_m"));
    table.finish();
    return out;
}

ConeShape read_cone(TomlTable table) {
    ConeShape out = read_upright(table);
    const std::vector<double> radii = table.numbers("radii_m", 2);
    if (!(radii[0] >= 0.0 && radii[1] >= 0.0 && radii[0] + radii[1] > 0.0))
        table.fail("radii_m", fmt::format("{} must not be negative, nor both 0, got [{:g}, {:g}]",
                                          table.full("radii_m"), radii[0], radii[1]));
    std::copy(radii.begin(), radii.end(), out.radius);
    table.finish();
    return out;
}

SphereShape read_sphere(TomlTable table) {
    const std::vector<double> centre = table.numbers("centre_m", 3);
    const SphereShape out{{centre[0], centre[1], centre[2]},
                          number(table, case_word("body.sphere", "radius_m"))};
    table.finish();
    return out;
}

}  // namespace

void refuse_in_space(const TomlTable& table, const std::string& key) {
    table.fail(key, fmt::format("{} is not there in space", table.full(key)));
}

void read_space_grid(TomlTable table, Case& plan) {
    SpacePlan& space = plan.space.emplace();
    const CaseWord* begins[] = {&case_word("grid", "x_from_m"), &case_word("grid", "y_from_m"),
                                &case_word("grid", "z_from_m")};
    double nodes = 1.0;
    for (int d = 0; d < 3; ++d) {
        space.axis[d] = read_axis(table, axis_names[d], *begins[d]);
        nodes *= nodes_of(space.axis[d]);
    }
    check_nodes(table, nodes);
    table.finish();
}

void read_space_boundary(TomlTable table, Case& plan) {
    for (const char* key : {"drained", "platen_level"})
        if (table.has(key)) refuse_in_space(table, key);
    for (const Spelling& side : words::sides_in_space) {
        CaseWord word = case_word("boundary", "left");
        word.key = side.word;
        const auto kind = choice_if(table, word);
        if (!kind) continue;
        const auto boundary = static_cast<Boundary>(*kind);
        if (boundary == Boundary::absorbing || boundary == Boundary::platen)
            table.fail(std::string(side.word), fmt::format("{}: {} is not there in space",
                                                           table.full(std::string(side.word)),
                                                           word_of(words::boundaries, boundary)));
        plan.space->boundary[side.value] = boundary;
    }
    table.finish();
}

void check_space_numerics(const TomlTable& table, const Case& plan) {
    const space::NotThere found = space::not_there(plan.settings);
    if (found.key)
        table.fail(found.key,
                   fmt::format("{}: {} is not there in space", table.full(found.key), found.what));
}

SolidPlan read_solid(TomlTable& body) {
    SolidPlan out;
    if (body.has("polygon")) refuse_in_space(body, "polygon");
    for (TomlTable& table : body.tables_if("box"))
        out.shapes.emplace_back(read_box(std::move(table)));
    for (TomlTable& table : body.tables_if("cylinder"))
        out.shapes.emplace_back(read_cylinder(std::move(table)));
    for (TomlTable& table : body.tables_if("cone"))
        out.shapes.emplace_back(read_cone(std::move(table)));
    for (TomlTable& table : body.tables_if("sphere"))
        out.shapes.emplace_back(read_sphere(std::move(table)));
    if (out.shapes.empty())
        body.fail("", fmt::format("{0} needs a [[body.box]], a [[body.cylinder]], a [[body.cone]] "
                                  "or a [[body.sphere]]",
                                  body.full("")));
    const CaseWord* per_cell[] = {&case_word("body", "particles_per_cell_x"),
                                  &case_word("body", "particles_per_cell_y"),
                                  &case_word("body", "particles_per_cell_z")};
    for (int d = 0; d < 3; ++d) out.particles[d] = integer_or_default(body, *per_cell[d]);
    if (const auto v = body.numbers_if("velocity_m_per_s", 3))
        out.velocity = {(*v)[0], (*v)[1], (*v)[2]};
    return out;
}

FacePlan read_face(TomlTable& traction) {
    FacePlan out;
    CaseWord word = case_word("traction", "edge");
    word.words = words::sides_in_space;
    const int side = choice(traction, word);
    out.across = side / 2;
    out.upper = side % 2 != 0;
    for (int d = 0; d < 3; ++d) {
        const std::string key = axis_names[d] + std::string("_m");
        if (!traction.has(key)) continue;
        const std::vector<double> range = ascending(traction, key);
        std::copy(range.begin(), range.end(), out.range[d]);
    }
    out.direction = {0.0, 0.0, 0.0};
    out.direction[out.across] = out.upper ? -1.0 : 1.0;
    if (const auto given = traction.numbers_if("direction", 3)) {
        const grit::Vector3 v{(*given)[0], (*given)[1], (*given)[2]};
        if (!(norm(v) > 0.0))
            traction.fail("direction", traction.full("direction") + " must not be 0");
        out.direction = v / norm(v);
    }
    return out;
}

}  // namespace cli
