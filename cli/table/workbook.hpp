// SPDX-License-Identifier: BSD-3-Clause
// Sheets of Office Open XML workbooks (.xlsx): what stands in the cells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

// How the files of older programs begin (.xls), and what is to be done with them.
inline constexpr char old_workbook_begin[] = "\xD0\xCF\x11\xE0";
inline constexpr char old_workbook[] = "is a workbook of old: save it as .xlsx";

struct WorkbookSheet {
    std::string name;
    std::vector<std::string> sheets;             // of the workbook
    std::vector<std::vector<std::string>> rows;  // from row 1, each as long as it is filled
};

// The sheet of this name, empty: the first. Formulas have the value that was stored with them. Throws BadInput.
WorkbookSheet read_workbook(const std::filesystem::path& path, const std::string& sheet);

}  // namespace cli
