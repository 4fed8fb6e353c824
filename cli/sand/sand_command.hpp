// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/process/exit_code.hpp"

namespace cli {

ExitCode list_sands();
// Of the catalogue, or a file. Throws BadInput for an unknown name.
ExitCode show_sand(const std::string& name);

const std::vector<std::string>& props_forms();  // classic, radian, calculix, incremental-driver
// The sand as PROPS of a UMAT, in the words of a host. void_ratio: of the sample, 0: none. Throws BadInput.
ExitCode show_props(const std::string& name, const std::string& form, double void_ratio);

}  // namespace cli
