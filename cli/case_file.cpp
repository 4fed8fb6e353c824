// SPDX-License-Identifier: BSD-3-Clause
#include "cli/case_file.hpp"

#include <cctype>
#include <fstream>

#include <fmt/format.h>

#include "cli/exit_code.hpp"
#include "cli/parameter_units.hpp"
#include "cli/reference_table.hpp"
#include "cli/toml_table.hpp"

namespace cli {
namespace {

void set_parameter(TomlTable& table, int index, grit_sand_parameters& parameters) {
    const grit_sand_parameter_info& info = *grit_sand_parameter_describe(index);
    const std::optional<double> value = table.number_if(info.name);
    if (!value) return;
    const Unit unit = unit_of(info);
    const double low = info.lowest / unit.size, high = info.highest / unit.size;
    // Limits in degrees round to a hair inside those in radians.
    if (!(*value >= low * (1.0 - 1e-12) && *value <= high * (1.0 + 1e-12)))
        table.fail(info.name, fmt::format("sand.{} ({}) must be in [{:.6g}, {:.6g}] {}, got {:g}{}",
                                          info.name, info.symbol, low, high, unit.name, *value,
                                          unit.name == "deg" && *value < low ? ": radians?" : ""));
    grit_sand_parameter_set(&parameters, index, *value * unit.size);
}

void read_sand(TomlTable table, element::Case& test) {
    grit_sand_parameters_init(&test.parameters, sizeof test.parameters);
    test.sand = "given in the case file";
    if (const std::optional<std::string> name = table.string_if("name")) {
        const int record = grit_sand_record_find(name->c_str());
        if (record < 0)
            table.fail("name", fmt::format("no sand is called \"{}\": see grit sand list", *name));
        grit_sand_record_parameters(record, 1.0, &test.parameters);
        test.sand = *name;
    }
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) set_parameter(table, i, test.parameters);
    table.finish();
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&test.parameters, &sand, &error) != GRIT_OK)
        table.fail("", std::string("sand: ") + error.message);
}

element::IntergranularStrain intergranular_strain(TomlTable& table) {
    const std::string key = "intergranular_strain";
    const std::string value = table.string(key);
    if (value == "mobilised") return element::IntergranularStrain::mobilised;
    if (value == "zero") return element::IntergranularStrain::zero;
    if (value == "off") return element::IntergranularStrain::off;
    table.fail(key, fmt::format("start.{} must be \"mobilised\", \"zero\" or \"off\", got \"{}\"",
                                key, value));
}

void read_start(TomlTable table, element::Start& start) {
    start.pressure = table.number("pressure");
    start.void_ratio = table.number_if("void_ratio");
    start.void_ratio_at_zero = table.number_if("void_ratio_at_zero_pressure");
    start.intergranular_strain = intergranular_strain(table);
    table.finish();
}

void read_loading(TomlTable table, element::Loading& loading) {
    const double strain = table.number("axial_strain");
    if (strain == 0.0) table.fail("axial_strain", "loading.axial_strain must not be 0");
    loading = element::drained_triaxial(strain);
    loading.increments = table.integer_or("increments", loading.increments);
    if (const std::optional<double> first = table.number_if("first_increment")) {
        if (!(*first > 0.0))
            table.fail("first_increment",
                       fmt::format("loading.first_increment must be > 0, got {:g}", *first));
        loading.first_share = *first / std::abs(strain);
    }
    table.finish();
}

void read_numerics(TomlTable table, element::Numerics& numerics) {
    numerics.tolerance = table.number_if("tolerance").value_or(numerics.tolerance);
    numerics.evaluation_limit = table.integer_or("evaluation_limit", numerics.evaluation_limit);
    table.finish();
}

Reference read_reference(TomlTable table, const std::filesystem::path& folder) {
    Reference reference;
    for (const std::string& quantity : reference_quantities())
        if (const std::optional<double> value = table.number_if(quantity)) {
            if (*value == 0.0)
                table.fail(quantity,
                           "reference." + quantity + " must not be 0: differences are relative");
            reference.values.push_back({quantity, *value});
        }
    reference.tolerance = table.number_if("tolerance");
    reference.origin = table.string("origin");
    if (const std::optional<std::string> curve = table.string_if("curve")) {
        reference.curve = (folder / *curve).lexically_normal();
        if (!std::ifstream(reference.curve))
            table.fail("curve", fmt::format("cannot read {}", reference.curve.string()));
    }
    table.finish();
    return reference;
}

// The name becomes part of file names.
std::string case_name(TomlTable& table, const std::filesystem::path& path) {
    const std::string name = table.string_if("name").value_or(path.stem().string());
    for (const char c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '.')
            table.fail("name", fmt::format("a case may be named with letters, digits, _ - . only, "
                                           "got \"{}\"",
                                           name));
    if (name.empty() || name.front() == '.') table.fail("name", "a case needs a name");
    return name;
}

toml::table parse(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path))
        throw BadInput(fmt::format("{}: cannot read this file", path.string()));
    try {
        return toml::parse(file, path.string());
    } catch (const toml::parse_error& error) {
        throw BadInput(fmt::format("{}:{}: {}", path.string(), error.source().begin.line,
                                   error.description()));
    }
}

}  // namespace

CaseFile read_case_file(const std::filesystem::path& path) {
    const toml::table values = parse(path);
    TomlTable root(values, path.string(), "");
    CaseFile out;
    out.test.name = case_name(root, path);
    out.test.title = root.string_if("title").value_or(out.test.name);
    if (const std::string test = root.string("test"); test != "drained_triaxial")
        root.fail("test", fmt::format("test must be \"drained_triaxial\", got \"{}\"", test));
    read_sand(root.table("sand"), out.test);
    read_start(root.table("start"), out.test.start);
    read_loading(root.table("loading"), out.test.loading);
    if (auto numerics = root.table_if("numerics")) read_numerics(*numerics, out.test.numerics);
    if (auto reference = root.table_if("reference"))
        out.reference = read_reference(*reference, path.parent_path());
    root.finish();
    return out;
}

}  // namespace cli
