// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/body_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/element/material_reader.hpp"
#include "cli/mpm/space_reader.hpp"
#include "cli/mpm/words.hpp"
#include "cli/sand/sand_file.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

void check_place(const TomlTable& table, const std::string& key, const std::vector<double>& places,
                 const AxisPlan& axis, bool is_radius) {
    for (const double x : places) {
        if (is_radius && x < 0.0)
            table.fail(key,
                       fmt::format("{} reaches across the axis r = 0: {:g} m", table.full(key), x));
        if (!(x >= axis.from && x <= axis.to()))
            table.fail(key, fmt::format("{} reaches out of the grid, [{:g}, {:g}] m: {:g} m",
                                        table.full(key), axis.from, axis.to(), x));
    }
}

Outline read_outline(TomlTable table, bool box, const Case& plan) {
    const std::vector<double> r = table.numbers("r_m", box ? 2 : 0);
    const std::vector<double> z = table.numbers("z_m", box ? 2 : r.size());
    check_place(table, "r_m", r, plan.r, plan.settings.axisymmetric);
    check_place(table, "z_m", z, plan.z, false);
    Outline out;
    if (box) {
        for (const char* key : {"r_m", "z_m"}) {
            const std::vector<double>& x = key[0] == 'r' ? r : z;
            if (!(x[0] < x[1]))
                table.fail(key, fmt::format("{} must ascend, got [{:g}, {:g}]", table.full(key),
                                            x[0], x[1]));
        }
        out.corners = {{r[0], z[0]}, {r[1], z[0]}, {r[1], z[1]}, {r[0], z[1]}};
    } else {
        if (r.size() < 3)
            table.fail("r_m", fmt::format("{}: a polygon has three corners at least, got {}",
                                          table.full("r_m"), r.size()));
        for (std::size_t i = 0; i < r.size(); ++i) out.corners.push_back({r[i], z[i]});
    }
    if (table.has("particles_per_cell_r"))
        out.particles_r = integer(table, case_word("body.box", "particles_per_cell_r"));
    if (table.has("particles_per_cell_z"))
        out.particles_z = integer(table, case_word("body.box", "particles_per_cell_z"));
    table.finish();
    return out;
}

ElasticPlan read_elastic(TomlTable table, bool neo_hooke) {
    ElasticPlan out{};
    out.neo_hooke = neo_hooke;
    out.youngs_modulus = number(table, case_word("body.elastic", "youngs_modulus_kPa"));
    out.poissons_ratio = number(table, case_word("body.elastic", "poissons_ratio"));
    table.finish();
    return out;
}

RigidPlan read_rigid(TomlTable table, bool in_space) {
    const TimeTable still{{0.0}, {0.0}};
    RigidPlan out;
    const auto velocity = [&](const char* key) {
        return table.has(key) ? read_time_table(table, key, 1.0) : still;
    };
    const char* along_r = in_space ? "velocity_x_m_per_s" : "velocity_r_m_per_s";
    out.velocity_r = velocity(along_r);
    out.velocity_z = velocity("velocity_z_m_per_s");
    bool moves = table.has(along_r) || table.has("velocity_z_m_per_s");
    if (in_space) moves = read_rigid_in_space(table, out) || moves;
    out.from_stage = table.string_if("from_stage").value_or("");
    for (const char* key : {"time_s", "from_stage"}) {
        const bool is_of_free = out.any_free() && key == std::string_view("from_stage");
        if (!moves && !is_of_free && table.has(key))
            table.fail(key,
                       fmt::format("{} needs {} or velocity_z_m_per_s", table.full(key), along_r));
    }
    table.finish();
    return out;
}

void read_intergranular_strain(TomlTable& table, SandPlan& plan, bool in_space) {
    const bool has_parameters = !std::isnan(plan.parameters.elastic_strain_radius);
    using Start = words::IntergranularStart;
    const std::optional<int> given =
        choice_if(table, case_word("body.sand", "intergranular_strain"));
    const Start start = given            ? static_cast<Start>(*given)
                        : has_parameters ? Start::mobilised
                                         : Start::off;
    if (start != Start::off && !has_parameters)
        table.fail("intergranular_strain",
                   fmt::format("{} must be \"off\": the sand has no parameters for it",
                               table.full("intergranular_strain")));
    plan.options.intergranular_off = start == Start::off ? 1 : 0;
    plan.intergranular_rho = start == Start::mobilised ? 1.0 : 0.0;
    if (in_space) std::swap(plan.intergranular_direction[1], plan.intergranular_direction[2]);
    if (const auto direction = table.numbers_if("intergranular_direction", in_space ? 6 : 4)) {
        if (start != Start::mobilised)
            table.fail("intergranular_direction",
                       fmt::format("{} needs intergranular_strain = \"mobilised\", it is \"{}\"",
                                   table.full("intergranular_direction"),
                                   word_of(words::intergranular_starts, start)));
        std::copy(direction->begin(), direction->end(), plan.intergranular_direction);
        if (std::all_of(direction->begin(), direction->end(), [](double x) { return x == 0.0; }))
            table.fail("intergranular_direction",
                       table.full("intergranular_direction") + " must not be 0");
    }
}

// grain_density: of the body, if it is given.
SandPlan read_sand_body(TomlTable table, const std::filesystem::path& given, bool in_space) {
    SandPlan out{};
    out.parameters = read_sand_parameters(table).parameters;
    if (!given.empty()) out.parameters = sand_of(given);
    out.parameters.granulate_hardness *= words::kilopascal.si;
    out.parameters.pressure_shift *= words::kilopascal.si;
    grit_sand_options_init(&out.options, sizeof out.options);
    const grit::mpm::CaseWord& tolerance = case_word("body.sand", "tolerance");
    out.options.tolerance = number_or_default(table, tolerance);
    const std::string key = table.one_of({"void_ratio", "void_ratio_at_zero_pressure"});
    out.at_zero_pressure = key == "void_ratio_at_zero_pressure";
    out.void_ratio =
        number(table, out.at_zero_pressure ? case_word("body.sand", "void_ratio_at_zero_pressure")
                                           : case_word("body.sand", "void_ratio"));
    read_intergranular_strain(table, out, in_space);
    table.finish();
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&out.parameters, &sand, &error) != GRIT_OK)
        table.fail("", std::string("sand: ") + error.message);
    return out;
}

Geostatic read_stress_at_rest(TomlTable table) {
    Geostatic out;
    out.surface = number(table, case_word("body.stress_at_rest", "surface_m"));
    out.surcharge = number_or_default(table, case_word("body.stress_at_rest", "surcharge_kPa"));
    out.K0 = number_if(table, case_word("body.stress_at_rest", "K0"));
    table.finish();
    return out;
}

void read_water(TomlTable table, const Case& plan, BodyPlan& body) {
    WaterPlan& out = body.water.emplace();
    if (const auto drainage = choice_if(table, case_word("body.water", "drainage")))
        out.drainage = static_cast<Drainage>(*drainage);
    out.implicit = choice_if(table, case_word("body.water", "pressure")).value_or(0) != 0;
    out.porosity = number_if(table, case_word("body.water", "porosity")).value_or(0.0);
    out.bulk_modulus = number_or_default(table, case_word("body.water", "bulk_modulus_kPa"));
    out.density = number_or_default(table, case_word("body.water", "density_kg_per_m3"));
    out.largest_tension = number_or_default(table, case_word("body.water", "cavitation_kPa"));
    out.table = number_if(table, case_word("body.water", "water_table_m"));
    out.conductivity =
        number_if(table, case_word("body.water", "conductivity_m_per_s")).value_or(0.0);
    out.kozeny_carman =
        choice_if(table, case_word("body.water", "conductivity_law")).value_or(0) != 0;
    refuse(table, objection_to(plan, body.material, out, [&table](std::string_view key) {
               return table.has(std::string(key));
           }));
    for (const Outline& outline : body.outlines)
        for (const grit::Vector2& corner : outline.corners)
            refuse(table, objection_to_water_table(body, corner[1]));
    table.finish();
}

void read_material(TomlTable& table, BodyPlan& body, const std::filesystem::path& sand,
                   bool in_space) {
    const std::string kind = table.one_of({"elastic", "neo_hooke", "rigid", "sand"});
    TomlTable inner = table.table(kind);
    if (kind == "sand") body.material = read_sand_body(std::move(inner), sand, in_space);
    else if (kind == "rigid") body.material = read_rigid(std::move(inner), in_space);
    else body.material = read_elastic(std::move(inner), kind == "neo_hooke");
}

void read_density(TomlTable& table, BodyPlan& body) {
    const auto* sand = std::get_if<SandPlan>(&body.material);
    if (body.water) {
        if (table.has("density_kg_per_m3"))
            table.fail("density_kg_per_m3",
                       fmt::format("{}: a body with water needs grain_density_kg_per_m3 instead",
                                   table.full("density_kg_per_m3")));
        body.density = body.water->grain_density =
            number(table, case_word("body", "grain_density_kg_per_m3"));
        return;
    }
    const std::optional<std::string> key =
        table.one_of_if({"density_kg_per_m3", "grain_density_kg_per_m3"});
    if (!key) {
        if (!body.prescribed()) table.number("density_kg_per_m3");
        body.density = 1000.0;  // a rigid body's mass moves nothing
        return;
    }
    body.density =
        number(table, *key == "density_kg_per_m3" ? case_word("body", "density_kg_per_m3")
                                                  : case_word("body", "grain_density_kg_per_m3"));
    if (*key == "density_kg_per_m3") return;
    if (!sand || sand->at_zero_pressure)
        table.fail(*key, fmt::format("{} needs sand with a constant void_ratio", table.full(*key)));
    body.density /= 1.0 + sand->void_ratio;  // dry
}

}  // namespace

TimeTable read_time_table(TomlTable& table, const std::string& key, double unit) {
    TimeTable out;
    out.value = table.numbers(key);
    for (double& value : out.value) value *= unit;
    out.time = table.numbers_if("time_s").value_or(std::vector<double>{0.0});
    if (out.value.size() != out.time.size())
        table.fail(key,
                   fmt::format("{} must have as many numbers as {}, {}, got {}", table.full(key),
                               table.full("time_s"), out.time.size(), out.value.size()));
    refuse(table, objection_to(out));
    if (out.time.empty()) table.fail("time_s", table.full("time_s") + " is empty");
    return out;
}

namespace {

void read_outlines(TomlTable& table, const Case& plan, BodyPlan& out) {
    for (TomlTable& box : table.tables_if("box"))
        out.outlines.push_back(read_outline(std::move(box), true, plan));
    for (TomlTable& polygon : table.tables_if("polygon"))
        out.outlines.push_back(read_outline(std::move(polygon), false, plan));
    if (out.outlines.empty())
        table.fail("",
                   fmt::format("{0} needs a [[body.box]] or a [[body.polygon]]", table.full("")));
    out.particles_r = integer_or_default(table, case_word("body", "particles_per_cell_r"));
    out.particles_z = integer_or_default(table, case_word("body", "particles_per_cell_z"));
    if (const auto v = table.numbers_if("velocity_m_per_s", 2)) out.velocity = {(*v)[0], (*v)[1]};
}

}  // namespace

BodyPlan read_body(TomlTable table, Case& plan, const std::filesystem::path& sand) {
    BodyPlan out;
    out.name = table.string("name");
    if (plan.space) plan.space->bodies.push_back(read_solid(table, plan));
    else read_outlines(table, plan, out);
    read_material(table, out, sand, plan.space.has_value());
    if (auto water = table.table_if("water")) read_water(std::move(*water), plan, out);
    read_density(table, out);
    if (auto rest = table.table_if("stress_at_rest"))
        out.geostatic = read_stress_at_rest(std::move(*rest));
    const auto* elastic = std::get_if<ElasticPlan>(&out.material);
    if (out.geostatic && (out.rigid() || (elastic && elastic->neo_hooke)))
        table.fail("stress_at_rest", fmt::format("{}: sand and linear elastic bodies alone",
                                                 table.full("stress_at_rest")));
    if (out.prescribed() && table.has("velocity_m_per_s"))
        table.fail("velocity_m_per_s", fmt::format("{}: a rigid body moves as its table says",
                                                   table.full("velocity_m_per_s")));
    table.finish();
    return out;
}

}  // namespace cli
