// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/material_reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <grit/radian_layout.h>

#include "cli/sand/sand_file.hpp"
#include "element/errors.hpp"
#include "element/nearest.hpp"
#include "element/sand_names.hpp"

namespace cli {
namespace {

double start_void_ratio(TomlTable& table, const grit_sand& sand, double p) {
    const std::string key =
        table.one_of({"void_ratio", "void_ratio_at_zero_pressure", "relative_density"});
    const double value = table.number(key);
    const element::VoidRatios limits = element::void_ratios(sand, p);
    double e = value;
    if (key == "void_ratio_at_zero_pressure") e = element::void_ratio_at_pressure(sand, value, p);
    if (key == "relative_density") e = limits.critical - value * (limits.critical - limits.densest);
    if (!(e >= limits.densest && e <= limits.loosest))
        table.fail(key, fmt::format("{}: the void ratio must be in [e_d, e_i] = [{:.4f}, {:.4f}] "
                                    "at p = {:g} kPa, got {:.6g}",
                                    table.full(key), limits.densest, limits.loosest, p, e));
    return e;
}

int statev_index(TomlTable& table, const std::string& key, int size) {
    return table.integer_or(key, 0, 1, std::max(size, 1)) - 1;  // counted from 1 in the file
}

}  // namespace

NamedSand read_sand_parameters(TomlTable& table) {
    NamedSand out;
    grit_sand_parameters_init(&out.parameters, sizeof out.parameters);
    if (const std::optional<std::string> file = table.string_if("file")) {
        if (table.has("name"))
            table.fail("name", fmt::format("{} and {}: the sand comes from one or the other",
                                           table.full("name"), table.full("file")));
        out.file = table.folder_of("file") / *file;
        out.name = out.file.stem().string();
        out.parameters = read_sand_file(out.file);
    }
    if (const std::optional<std::string> name = table.string_if("name")) {
        const int record = grit_sand_record_find(name->c_str());
        if (record < 0)
            table.fail("name",
                       fmt::format("{}: no sand is called \"{}\"{}", table.full("name"), *name,
                                   element::suggestion(*name, element::sand_names())));
        grit_sand_record_parameters(record, 1.0, &out.parameters);
        out.name = *name;
    }
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        read_sand_parameter(table, i, out.parameters);
    return out;
}

void take_sand(CaseFile& file, const std::filesystem::path& given) {
    file.parameters = sand_of(given);
    file.sand = given.stem().string();
    if (std::filesystem::exists(given)) file.inputs.push_back(given);
}

void read_sand(TomlTable table, CaseFile& file, const std::filesystem::path& given) {
    NamedSand named = read_sand_parameters(table);
    if (!given.empty())
        named = {given.stem().string(), sand_of(given),
                 std::filesystem::exists(given) ? given : ""};
    file.parameters = named.parameters;
    file.sand = named.name;
    if (!named.file.empty()) file.inputs.push_back(named.file);
    read_water(table, file.options);
    table.finish();
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&file.parameters, &sand, &error) != GRIT_OK)
        table.fail("", std::string("sand: ") + error.message);
}

void read_umat(TomlTable table, CaseFile& file) {
    element::UmatSource source;
    if (const std::optional<std::string> library = table.string_if("library"))
        source.library = (table.folder_of("library") / *library).lexically_normal();
    source.props = table.numbers("props");
    file.umat_state = table.numbers("statev");
    const int given = static_cast<int>(file.umat_state.size());
    source.state_size = table.integer_or("nstatv", given, given, 1000000);
    source.material_name = table.string_if("material_name").value_or(source.material_name);
    source.state_names = table.strings_or_none("state_names");
    source.void_ratio = statev_index(table, "void_ratio_statev", source.state_size);
    source.minus_pore_pressure =
        statev_index(table, "minus_pore_pressure_statev", source.state_size);
    table.finish();
    file.umat = std::move(source);
}

element::Vector6 read_start_stress(TomlTable& table) {
    if (table.one_of({"pressure_kPa", "stress_kPa"}) == "pressure_kPa")
        return -table.positive_or("pressure_kPa", 0.0) * element::unit_tensor();
    const std::vector<double> values = table.numbers("stress_kPa", 6);
    const element::Vector6 stress = Eigen::Map<const element::Vector6>(values.data());
    if (!(stress.head<3>().sum() < 0.0))
        table.fail("stress_kPa",
                   fmt::format("{} must press: tension is positive, and p = {:g} kPa",
                               table.full("stress_kPa"), -stress.head<3>().sum() / 3.0));
    return stress;
}

void read_water(TomlTable& table, element::GritLawOptions& options) {
    const auto take = [&table](const char* key, std::optional<double> given, double& value) {
        if (!given) return;
        if (!(*given >= 0.0))
            table.fail(key, fmt::format("{} must be >= 0, got {:g}", table.full(key), *given));
        value = *given;
    };
    take("water_stiffness_kPa", table.number_if("water_stiffness_kPa"), options.water_stiffness);
    take("water_bulk_modulus_kPa", table.number_if("water_bulk_modulus_kPa"),
         options.water_bulk_modulus);
    take("cavitation_kPa", table.number_if("cavitation_kPa"), options.largest_tension);
    if (options.water_stiffness > 0.0 && options.water_bulk_modulus > 0.0)
        table.fail("water_bulk_modulus_kPa",
                   fmt::format("{} and {}: the water has one or the other",
                               table.full("water_stiffness_kPa"),
                               table.full("water_bulk_modulus_kPa")));
    if (table.has("cavitation_kPa") && !options.has_water())
        table.fail("cavitation_kPa",
                   fmt::format("{} is that of water: give {}", table.full("cavitation_kPa"),
                               table.full("water_bulk_modulus_kPa")));
}

void read_intergranular_start(TomlTable& table, const grit_sand_parameters& parameters,
                              element::Start& start) {
    using element::IntergranularStrain;
    start.intergranular_strain = element::usual_intergranular_strain(parameters);
    if (table.has("intergranular_strain")) {
        const std::string h = table.choice("intergranular_strain", {"mobilised", "zero", "off"});
        if (start.intergranular_strain == IntergranularStrain::off && h != "off")
            table.fail("intergranular_strain",
                       fmt::format("{} must be \"off\": the sand has no parameters for it",
                                   table.full("intergranular_strain")));
        start.intergranular_strain = h == "off"    ? IntergranularStrain::off
                                     : h == "zero" ? IntergranularStrain::zero
                                                   : IntergranularStrain::mobilised;
    }
    if (const auto direction = table.numbers_if("intergranular_direction", 6))
        start.direction = Eigen::Map<const element::Vector6>(direction->data());
    if (start.direction.isZero())
        table.fail("intergranular_direction",
                   table.full("intergranular_direction") + " must not be 0");
    start.rho = table.number_if("intergranular_rho").value_or(start.rho);
    if (!(start.rho >= 0.0 && start.rho <= 1.0))
        table.fail("intergranular_rho", fmt::format("{} must be in [0, 1], got {:g}",
                                                    table.full("intergranular_rho"), start.rho));
}

void read_start(TomlTable table, CaseFile& file) {
    using element::IntergranularStrain;
    element::Start& start = file.start;
    start.stress = read_start_stress(table);
    if (!file.sand.empty()) {
        grit_sand sand;
        grit_sand_prepare(&file.parameters, &sand, nullptr);
        start.void_ratio = start_void_ratio(table, sand, -start.stress.head<3>().sum() / 3.0);
        start.pore_pressure = table.number_if("pore_pressure_kPa").value_or(0.0);
        if (start.pore_pressure != 0.0 && !file.options.has_water())
            table.fail(
                "pore_pressure_kPa",
                fmt::format("{} is that of water in the sand: give sand.water_bulk_modulus_kPa",
                            table.full("pore_pressure_kPa")));
        read_intergranular_start(table, file.parameters, start);
    }
    file.options.intergranular_strain = start.intergranular_strain != IntergranularStrain::off;
    table.finish();
}

void fill_umat(CaseFile& file, bool radian) {
    const grit_sand_parameters& p = file.parameters;
    element::UmatSource source;
    source.props.resize(GRIT_CLASSIC_NPROPS);
    double classic[GRIT_CLASSIC_NPROPS];
    grit_classic_props(&p, file.options.intergranular_strain, classic);
    const element::GritLawOptions& water = file.options;
    classic[GRIT_CLASSIC_WATER_STIFFNESS] = water.water_stiffness + water.water_bulk_modulus;
    if (!radian) std::copy_n(classic, GRIT_CLASSIC_NPROPS, source.props.begin());
    else if (grit_radian_of_classic(classic, source.props.data()) != GRIT_OK)
        throw element::BadCase(
            fmt::format("the radian layout has no place for p_t = {:g} kPa", p.pressure_shift));
    if (water.water_bulk_modulus > 0.0 || std::isfinite(water.largest_tension)) {
        source.props.resize(GRIT_CLASSIC_PROPS_READ);
        source.props[GRIT_CLASSIC_LARGEST_TENSION] =
            std::isfinite(water.largest_tension) ? water.largest_tension : 0.0;
        source.props[GRIT_CLASSIC_WATER_ITSELF] = water.water_bulk_modulus > 0.0 ? 1.0 : 0.0;
        source.largest_tension = water.largest_tension;
    }
    if (water.largest_tension == 0.0)
        throw element::BadCase("cavitation_kPa = 0 has no place in the PROPS of a UMAT, where 0 "
                               "stands for water that never "
                               "cavitates: give a small tension");
    if (file.options.tolerance != element::usual_options().tolerance) {
        const std::size_t least = GRIT_CLASSIC_TOLERANCE + 1;
        if (source.props.size() < least) source.props.resize(least);
        source.props[GRIT_CLASSIC_TOLERANCE] = file.options.tolerance;
    }
    if (file.options.evaluation_limit != element::usual_options().evaluation_limit)
        throw element::BadCase(
            fmt::format("numerics.evaluation_limit = {} has no place in the PROPS of a UMAT",
                        file.options.evaluation_limit));
    source.state_size = GRIT_CLASSIC_NSTATV + 1;
    source.void_ratio = radian ? int{GRIT_RADIAN_VOID_RATIO} : int{GRIT_CLASSIC_VOID_RATIO};
    if (water.has_water()) source.minus_pore_pressure = GRIT_CLASSIC_PORE_STRESS;
    source.state_names = {"h_11", "h_22", "h_33", "h_12", "h_13", "h_23"};
    source.state_names.insert(source.state_names.begin() + source.void_ratio, "void_ratio");

    file.umat_state.assign(6, 0.0);
    if (file.start.intergranular_strain == element::IntergranularStrain::mobilised) {
        grit_sand sand;
        grit_sand_prepare(&p, &sand, nullptr);
        double state[GRIT_SAND_STATE_SIZE] = {};
        grit_sand_mobilise(&sand, file.start.direction.data(), file.start.rho, state);
        std::copy_n(state, 6, file.umat_state.begin());
    }
    file.umat_state.insert(file.umat_state.begin() + source.void_ratio, file.start.void_ratio);
    file.umat_state.resize(GRIT_CLASSIC_NSTATV + 1, 0.0);
    file.umat_state[GRIT_CLASSIC_PORE_STRESS] = -file.start.pore_pressure;
    file.umat_pore_pressure = std::max(file.start.pore_pressure, -water.largest_tension);
    file.umat = std::move(source);
}

void make_material(CaseFile& file) {
    const element::Start& start = file.start;
    if (file.umat) {
        const auto law = element::open_library_law(*file.umat);
        file.point = law->start(start.stress - file.umat_pore_pressure * element::unit_tensor(),
                                file.umat_state);
        file.law = law;
        return;
    }
    const auto law = std::make_shared<element::GritLaw>(file.parameters, file.options);
    file.point = element::start_point(*law, start);
    file.own_law = law.get();
    file.law = law;
}

}  // namespace cli
