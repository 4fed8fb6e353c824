// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/calibration_case.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "cli/calibrate/test_reader.hpp"
#include "cli/element/material_reader.hpp"
#include "cli/element/numerics_reader.hpp"
#include "cli/sand/parameter_units.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

using calibration::FreeParameter;

// Where a parameter of sand is sought if nobody says otherwise, as files write it.
struct Range {
    const char* symbol;
    double lowest, highest;
};
constexpr Range usual_ranges[] = {
    {"phi_c", 20.0, 45.0}, {"h_s", 1e4, 1e9},   {"n", 0.05, 0.9},    {"e_d0", 0.2, 1.2},
    {"e_c0", 0.3, 2.0},    {"e_i0", 0.35, 2.5}, {"alpha", 0.005, 1}, {"beta", 0.0, 5.0},
    {"p_t", 0.0, 100.0},   {"m_R", 1.0, 20.0},  {"m_T", 1.0, 20.0},  {"R", 1e-5, 1e-3},
    {"beta_r", 0.02, 2.0}, {"chi", 0.5, 20.0},
};

const grit_sand_parameter_info& info_of(int index) { return *grit_sand_parameter_describe(index); }

std::vector<std::string> symbols() {
    std::vector<std::string> out;
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) out.emplace_back(info_of(i).symbol);
    return out;
}

int read_parameter(const TomlTable& table, const std::string& key, const std::string& word) {
    const int index = calibration::parameter_index(word);
    if (index < 0)
        table.fail(key, fmt::format("{}: no parameter is called \"{}\"{}", table.full(key), word,
                                    element::suggestion(word, symbols())));
    return index;
}

// lowest and highest, within what the library takes.
void read_bounds(TomlTable& table, FreeParameter& parameter) {
    const grit_sand_parameter_info& info = info_of(parameter.index);
    const Unit unit = unit_of(info);
    const std::string key = parameter_key(info);
    const auto given = table.numbers_if(key, 2);
    if (!given) return;
    const double low = (*given)[0] * unit.size, high = (*given)[1] * unit.size;
    if (!(low < high) || !(low >= info.lowest * (1.0 - 1e-12)) ||
        !(high <= info.highest * (1.0 + 1e-12)))
        table.fail(key, fmt::format("{} must be two rising numbers in [{:.6g}, {:.6g}] {}, got "
                                    "[{:g}, {:g}]",
                                    table.full(key), info.lowest / unit.size,
                                    info.highest / unit.size, unit.name, (*given)[0], (*given)[1]));
    parameter.lowest = std::max(low, info.lowest);
    parameter.highest = std::min(high, info.highest);
}

void read_free(TomlTable& table, calibration::ParameterSpace& space) {
    std::set<int> taken;
    std::vector<std::string> words = table.strings_or_none("parameters");
    if (words.empty())
        table.fail("parameters", fmt::format("{} is missing: name what is sought of {}",
                                             table.full("parameters"), fmt::join(symbols(), ", ")));
    auto bounds = table.table_if("bounds");
    for (const std::string& word : words) {
        FreeParameter parameter;
        parameter.index = read_parameter(table, "parameters", word);
        if (!taken.insert(parameter.index).second)
            table.fail("parameters",
                       fmt::format("{}: {} is named twice", table.full("parameters"), word));
        const auto range =
            std::find_if(std::begin(usual_ranges), std::end(usual_ranges), [&](const Range& each) {
                return std::string(each.symbol) == info_of(parameter.index).symbol;
            });
        const double size = unit_of(info_of(parameter.index)).size;
        parameter.lowest = range->lowest * size;
        parameter.highest = range->highest * size;
        if (bounds) read_bounds(*bounds, parameter);
        space.free.push_back(parameter);
    }
    if (bounds) bounds->finish();
}

// [fit.ties]: e_i0 = { of = "e_c0", times = 1.15 }
void read_ties(TomlTable& fit, calibration::ParameterSpace& space) {
    auto table = fit.table_if("ties");
    if (!table) return;
    for (const std::string& key : table->given()) {
        calibration::Tie tie;
        tie.index = read_parameter(*table, key, key);
        if (space.find(tie.index))
            table->fail(key, fmt::format("{} is sought itself: a tie makes it another's multiple",
                                         table->full(key)));
        TomlTable inner = table->table(key);
        tie.to = read_parameter(inner, "of", inner.string("of"));
        tie.factor = inner.positive_or("times", 1.0);
        inner.finish();
        if (!space.find(tie.to))
            inner.fail("of", fmt::format("{}: {} is not sought", inner.full("of"),
                                         calibration::symbol_of(tie.to)));
        if (std::string(unit_of(info_of(tie.index)).name) != unit_of(info_of(tie.to)).name)
            inner.fail("of", fmt::format("{}: {} and {} have different units", inner.full("of"),
                                         calibration::symbol_of(tie.index),
                                         calibration::symbol_of(tie.to)));
        space.ties.push_back(tie);
    }
    table->finish();
}

struct IndexKeys {
    const char* value;
    const char* error;
    const char* symbol;  // of the parameter that it is a measure of
    double size;
    std::optional<double> calibration::IndexTests::*place;
};

calibration::IndexTests read_index_tests(TomlTable& root, CalibrationCase& out) {
    calibration::IndexTests index;
    auto table = root.table_if("index_tests");
    if (!table) return index;
    const IndexKeys keys[] = {
        {"angle_of_repose_deg", "angle_of_repose_error_deg", "phi_c", degree,
         &calibration::IndexTests::angle_of_repose},
        {"least_void_ratio", "least_void_ratio_error", "e_d0", 1.0,
         &calibration::IndexTests::least_void_ratio},
        {"largest_void_ratio", "largest_void_ratio_error", "e_c0", 1.0,
         &calibration::IndexTests::largest_void_ratio},
    };
    std::string without_error;
    for (const IndexKeys& key : keys) {
        if (table->has(key.error) && !table->has(key.value))
            table->fail(key.error, fmt::format("{} is that of {}, which is missing",
                                               table->full(key.error), key.value));
        if (!table->has(key.value)) continue;
        const double value = table->positive_or(key.value, 1.0) * key.size;
        const int parameter = calibration::parameter_index(key.symbol);
        const grit_sand_parameter_info& info = info_of(parameter);
        if (!(value >= info.lowest && value <= info.highest))
            table->fail(key.value, fmt::format("{} must be in [{:g}, {:g}], got {:g}",
                                               table->full(key.value), info.lowest / key.size,
                                               info.highest / key.size, value / key.size));
        index.*key.place = value;
        if (!table->has(key.error))
            without_error += (without_error.empty() ? "" : ", ") + std::string(key.error);
        else
            out.direct.push_back({parameter, value, table->positive_or(key.error, 1.0) * key.size});
    }
    if (!without_error.empty())
        out.doubts.push_back(
            fmt::format("the fit starts at the index tests, and no more: with {} they are "
                        "measurements as the others are",
                        without_error));
    table->finish();
    if (index.least_void_ratio && index.largest_void_ratio &&
        !(*index.least_void_ratio < *index.largest_void_ratio))
        root.fail("index_tests", "index_tests: least_void_ratio must be below largest_void_ratio");
    return index;
}

void check_name(const TomlTable& table, const std::string& name) {
    for (const char c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '.')
            table.fail("name", fmt::format("name: a case may be named with letters, digits, _ - . "
                                           "only, got \"{}\": give it a name = \"...\"",
                                           name));
    if (name.empty() || name.front() == '.') table.fail("name", "name: a case needs a name");
}

void read_fit(TomlTable& table, CalibrationCase& out) {
    read_free(table, out.space);
    read_ties(table, out.space);
    if (table.has("loss")) out.loss = table.choice("loss", calibration::Loss::words());
    out.loss_scale = table.positive_or("loss_scale", out.loss_scale);
    out.starts = table.integer_or("starts", out.starts, 1, 1000);
    out.spread = table.positive_or("spread", out.spread);
    if (!(out.spread < 1.0))
        table.fail("spread", fmt::format("{} must be in (0, 1), got {:g}: percent?",
                                         table.full("spread"), out.spread));
    out.inflate = !table.boolean_or("errors_as_stated", false);
}

// What is not sought must be known. Estimates are for what is.
grit_sand_parameters known_parameters(const TomlTable& fit, const grit_sand_parameters& given,
                                      CalibrationCase& out) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const bool tied = std::any_of(out.space.ties.begin(), out.space.ties.end(),
                                      [i](const calibration::Tie& tie) { return tie.index == i; });
        const bool needed = info_of(i).optional == 0 || out.space.find(i);
        if (!needed || tied || out.space.find(i)) continue;
        if (std::isnan(calibration::get(given, i)))
            fit.fail("parameters", fmt::format("{} is neither sought nor given: name it in "
                                               "fit.parameters, or give sand.{}",
                                               info_of(i).symbol, parameter_key(info_of(i))));
    }
    for (const FreeParameter& each : out.space.free)
        if (info_of(each.index).optional == 2 && std::isnan(calibration::get(given, each.index)))
            fit.fail("parameters",
                     fmt::format("{} is sought: give sand.{} to start from, and the others of the "
                                 "intergranular strain",
                                 info_of(each.index).symbol, parameter_key(info_of(each.index))));
    return given;
}

void set_start(const TomlTable& fit, const calibration::IndexTests& index,
               const grit_sand_parameters& given, CalibrationCase& out) {
    out.start = calibration::estimate(out.experiments, index, given);
    out.space.base = given;
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        calibration::set(out.space.base, i, out.start[static_cast<std::size_t>(i)].value);
    for (FreeParameter& each : out.space.free) {
        calibration::Estimate& start = out.start[static_cast<std::size_t>(each.index)];
        const double clamped = std::clamp(start.value, each.lowest, each.highest);
        if (clamped != start.value) start.origin += ", moved into its bounds";
        start.value = clamped;
        calibration::set(out.space.base, each.index, clamped);
    }
    for (const calibration::Tie& tie : out.space.ties) {
        const double value = tie.factor * calibration::get(out.space.base, tie.to);
        out.start[static_cast<std::size_t>(tie.index)] = {
            value, fmt::format("{:g} {}", tie.factor, calibration::symbol_of(tie.to))};
        calibration::set(out.space.base, tie.index, value);
    }
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&out.space.base, &sand, &error) != GRIT_OK)
        fit.fail("parameters", fmt::format("the fit would start from no sand: {}", error.message));
}

double read_resolution(TomlTable& numerics) {
    constexpr double lowest = 0.1, highest = 100.0;
    const double value = numerics.number_if("resolution").value_or(1.0);
    if (!(value >= lowest && value <= highest))
        numerics.fail("resolution",
                      fmt::format("{} must be in [{}, {}], got {:g}", numerics.full("resolution"),
                                  lowest, highest, value));
    return value;
}

}  // namespace

CalibrationCase read_calibration_case(const std::filesystem::path& path) {
    CalibrationCase out;
    out.path = path;
    TomlTable root = TomlTable::of_file(path, &out.inputs);
    out.name = root.string_if("name").value_or(path.stem().string());
    check_name(root, out.name);
    out.title = root.string_if("title").value_or(out.name);

    TestDefaults defaults;
    NamedSand sand;
    grit_sand_parameters_init(&sand.parameters, sizeof sand.parameters);
    if (auto table = root.table_if("sand")) {
        sand = read_sand_parameters(*table);
        read_water(*table, defaults.options);
        table->finish();
        if (!sand.file.empty()) out.inputs.push_back(sand.file);
    }
    defaults.parameters = sand.parameters;
    if (auto table = root.table_if("numerics")) {
        read_numerics(*table, defaults.options, defaults.settings);
        defaults.resolution = read_resolution(*table);
        table->finish();
    }
    TomlTable fit = root.table("fit");
    read_fit(fit, out);
    fit.finish();
    const calibration::IndexTests index = read_index_tests(root, out);
    std::set<std::string> names;
    for (TomlTable& test : root.tables_if("test")) {
        LaboratoryTests tests = read_tests(std::move(test), defaults, out.inputs);
        for (const calibration::Experiment& each : tests.experiments)
            if (!names.insert(each.name).second)
                root.fail("test", fmt::format("test: two tests are called \"{}\": say by fit and "
                                              "check which of a sheet are meant",
                                              each.name));
        std::move(tests.experiments.begin(), tests.experiments.end(),
                  std::back_inserter(out.experiments));
        out.sources.insert(out.sources.end(), tests.sources.begin(), tests.sources.end());
        out.doubts.insert(out.doubts.end(), tests.doubts.begin(), tests.doubts.end());
    }
    if (std::none_of(out.experiments.begin(), out.experiments.end(),
                     [](const calibration::Experiment& each) { return each.fitted; }))
        root.fail("test", "test: a calibration needs a [[test]] that is fitted");
    if (auto table = root.table_if("posterior")) {
        out.samples = table->integer_or("samples", 100000, 1000, most_samples);
        out.seed = static_cast<std::uint64_t>(table->integer_or("seed", 1, 0, 2000000000));
        table->finish();
    }
    if (auto table = root.table_if("beside")) {
        const NamedSand beside = read_sand_parameters(*table);
        out.beside = beside.name;
        out.beside_parameters = beside.parameters;
        if (!beside.file.empty()) out.inputs.push_back(beside.file);
        table->finish();
    }
    root.finish();
    set_start(fit, index, known_parameters(fit, sand.parameters, out), out);
    return out;
}

}  // namespace cli
