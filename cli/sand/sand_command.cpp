// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sand/sand_command.hpp"

#include <cmath>

#include <fmt/format.h>

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
    if (index < 0 && std::filesystem::is_regular_file(name)) {
        const grit_sand_parameters parameters = read_sand_file(name);
        say("{}\n", name);
        say_parameters(parameters);
        return ok;
    }
    if (index < 0)
        throw BadInput(fmt::format("no sand is called \"{}\": see grit sand list", name));
    const grit_sand_record& record = *grit_sand_record_at(index);
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(index, 1.0, &parameters);
    say("{}\nstatus  {}\nsource  {}\n", record.title, record.status, record.source);
    if (*record.note) say("note    {}\n", record.note);
    say_parameters(parameters);
    return ok;
}

}  // namespace cli
