// SPDX-License-Identifier: BSD-3-Clause
// What a result is held against.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/table/table.hpp"
#include "cli/toml/toml_table.hpp"

namespace cli {

enum class At { end, largest, smallest };

// A column of the result at a place of the run, or the slope between two columns over a stage.
struct ReferenceValue {
    std::string quantity;
    std::string over;  // slope of quantity over this column between the ends of the stage
    At at = At::end;
    int stage = 0;  // from 1, 0: the whole run
    double value = 0.0;
    std::optional<double> tolerance;  // relative; the run fails beyond it
};

struct Reference {
    std::string origin;
    std::vector<ReferenceValue> values;
    std::filesystem::path curve_file;  // empty: none
    Table curve;                       // in the names of Grit; of samples, the rows of this one
    std::optional<double> curve_tolerance;  // of the largest stress of the curve, and of e
    // Over all samples of a file: mean of computed / reference of the first value.
    std::optional<double> mean_ratio;
    double mean_ratio_tolerance = 0.0;
};

// sample: name of the row of the table of samples, empty: none.
Reference read_reference(TomlTable table, int stages, const std::string& sample);

}  // namespace cli
