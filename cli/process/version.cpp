// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/version.hpp"

#include <fmt/format.h>
#include <grit/version.h>

namespace cli {

std::string version() {
    const int v = grit_version();
    return fmt::format("{}.{}.{}", v / 10000, v / 100 % 100, v % 100);
}

}  // namespace cli
