// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/version.hpp"

#include <fmt/format.h>
#include <grit/grit.h>

#include "support/version/commit.hpp"
#include "support/version_text.hpp"

namespace cli {

std::string version() {
    const std::string commit = grit::commit();
    return grit::version_text(grit_version()) +
           (commit.empty() ? "" : fmt::format(" ({})", commit));
}

std::string version_and_instruction_set() {
    return fmt::format("grit {}, instruction set {}", version(),
                       grit::instruction_set_text(grit_instruction_set()));
}

std::string made_by_grit(const std::string& what, const std::string& title) {
    return fmt::format("Grit {}, {}: {}", version(), what, title);
}

}  // namespace cli
