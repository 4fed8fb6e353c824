// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/parameter_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/sand/parameter_units.hpp"

namespace cli {

std::vector<ParameterRow> parameter_rows(const CalibrationCase& file,
                                         const CalibrationResult& result) {
    std::vector<ParameterRow> out;
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        const calibration::Estimate& start = file.start[static_cast<std::size_t>(i)];
        const auto place = file.space.find(i);
        const bool tied = std::any_of(file.space.ties.begin(), file.space.ties.end(),
                                      [i](const calibration::Tie& tie) { return tie.index == i; });
        if (std::isnan(start.value) || (!place && !tied && info.optional == 1)) continue;
        const auto text = [&info](double value) {
            return fmt::format("{:.5g}", value / unit_of(info).size);
        };
        ParameterRow row;
        row.info = &info;
        row.unit = unit_of(info).name;
        row.start = text(start.value);
        row.best = text(calibration::get(result.best, i));
        row.origin = place || tied ? start.origin : "fixed";
        if (place) {
            const ParameterInterval& interval = result.intervals[static_cast<std::size_t>(*place)];
            row.lowest = text(interval.lowest);
            row.highest = text(interval.highest);
            if (!result.laplace.determines(*place)) row.doubt = "not determined";
            else if (interval.ends_at_bound) row.doubt = "open to its bound";
        }
        out.push_back(std::move(row));
    }
    return out;
}

}  // namespace cli
