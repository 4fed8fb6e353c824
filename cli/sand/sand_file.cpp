// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sand/sand_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "cli/sand/parameter_units.hpp"
#include "element/atomic_file.hpp"
#include "element/nearest.hpp"
#include "element/sand_names.hpp"

namespace cli {

void read_sand_parameter(TomlTable& table, int index, grit_sand_parameters& parameters) {
    const grit_sand_parameter_info& info = *grit_sand_parameter_describe(index);
    const std::string key = parameter_key(info);
    const std::optional<double> value = table.number_if(key);
    if (!value) return;
    const Unit unit = unit_of(info);
    const double low = info.lowest / unit.size, high = info.highest / unit.size;
    // Limits in degrees round to a hair inside those in radians.
    if (!(*value >= low * (1.0 - 1e-12) && *value <= high * (1.0 + 1e-12)))
        table.fail(key, fmt::format("{} ({}) must be in [{:.6g}, {:.6g}] {}, got {:g}{}",
                                    table.full(key), info.symbol, low, high, unit.name, *value,
                                    unit.name == "deg" && *value < low ? ": radians?" : ""));
    grit_sand_parameter_set(&parameters, index, *value * unit.size);
}

grit_sand_parameters sand_of(const std::filesystem::path& name_or_file) {
    const std::string name = name_or_file.string();
    const int record = grit_sand_record_find(name.c_str());
    if (record < 0 && std::filesystem::exists(name_or_file)) return read_sand_file(name_or_file);
    if (record < 0)
        throw BadInput(fmt::format("there is no file {0}, and no sand is called \"{0}\"{1}", name,
                                   element::suggestion(name, element::sand_names())));
    grit_sand_parameters out;
    grit_sand_parameters_init(&out, sizeof out);
    grit_sand_record_parameters(record, 1.0, &out);
    return out;
}

grit_sand_parameters read_sand_file(const std::filesystem::path& path) {
    TomlTable file = TomlTable::of_file(path);
    TomlTable table = file.table("sand");
    grit_sand_parameters out;
    grit_sand_parameters_init(&out, sizeof out);
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) read_sand_parameter(table, i, out);
    table.finish();
    file.finish();
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&out, &sand, &error) != GRIT_OK)
        table.fail("", std::string("sand: ") + error.message);
    return out;
}

void write_sand_file(element::AtomicFile& file, const grit_sand_parameters& parameters,
                     const std::vector<std::string>& comments) {
    for (std::string text : comments) {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; },
            ' ');
        file.write("# " + text + "\n");
    }
    file.write("[sand]\n");
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        double value = NAN;
        grit_sand_parameter_get(&parameters, i, &value);
        if (std::isnan(value)) continue;
        // 17 digits: read again, they are the same parameters to the last bit but for degrees.
        file.write(fmt::format("{} = {:.17g}  # {}\n", parameter_key(info),
                               value / unit_of(info).size, info.symbol));
    }
    file.flush();
}

}  // namespace cli
