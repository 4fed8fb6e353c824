// SPDX-License-Identifier: BSD-3-Clause
// Curves of a table of results, as JSON for the page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/plot/picture.hpp"
#include "cli/report/findings.hpp"

namespace cli {

// What a table of results shows: curves where it has numbers, else its cells.
struct Shown {
    std::string title;
    std::vector<std::string> comments;  // above its columns
    std::vector<Panel> panels;          // none: a table of words
    std::vector<std::vector<std::string>> cells;
};

// Panels as grit element and grit mpm draw them; of tables that are none of theirs all columns over the first. Throws BadInput.
Shown shown_of(const Finding& finding);

std::string json_of(const std::vector<Panel>& panels);

}  // namespace cli
