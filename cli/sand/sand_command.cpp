// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sand/sand_command.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <grit/radian_layout.h>

#include "cli/process/standard_streams.hpp"
#include "cli/sand/parameter_units.hpp"
#include "cli/sand/sand_file.hpp"

namespace cli {

ExitCode list_sands() {
    say("{:<18} {:<6} {}\n", "name", "status", "sand");
    for (int i = 0; i < grit_sand_record_count(); ++i) {
        const grit_sand_record& record = *grit_sand_record_at(i);
        say("{:<18} {:<6} {}\n", record.name, record.status, record.title);
    }
    say("status A: two independent sources agree; B: one source, or sources that differ\n");
    return ok;
}

namespace {

void say_parameters(const grit_sand_parameters& parameters) {
    say("\n{:<33} {:<8} {:>10}  {}\n", "parameter", "symbol", "value", "unit");
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        double value = NAN;
        grit_sand_parameter_get(&parameters, i, &value);
        const Unit unit = unit_of(info);
        const std::string number =
            std::isnan(value) ? "not given" : fmt::format("{:.6g}", value / unit.size);
        say("{:<33} {:<8} {:>10}  {}\n", info.name, info.symbol, number, unit.name);
    }
}

}  // namespace

ExitCode show_sand(const std::string& name) {
    const int index = grit_sand_record_find(name.c_str());
    const grit_sand_parameters parameters = sand_of(name);
    if (index < 0) {
        say("{}\n", name);
        say_parameters(parameters);
        return ok;
    }
    const grit_sand_record& record = *grit_sand_record_at(index);
    say("{}\nstatus  {}\nsource  {}\n", record.title, record.status, record.source);
    if (*record.note) say("note    {}\n", record.note);
    say_parameters(parameters);
    return ok;
}

const std::vector<std::string>& props_forms() {
    static const std::vector<std::string> forms = {"classic", "radian", "calculix",
                                                   "incremental-driver"};
    return forms;
}

ExitCode show_props(const std::string& name, const std::string& form, double void_ratio) {
    const grit_sand_parameters parameters = sand_of(name);
    if (void_ratio > parameters.loosest_void_ratio)
        throw BadInput(fmt::format("--void-ratio must be at most {:g}, e_i0 of {}, got {:g}",
                                   parameters.loosest_void_ratio, name, void_ratio));
    double classic[GRIT_CLASSIC_NPROPS], props[GRIT_CLASSIC_NPROPS];
    grit_classic_props(&parameters, !std::isnan(parameters.reversal_stiffness), classic);
    constexpr int e_0 = GRIT_CLASSIC_VOID_RATIO_AT_ZERO_PRESSURE;
    if (void_ratio > 0.0) classic[e_0] = GRIT_CLASSIC_TRUE_VOID_RATIO + void_ratio;
    else
        warn("grit: PROPS({}), the void ratio of the sample, is 0, which a host takes only if "
             "STATEV({}) has one; --void-ratio E writes {:g} + E\n",
             e_0 + 1, GRIT_CLASSIC_VOID_RATIO + 1, GRIT_CLASSIC_TRUE_VOID_RATIO);
    std::copy(std::begin(classic), std::end(classic), props);
    if (form == "radian" && grit_radian_of_classic(classic, props) != GRIT_OK)
        throw BadInput(fmt::format("{}: the radian layout has no place for p_t = {:g} kPa", name,
                                   parameters.pressure_shift));
    if (form == "incremental-driver") {
        say("{}\n{}\n", std::filesystem::path(name).stem().string(), GRIT_CLASSIC_NPROPS);
        for (const double value : props) say("{:.15g}\n", value);
        return ok;
    }
    if (form == "calculix") say("*USER MATERIAL, CONSTANTS={}\n", GRIT_CLASSIC_NPROPS);
    for (int i = 0; i < GRIT_CLASSIC_NPROPS; ++i)
        say("{:.15g}{}", props[i], i % 8 == 7 ? "\n" : ", ");
    // Where the constants fill their lines, CalculiX wants one more, with the temperature.
    if (form == "calculix") say("293.\n");
    return ok;
}

}  // namespace cli
