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
    std::vector<Panel> panels;  // none: a table of words
    std::vector<std::vector<std::string>> cells;
    bool compared = false;  // of runs that belong together
    std::string command;    // that writes such tables; empty: not known
};

// A row of comparison.csv of grit element: a run beside it.
struct ComparedRun {
    std::string name, label;  // no label: by its title
};
bool is_comparison(const Finding& finding);
std::vector<ComparedRun> compared_runs(const Finding& finding);  // throws BadInput

// Panels as grit element and grit mpm draw them, with the points of a reference, and what went on over the cycles; of a
// comparison those of all its runs; of tables that are none of theirs all columns over the first. Throws BadInput.
Shown shown_of(const Finding& finding);

std::string json_of(const Shown& shown);

}  // namespace cli
