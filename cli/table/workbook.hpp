// SPDX-License-Identifier: BSD-3-Clause
// Sheets of Office Open XML workbooks (.xlsx): what stands in the cells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct WorkbookSheet {
    std::string name;
    std::vector<std::string> sheets;             // of the workbook
    std::vector<std::vector<std::string>> rows;  // from row 1, each as long as it is filled
};

// The sheet of this name, empty: the first. Formulas have the value that was stored with them. Throws BadInput.
WorkbookSheet read_workbook(const std::filesystem::path& path, const std::string& sheet);

}  // namespace cli
