// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "element/atomic_file.hpp"

namespace cli {

// error: of errno. Throws element::CannotWrite.
[[noreturn]] inline void cannot_write(const std::filesystem::path& place, int error) {
    throw element::CannotWrite(fmt::format("{}: cannot write this file: {}", place.string(),
                                           std::generic_category().message(error)));
}

}  // namespace cli
