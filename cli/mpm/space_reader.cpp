// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/space_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <adapters/mpm/space/step/settings.hpp>
#include <fmt/format.h>

#include "cli/mpm/body_reader.hpp"
#include "cli/mpm/grid_reader.hpp"
#include "cli/mpm/words.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr const CaseWord* per_cell_words[] = {&case_word("body", "particles_per_cell_x"),
                                              &case_word("body", "particles_per_cell_y"),
                                              &case_word("body", "particles_per_cell_z")};

// Of a body or of one of its shapes.
int per_cell(TomlTable& table, int d) { return integer_or_default(table, *per_cell_words[d]); }

std::vector<double> ascending(TomlTable& table, const std::string& key) {
    std::vector<double> out = table.numbers(key, 2);
    if (!(out[0] < out[1]))
        table.fail(
            key, fmt::format("{} must ascend, got [{:g}, {:g}]", table.full(key), out[0], out[1]));
    return out;
}

BoxShape read_box(TomlTable& table) {
    BoxShape out;
    for (int d = 0; d < 3; ++d) {
        const std::vector<double> range = ascending(table, axis_names[d] + std::string("_m"));
        out.from[d] = range[0];
        out.to[d] = range[1];
    }
    return out;
}

ConeShape read_upright(TomlTable& table) {
    const std::vector<double> centre = table.numbers("centre_m", 2), z = ascending(table, "z_m");
    return {{centre[0], centre[1]}, {z[0], z[1]}, {0.0, 0.0}};
}

ConeShape read_cylinder(TomlTable& table) {
    ConeShape out = read_upright(table);
    out.radius[0] = out.radius[1] = number(table, case_word("body.cylinder", "radius_m"));
    return out;
}

ConeShape read_cone(TomlTable& table) {
    ConeShape out = read_upright(table);
    const std::vector<double> radii = table.numbers("radii_m", 2);
    if (!(radii[0] >= 0.0 && radii[1] >= 0.0 && radii[0] + radii[1] > 0.0))
        table.fail("radii_m", fmt::format("{} must not be negative, nor both 0, got [{:g}, {:g}]",
                                          table.full("radii_m"), radii[0], radii[1]));
    std::copy(radii.begin(), radii.end(), out.radius);
    return out;
}

SphereShape read_sphere(TomlTable& table) {
    const std::vector<double> centre = table.numbers("centre_m", 3);
    return {{centre[0], centre[1], centre[2]}, number(table, case_word("body.sphere", "radius_m"))};
}

SurfaceShape read_surface(TomlTable& table) {
    return {read_closed_surface(table, case_word("body.surface", "unit_m"))};
}

}  // namespace

std::shared_ptr<const ClosedSurface> read_closed_surface(TomlTable& table,
                                                         const CaseWord& unit_word) {
    const std::filesystem::path file = table.folder_of("file") / table.string("file");
    const double unit = number_or_default(table, unit_word);
    const auto at = table.numbers_if("offset_m", 3).value_or(std::vector<double>(3, 0.0));
    try {
        return std::make_shared<ClosedSurface>(read_stl(file, unit, {at[0], at[1], at[2]}));
    } catch (const std::invalid_argument& error) {
        table.fail("file", error.what());
    }
}

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

SolidPlan read_solid(TomlTable& body, const Case& plan) {
    SolidPlan out;
    if (body.has("polygon")) refuse_in_space(body, "polygon");
    const SolidShape like = {BoxShape{}, {per_cell(body, 0), per_cell(body, 1), per_cell(body, 2)}};
    const auto read = [&](const char* key, const auto& read_shape) {
        for (TomlTable& table : body.tables_if(key)) {
            SolidShape shape = like;
            for (int d = 0; d < 3; ++d)
                if (table.has(std::string(per_cell_words[d]->key)))
                    shape.particles[d] = per_cell(table, d);
            shape.of = read_shape(table);
            table.finish();
            out.shapes.push_back(shape);
        }
    };
    read("box", read_box);
    read("cylinder", read_cylinder);
    read("cone", read_cone);
    read("sphere", read_sphere);
    read("surface", read_surface);
    if (out.shapes.empty())
        body.fail("", fmt::format("{0} needs a [[body.box]], a [[body.cylinder]], a [[body.cone]], "
                                  "a [[body.sphere]] or a [[body.surface]]",
                                  body.full("")));
    for (const std::string& name : body.strings_or_none("outside_of")) {
        const auto is_it = [&name](const BodyPlan& of) { return of.name == name; };
        const auto found = std::find_if(plan.bodies.begin(), plan.bodies.end(), is_it);
        if (found == plan.bodies.end())
            body.fail("outside_of", fmt::format("{}: no body before this one is called \"{}\"",
                                                body.full("outside_of"), name));
        out.outside_of.push_back(static_cast<std::size_t>(found - plan.bodies.begin()));
    }
    if (const auto v = body.numbers_if("velocity_m_per_s", 3))
        out.velocity = {(*v)[0], (*v)[1], (*v)[2]};
    return out;
}

bool read_rigid_in_space(TomlTable& table, RigidPlan& plan) {
    bool moves = false;
    const auto read = [&](const std::string& key, TimeTable& into) {
        if (!table.has(key)) return;
        into = read_time_table(table, key, 1.0);
        moves = true;
    };
    read("velocity_y_m_per_s", plan.velocity_y);
    for (std::size_t d = 0; d < 3; ++d)
        read(fmt::format("angular_velocity_{}_rad_per_s", axis_names[d]), plan.spin[d]);
    for (const std::string& name : table.strings_or_none("free")) {
        const auto is_it = [&name](const Spelling& of) { return of.word == name; };
        const auto* found = std::find_if(std::begin(words::degrees_of_freedom),
                                         std::end(words::degrees_of_freedom), is_it);
        if (found == std::end(words::degrees_of_freedom))
            table.fail("free", fmt::format("{} must be of x, y, z, about_x, about_y and about_z, "
                                           "got \"{}\"",
                                           table.full("free"), name));
        plan.free[static_cast<std::size_t>(found->value)] = true;
    }
    if (const auto x = table.numbers_if("centre_m", 3)) {
        if (plan.any_free())
            table.fail("centre_m", fmt::format("{}: what is free moves about the centre of mass",
                                               table.full("centre_m")));
        plan.centre = {(*x)[0], (*x)[1], (*x)[2]};
    }
    return moves;
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
