// SPDX-License-Identifier: BSD-3-Clause
// parameters.inp: the name of the material, the number of PROPS, one value a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace incremental_driver {

struct Parameters {
    std::string name;           // CMNAME
    std::vector<double> props;  // PROPS
    std::vector<int> lines;     // where each of them stands
};

// Throws BadInput.
Parameters read_parameters(const std::filesystem::path& path);

}  // namespace incremental_driver
