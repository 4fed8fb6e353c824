// SPDX-License-Identifier: BSD-3-Clause
// The table that *ImportFile follows.
#pragma once

#include <filesystem>
#include <vector>

namespace incremental_driver {

// Lines before the first one that starts with a digit, a sign or a point are headings. Of the others
// the first `columns` values are taken; a blank line is skipped. At most `rows` rows are read. Throws
// BadInput for a value that is missing or no number, and for fewer than two rows.
std::vector<std::vector<double>> read_import_table(const std::filesystem::path& path, int columns,
                                                   int rows);

}  // namespace incremental_driver
