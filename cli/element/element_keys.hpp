// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace cli {

// verification/cases/every_key.toml, compiled in by cmake/GritEmbed.cmake.
const std::string& element_keys();

}  // namespace cli
