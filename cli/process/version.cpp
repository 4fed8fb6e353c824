// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/version.hpp"

#include <fmt/format.h>
#include <grit/grit.h>

namespace cli {

std::string version() {
    const int v = grit_version();
    return fmt::format("{}.{}.{}", v / 10000, v / 100 % 100, v % 100);
}

std::string version_and_instruction_set() {
    constexpr const char* names[] = {"", "baseline", "AVX2", "AVX-512"};
    return fmt::format("grit {}, instruction set {}", version(), names[grit_instruction_set()]);
}

}  // namespace cli
