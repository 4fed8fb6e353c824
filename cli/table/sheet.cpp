// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/sheet.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "cli/table/workbook.hpp"

namespace cli {
namespace {

bool is_workbook(const std::filesystem::path& path) { return path.extension() == ".xlsx"; }

std::vector<std::string> cut_at(const std::string& line, char separator) {
    std::vector<std::string> out;
    for (std::size_t from = 0;;) {
        const std::size_t end = line.find(separator, from);
        out.push_back(grit::csv::trimmed(line.substr(from, end - from)));
        if (end == std::string::npos) return out;
        from = end + 1;
    }
}

Cells read_text(const std::filesystem::path& path, const SheetFormat& layout) {
    const auto cut = [&](const std::string& line, std::size_t) {
        return std::optional(cut_at(line, layout.separator));
    };
    try {
        return grit::csv::read(path, cut, layout.header_line);
    } catch (const grit::csv::Error& error) {
        throw BadInput(error.what());
    }
}

// As wide as the header; rows without anything are left out, as are columns without a name at the end.
Cells read_workbook_sheet(const std::filesystem::path& path, const SheetFormat& layout) {
    const WorkbookSheet sheet = read_workbook(path, layout.sheet);
    Cells out;
    for (std::size_t i = 0; i < sheet.rows.size(); ++i) {
        const int line = static_cast<int>(i) + 1;
        std::vector<std::string> row = sheet.rows[i];
        for (std::string& cell : row) cell = grit::csv::trimmed(cell);
        while (!row.empty() && row.back().empty()) row.pop_back();
        if (row.empty() || line < layout.header_line) continue;
        if (!out.rows.empty()) row.resize(out.rows.front().size());
        out.rows.push_back(std::move(row));
        out.lines.push_back(line);
    }
    if (out.rows.size() < 2)
        throw BadInput(fmt::format("{}, sheet {}: needs a header and at least one row",
                                   path.string(), sheet.name));
    return out;
}

}  // namespace

Cells read_sheet(const std::filesystem::path& path, const SheetFormat& layout) {
    if (is_workbook(path)) return read_workbook_sheet(path, layout);
    Cells out = read_text(path, layout);
    if (layout.decimal_comma)
        for (std::size_t i = 1; i < out.rows.size(); ++i)
            for (std::string& cell : out.rows[i]) std::replace(cell.begin(), cell.end(), ',', '.');
    return out;
}

std::string place_in(const std::filesystem::path& path, const SheetFormat& layout, int line) {
    if (!is_workbook(path)) return fmt::format("{}:{}", path.string(), line);
    return fmt::format("{}, {}row {}", path.string(),
                       layout.sheet.empty() ? "" : "sheet " + layout.sheet + ", ", line);
}

}  // namespace cli
