// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/grid_reader.hpp"

#include <fmt/format.h>

#include "cli/mpm/space_reader.hpp"
#include "cli/mpm/words.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

constexpr double most_nodes = 2e7;  // of the grid

AxisSegment read_segment(TomlTable table, double from) {
    AxisSegment out{};
    out.to = number(table, case_word("grid.r", "to_m"));
    if (!(out.to > from))
        table.fail("to_m",
                   fmt::format("{} must be above {:g} m, where the segment begins, got {:g}",
                               table.full("to_m"), from, out.to));
    out.growth = number_or_default(table, case_word("grid.r", "growth"));
    if (table.one_of({"cell_m", "cells"}) == "cells") {
        out.cells = integer(table, case_word("grid.r", "cells"));
    } else {
        const double cell = number(table, case_word("grid.r", "cell_m"));
        if (!(cell <= out.to - from))
            table.fail("cell_m",
                       fmt::format("{} must be no longer than its segment, {:g} m, got {:g}",
                                   table.full("cell_m"), out.to - from, cell));
        out.cells = cells_for(out.to - from, cell, out.growth);
    }
    table.finish();
    return out;
}

}  // namespace

AxisPlan read_axis(TomlTable& grid, const std::string& name, const CaseWord& begin) {
    AxisPlan out;
    out.from = number_or_default(grid, begin);
    double from = out.from;
    for (TomlTable& segment : grid.tables_if(name)) {
        out.segments.push_back(read_segment(std::move(segment), from));
        from = out.segments.back().to;
    }
    if (out.segments.empty())
        grid.fail(name, fmt::format("{0} is missing: an axis needs a [[{0}]]", grid.full(name)));
    return out;
}

double nodes_of(const AxisPlan& plan) {
    double sum = 1.0;
    for (const AxisSegment& segment : plan.segments) sum += segment.cells;
    return sum;
}

void check_nodes(const TomlTable& grid, double nodes) {
    if (nodes > most_nodes)
        grid.fail("", fmt::format("{}: a grid has at most {:g} nodes, got {:g}", grid.full(""),
                                  most_nodes, nodes));
}

void name_axes(TomlTable& root) {
    static const TomlTable::OtherNames names = {{"r", "x"},
                                                {"r_m", "x_m"},
                                                {"r_from_m", "x_from_m"},
                                                {"particles_per_cell_r", "particles_per_cell_x"}};
    if (!root.has("grid")) return;
    TomlTable grid = root.table("grid");
    if (!grid.has("geometry")) return;
    if (choice(grid, case_word("grid", "geometry")) ==
        static_cast<int>(words::Geometry::plane_strain))
        root.take_names_from(names);
}

void read_grid(TomlTable table, Case& plan) {
    const auto geometry =
        static_cast<words::Geometry>(choice(table, case_word("grid", "geometry")));
    plan.settings.axisymmetric = geometry == words::Geometry::axisymmetric;
    if (geometry == words::Geometry::space) return read_space_grid(std::move(table), plan);
    plan.r = read_axis(table, "r", case_word("grid", "r_from_m"));
    plan.z = read_axis(table, "z", case_word("grid", "z_from_m"));
    if (plan.settings.axisymmetric && plan.r.from < 0.0)
        table.fail("r_from_m", fmt::format("{}: an axisymmetric grid must not reach across the "
                                           "axis r = 0, got {:g}",
                                           table.full("r_from_m"), plan.r.from));
    check_nodes(table, nodes_of(plan.r) * nodes_of(plan.z));
    table.finish();
}

void read_boundary(TomlTable table, Case& plan) {
    if (plan.space) return read_space_boundary(std::move(table), plan);
    for (const std::string& name : table.strings_or_none("drained")) {
        const Spelling* found = nullptr;
        for (const Spelling& side : words::sides)
            if (side.word == name) found = &side;
        if (!found)
            table.fail("drained", fmt::format("{} must be left, right, bottom or top, got \"{}\"",
                                              table.full("drained"), name));
        plan.drained[found->value] = true;
    }
    for (const Spelling& side : words::sides) {
        CaseWord word = case_word("boundary", "left");
        word.key = side.word;
        const auto kind = choice_if(table, word);
        if (!kind) continue;
        plan.boundary[side.value] = static_cast<Boundary>(*kind);
    }
    for (const Spelling& side : words::sides)
        if (table.has(std::string(side.word)))
            refuse(table, objection_to(plan, static_cast<Side>(side.value)));
    if (auto levels = table.table_if("platen_level")) {
        for (const Spelling& side : words::sides) {
            const std::string key = std::string(side.word) + "_m";
            const auto level = levels->number_if(key);
            if (!level) continue;
            if (plan.boundary[side.value] != Boundary::platen)
                levels->fail(key, levels->full(key) + ": that side is no platen");
            const AxisPlan& axis = side.value == static_cast<int>(Side::left) ||
                                           side.value == static_cast<int>(Side::right)
                                       ? plan.r
                                       : plan.z;
            if (!(*level >= axis.from && *level <= axis.to()))
                levels->fail(key, fmt::format("{} must be in the grid, [{:g}, {:g}] m, got {:g}",
                                              levels->full(key), axis.from, axis.to(), *level));
            plan.platen_level[side.value] = *level;
        }
        levels->finish();
    }
    const bool absorbs = plan.has_side(Boundary::absorbing);
    const auto speed = [&](const CaseWord& word) {
        const std::string key(word.key);
        const double value = number_if(table, word).value_or(0.0);
        if (absorbs && value == 0.0)
            table.fail("", fmt::format("{} is missing: a side is absorbing", table.full(key)));
        if (!absorbs && value != 0.0)
            table.fail(key, fmt::format("{} needs a side that is absorbing", table.full(key)));
        return value;
    };
    plan.absorbing = {speed(case_word("boundary", "p_wave_m_per_s")),
                      speed(case_word("boundary", "s_wave_m_per_s"))};
    if (absorbs && !(plan.absorbing.p > plan.absorbing.s))
        table.fail("p_wave_m_per_s",
                   fmt::format("{} must be above s_wave_m_per_s, {:g}, got {:g}",
                               table.full("p_wave_m_per_s"), plan.absorbing.s, plan.absorbing.p));
    table.finish();
}

void read_mpm_numerics(TomlTable table, Case& plan) {
    read_members(table, "numerics", numerics_members(), plan);
    if (plan.space) check_space_numerics(table, plan);
    table.finish();
}

}  // namespace cli
