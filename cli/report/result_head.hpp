// SPDX-License-Identifier: BSD-3-Clause
// What the comments above the columns of a result tell about how it was made.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/report/findings.hpp"

namespace cli {

struct ResultHead {
    std::vector<std::string> comments;  // all, without their marks
    std::string version;                // "Grit 0.1.0 (9a6c098d5faa)"
    std::string made;                   // "case lausitz_dense"
    std::string title;
    std::string settings;  // "start.void_ratio=0.6, --sand hostun", of --set, --vary and --sand
};

ResultHead head_of(const std::filesystem::path& table);

// Of every finding by its stem: its title, and what tells it from others of the same title, where that is known.
std::map<std::string, std::string> headings_of(const std::vector<Finding>& findings);

}  // namespace cli
