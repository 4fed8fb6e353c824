// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace element {

// Of the published sands, in the order of the catalogue.
std::vector<std::string> sand_names();

}  // namespace element
