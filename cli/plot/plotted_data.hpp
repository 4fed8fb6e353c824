// SPDX-License-Identifier: BSD-3-Clause
// Files as grit plot takes them: results, and laboratories' sheets whose columns --column explains.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/table/table.hpp"

namespace cli {

using Renames = std::map<std::string, std::string>;  // theirs to ours

// Of "OURS=THEIRS". OURS: what pictures draw or, of pictures of any columns, what is understood. Throws BadInput.
Renames renames_of(const std::vector<std::string>& columns, bool any);

struct PlottedFile {
    std::filesystem::path path;
    bool data = false;   // of a laboratory, drawn as points
    std::string kind;    // of picture, as the file says it; empty: it says nothing
    Table named;         // with the names that --column gives
    Table standardised;  // with Grit's names and units
};

// only: rows of data whose first cell it is. Throws BadInput.
PlottedFile read_plotted(const std::filesystem::path& path, bool data, const std::string& only,
                         const Renames& renames);

// Each of --column is of some file. Throws BadInput naming the nearest.
void check_renames_used(const Renames& renames, const std::vector<PlottedFile>& files);

// Strains and stresses of data that have the other sign than those of the run are said, and what the other sign is called.
void say_mirrored(const PlottedFile& data, const PlottedFile& run);
// What nobody has taken notice of is said: it may be the column that is missing in the picture.
void say_unused(const PlottedFile& data, bool first_is_a_name);
// What is understood and not in such a picture; stresses and strains are parts of p, q and the like.
void say_not_drawn(const PlottedFile& data, const std::string& kind);

}  // namespace cli
