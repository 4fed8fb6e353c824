// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm_grid_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace cli {
namespace {

using namespace grit::mpm;

constexpr double most_nodes = 2e7;  // of the grid

AxisSegment read_segment(TomlTable table, double from) {
    AxisSegment out{};
    out.to = table.number("to_m");
    if (!(out.to > from))
        table.fail("to_m",
                   fmt::format("{} must be above {:g} m, where the segment begins, got {:g}",
                               table.full("to_m"), from, out.to));
    out.growth = number_within(table, "growth", 1.0, limits::growth);
    if (table.one_of({"cell_m", "cells"}) == "cells") {
        out.cells = integer_within(table, "cells", 1, limits::cells);
    } else {
        const double cell = table.positive_or("cell_m", 1.0);
        if (!(cell <= out.to - from))
            table.fail("cell_m",
                       fmt::format("{} must be no longer than its segment, {:g} m, got {:g}",
                                   table.full("cell_m"), out.to - from, cell));
        out.cells = cells_for(out.to - from, cell, out.growth);
    }
    table.finish();
    return out;
}

AxisPlan read_axis(TomlTable& grid, const std::string& name) {
    AxisPlan out;
    out.from = grid.number_if(name + "_from_m").value_or(0.0);
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

}  // namespace

double number_within(TomlTable& table, const std::string& key, double otherwise,
                     limits::Range range) {
    const double value = table.number_if(key).value_or(otherwise);
    if (!(value >= range.low && value <= range.high))
        table.fail(key, fmt::format("{} must be in [{:g}, {:g}], got {:g}", table.full(key),
                                    range.low, range.high, value));
    return value;
}

int integer_within(TomlTable& table, const std::string& key, int otherwise, limits::Range range) {
    return table.integer_or(key, otherwise, static_cast<int>(range.low),
                            static_cast<int>(range.high));
}

void read_grid(TomlTable table, Case& plan) {
    plan.settings.axisymmetric =
        table.choice("geometry", {"axisymmetric", "plane_strain"}) == "axisymmetric";
    plan.r = read_axis(table, "r");
    plan.z = read_axis(table, "z");
    if (plan.settings.axisymmetric && plan.r.from < 0.0)
        table.fail("r_from_m", fmt::format("{}: an axisymmetric grid must not reach across the "
                                           "axis r = 0, got {:g}",
                                           table.full("r_from_m"), plan.r.from));
    if (const double nodes = nodes_of(plan.r) * nodes_of(plan.z); nodes > most_nodes)
        table.fail("", fmt::format("{}: a grid has at most {:g} nodes, got {:g}", table.full(""),
                                   most_nodes, nodes));
    table.finish();
}

void read_boundary(TomlTable table, Case& plan) {
    constexpr const char* sides[] = {"left", "right", "bottom", "top"};
    for (std::size_t i = 0; i < 4; ++i) {
        if (!table.has(sides[i])) continue;
        const std::string word = table.choice(sides[i], {"free", "roller", "fixed", "absorbing"});
        plan.boundary[i] = word == "fixed"       ? Boundary::fixed
                           : word == "roller"    ? Boundary::roller
                           : word == "absorbing" ? Boundary::absorbing
                                                 : Boundary::free;
    }
    if (plan.settings.axisymmetric && plan.r.from == 0.0 && table.has("left") &&
        plan.boundary[0] != Boundary::roller)
        table.fail("left", table.full("left") + " is the axis r = 0: roller");
    const bool absorbs =
        std::find(plan.boundary, plan.boundary + 4, Boundary::absorbing) != plan.boundary + 4;
    const auto speed = [&](const char* key) {
        const double value = table.positive_or(key, 0.0);
        if (absorbs && value == 0.0)
            table.fail("", fmt::format("{} is missing: a side is absorbing", table.full(key)));
        if (!absorbs && value != 0.0)
            table.fail(key, fmt::format("{} needs a side that is absorbing", table.full(key)));
        return value;
    };
    plan.absorbing = {speed("p_wave_m_per_s"), speed("s_wave_m_per_s")};
    if (absorbs && !(plan.absorbing.p > plan.absorbing.s))
        table.fail("p_wave_m_per_s",
                   fmt::format("{} must be above s_wave_m_per_s, {:g}, got {:g}",
                               table.full("p_wave_m_per_s"), plan.absorbing.s, plan.absorbing.p));
    table.finish();
}

void read_mpm_numerics(TomlTable table, Case& plan) {
    Settings& out = plan.settings;
    if (table.has("shape_function")) {
        const std::string word =
            table.choice("shape_function", {"cpdi", "cpdi_published", "ugimp", "linear"});
        out.shape = word == "cpdi"             ? Shape::cpdi
                    : word == "cpdi_published" ? Shape::cpdi_published
                    : word == "ugimp"          ? Shape::ugimp
                                               : Shape::point;
    }
    if (table.has("scheme")) {
        const std::string word = table.choice("scheme", {"usl", "musl", "usf"});
        out.scheme = word == "usl" ? Scheme::usl : word == "musl" ? Scheme::musl : Scheme::usf;
    }
    out.cfl = number_within(table, "cfl", out.cfl, limits::cfl);
    out.largest_step = table.positive_or("largest_step_s", out.largest_step);
    out.pic_rate = number_within(table, "pic_rate_per_s", out.pic_rate, limits::pic_rate);
    out.local_damping =
        number_within(table, "local_damping", out.local_damping, limits::local_damping);
    out.linear_viscosity =
        number_within(table, "bulk_viscosity_linear", out.linear_viscosity, limits::bulk_viscosity);
    out.quadratic_viscosity = number_within(table, "bulk_viscosity_quadratic",
                                            out.quadratic_viscosity, limits::bulk_viscosity);
    out.cell_mean = table.boolean_or("cell_averaged_volume", out.cell_mean);
    out.fixed_point = table.boolean_or("fixed_point", out.fixed_point);
    out.threads = integer_within(table, "threads", out.threads, limits::threads);
    plan.residual_limit = number_within(table, "energy_residual_limit", plan.residual_limit,
                                        limits::energy_residual_limit);
    table.finish();
}

}  // namespace cli
