// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

#include "element/driver.hpp"

namespace element {

// Write a file aside and rename it when complete, so that a reader never sees half of it.
// Throws std::filesystem::filesystem_error.
void write_aside(const std::filesystem::path& path, const std::function<void(std::FILE*)>& write);

// Comment lines (#) with sand, case and version, a header with units, a row per increment.
void write_csv(const std::filesystem::path& path, const Case& test, const Run& run);

}  // namespace element
