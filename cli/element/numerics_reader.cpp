// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/numerics_reader.hpp"

#include <fmt/format.h>

namespace cli {

void read_numerics(TomlTable& table, element::GritLawOptions& options,
                   element::Settings& settings) {
    options.tolerance = table.positive_or("tolerance", options.tolerance);
    if (!(options.tolerance >= GRIT_SAND_LEAST_TOLERANCE &&
          options.tolerance <= GRIT_SAND_LARGEST_TOLERANCE))
        table.fail("tolerance", fmt::format("{} must be in [{:g}, {:g}], got {:g}",
                                            table.full("tolerance"), GRIT_SAND_LEAST_TOLERANCE,
                                            GRIT_SAND_LARGEST_TOLERANCE, options.tolerance));
    settings.tolerance = table.positive_or("stress_tolerance", settings.tolerance);
    if (!(settings.tolerance >= 1e-14 && settings.tolerance <= 1e-2))
        table.fail("stress_tolerance",
                   fmt::format("{} must be in [1e-14, 0.01], got {:g}",
                               table.full("stress_tolerance"), settings.tolerance));
    settings.smallest_part = table.positive_or("smallest_part", settings.smallest_part);
    if (!(settings.smallest_part <= 1.0))
        table.fail("smallest_part",
                   fmt::format("{} must be in (0, 1], got {:g}", table.full("smallest_part"),
                               settings.smallest_part));
    settings.iteration_limit =
        table.integer_or("iteration_limit", settings.iteration_limit, 1, 1000);
    options.evaluation_limit =
        table.integer_or("evaluation_limit", options.evaluation_limit,
                         GRIT_SAND_LEAST_EVALUATION_LIMIT, GRIT_SAND_LARGEST_EVALUATION_LIMIT);
}

}  // namespace cli
