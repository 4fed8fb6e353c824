// SPDX-License-Identifier: BSD-3-Clause
// Tables as laboratories keep them: CSV of any country, and sheets of workbooks.
#pragma once

#include "cli/table/table.hpp"

namespace cli {

struct SheetFormat {
    std::string sheet;     // of a workbook, empty: the first
    int header_line = 0;   // on which the names of the columns stand, 0: the first that has any
    char separator = ',';  // of a CSV
    bool decimal_comma = false;
};

// Rows as they are written, the header first, numbers with a point. path ends with .xlsx: a workbook, lines are its
// rows. Throws BadInput naming file, line or sheet.
Cells read_sheet(const std::filesystem::path& path, const SheetFormat& layout);

// "file.csv:17" or "file.xlsx, sheet TMD1, row 17".
std::string place_in(const std::filesystem::path& path, const SheetFormat& layout, int line);

}  // namespace cli
