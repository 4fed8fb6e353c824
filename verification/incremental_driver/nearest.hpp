// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace incremental_driver {

// "did you mean *LinearLoad?", or all of them where none is near. known must not be empty.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& known);

}  // namespace incremental_driver
