// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sand/sand_file.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cli/sand/parameter_units.hpp"
#include "element/atomic_file.hpp"

namespace cli {

void write_sand_file(const std::filesystem::path& path, const grit_sand_parameters& parameters,
                     const std::vector<std::string>& comments) {
    element::AtomicFile file(path);
    for (const std::string& text : comments) file.write("# " + text + "\n");
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
    file.complete();
}

}  // namespace cli
