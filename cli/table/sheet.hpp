// SPDX-License-Identifier: BSD-3-Clause
// Tables as laboratories keep them: CSV of any country, and sheets of workbooks.
#pragma once

#include <optional>

#include "cli/table/table.hpp"

namespace cli {

struct SheetFormat {
    std::string sheet;    // of a workbook, empty: the first
    int header_line = 0;  // on which the names of the columns stand, 0: the first that has any
    int first_line = 0;   // of the numbers, 0: the next one
    int last_line = 0;    // of the numbers, 0: the last that has any
    char separator = 0;   // of a CSV, 0: a comma
    bool decimal_comma = false;
};

// Rows as they are written, the header first, numbers with a point, names with single spaces. path ends with .xlsx: a
// workbook, lines are its rows. Text that is no UTF-8 is taken for Latin-1. Throws BadInput naming file, line or sheet.
Cells read_sheet(const std::filesystem::path& path, const SheetFormat& layout);

// The first line that has this cell.
std::optional<int> line_with(const std::filesystem::path& path, const SheetFormat& layout,
                             const std::string& cell);

// "file.csv:17" or "file.xlsx, sheet TMD1, row 17".
std::string place_in(const std::filesystem::path& path, const SheetFormat& layout, int line);
bool is_workbook(const std::filesystem::path& path);

}  // namespace cli
