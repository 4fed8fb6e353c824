// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/sheet.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "cli/table/workbook.hpp"
#include "support/tables/text_file.hpp"

namespace cli {
namespace {

using Row = std::vector<std::string>;  // a line or row as it is written; empty: there is none
using grit::csv::most_cells;
using grit::csv::trimmed;

bool is_utf8(const std::string& text) {
    int following = 0;
    for (const char each : text) {
        const auto byte = static_cast<unsigned char>(each);
        if (following > 0) {
            if ((byte & 0xC0) != 0x80) return false;
            --following;
        } else if (byte >= 0x80) {
            following = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
            if (byte < 0xC2 || byte > 0xF4) return false;
        }
    }
    return following == 0;
}

std::string from_latin_1(const std::string& text) {
    std::string out;
    for (const char each : text) {
        const auto byte = static_cast<unsigned char>(each);
        if (byte < 0x80) {
            out += each;
            continue;
        }
        out += static_cast<char>(0xC0 | byte >> 6);
        out += static_cast<char>(0x80 | (byte & 0x3F));
    }
    return out;
}

std::string read_whole(const std::filesystem::path& path) {
    const auto fail = [&path](const char* why) {
        throw BadInput(fmt::format("{}: {}", path.string(), why));
    };
    std::string text;
    try {
        text = grit::read_text_file(path, grit::longest_table);
    } catch (const grit::TextFileError& error) {
        throw BadInput(error.what());
    }
    if (text.starts_with("PK\x03\x04")) fail("is a workbook: let its name end with .xlsx");
    if (text.starts_with(old_workbook_begin)) fail(old_workbook);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        fail("is UTF-16: save it as CSV in UTF-8");
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return is_utf8(text) ? text : from_latin_1(text);
}

// A line break within quotation marks does not end a row, which stands where it begins.
std::vector<Row> lines_of(const std::filesystem::path& path, char separator) {
    std::vector<Row> out;
    const std::string text = read_whole(path);
    std::size_t cells = 0;
    for (std::size_t from = 0; from < text.size();) {
        std::size_t end = from, lines = 1;
        bool quoted = false;
        for (; end < text.size() && (quoted || text[end] != '\n'); ++end) {
            if (text[end] == '"') quoted = !quoted;
            if (text[end] == '\n') ++lines;
        }
        if (quoted) {  // an inch, or a mark that is missing
            end = std::min(text.find('\n', from), text.size());
            lines = 1;
        }
        const std::string line = text.substr(from, end - from);
        from = end + 1;
        const std::size_t place = out.size();
        const bool is_row = !line.starts_with('#') && !trimmed(line).empty();
        cells += lines;
        if (is_row)
            cells += static_cast<std::size_t>(std::count(line.begin(), line.end(), separator));
        if (cells > most_cells)
            throw BadInput(
                fmt::format("{}:{}: more than {} cells", path.string(), place + 1, most_cells));
        out.resize(place + lines);
        if (is_row) out[place] = grit::csv::cells_of(line, separator);
    }
    return out;
}

// Rows without anything are none, as are columns without a name at the end.
std::vector<Row> rows_of(const std::filesystem::path& path, const std::string& sheet) {
    std::vector<Row> out = read_workbook(path, sheet).rows;
    for (Row& row : out) {
        for (std::string& cell : row) cell = trimmed(cell);
        while (!row.empty() && row.back().empty()) row.pop_back();
    }
    return out;
}

std::vector<Row> read_rows(const std::filesystem::path& path, const SheetFormat& layout) {
    if (is_workbook(path)) return rows_of(path, layout.sheet);
    return lines_of(path, layout.separator != 0 ? layout.separator : ',');
}

// Without the line breaks and double spaces of headers that look well on paper.
std::string single_spaced(const std::string& name) {
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool wide = name.compare(i, 2, "\xC2\xA0") == 0;  // a space that does not break
        if (wide) ++i;
        if (!wide && std::string(" \t\r\n").find(name[i]) == std::string::npos) out += name[i];
        else if (!out.empty() && out.back() != ' ') out += ' ';
    }
    return trimmed(out);
}

// 0,5 as 0.5. A point where a comma is due would be a thousand, or another country's.
std::string with_point(const std::filesystem::path& path, const SheetFormat& layout, int line,
                       std::string cell) {
    const auto digits = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+'; };
    if (cell.empty() || !(digits(cell.front()) || cell.front() == ',')) return cell;
    // 12.03.2020 is a date, nobody's number.
    const bool number =
        cell.find(',') != std::string::npos || std::count(cell.begin(), cell.end(), '.') == 1;
    if (!is_workbook(path) && number && cell.find('.') != std::string::npos &&
        std::all_of(cell.begin(), cell.end(),
                    [&](char c) { return digits(c) || c == '.' || c == ','; }))
        throw BadInput(fmt::format("{}: \"{}\" has a point, and decimal_comma = true: write 1036,2",
                                   place_in(path, layout, line), cell));
    std::replace(cell.begin(), cell.end(), ',', '.');
    return cell;
}

}  // namespace

bool is_workbook(const std::filesystem::path& path) { return path.extension() == ".xlsx"; }

Cells read_sheet(const std::filesystem::path& path, const SheetFormat& layout) {
    const std::vector<Row> rows = read_rows(path, layout);
    Cells out;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int line = static_cast<int>(i) + 1;
        Row row = rows[i];
        for (std::string& cell : row)
            std::replace_if(
                cell.begin(), cell.end(),
                [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
        if (row.empty() || line < layout.header_line) continue;
        if (out.rows.empty()) {
            if (row.size() == 1 && row[0].find(';') != std::string::npos)
                throw BadInput(fmt::format("{}:{}: cells are separated by semicolons: separator = "
                                           "\";\"",
                                           path.string(), line));
            for (std::string& cell : row) cell = single_spaced(cell);
        } else {
            if (line < layout.first_line) continue;
            if (layout.last_line > 0 && line > layout.last_line) break;
            const std::size_t cells_of_header = out.rows.front().size();
            if (!is_workbook(path) && row.size() != cells_of_header)
                throw BadInput(fmt::format("{}: {} cells where the header has {}",
                                           place_in(path, layout, line), row.size(),
                                           cells_of_header));
            if (out.rows.size() * cells_of_header > most_cells)
                throw BadInput(
                    fmt::format("{}: more than {} cells in rows as long as the header, {}",
                                place_in(path, layout, line), most_cells, cells_of_header));
            row.resize(cells_of_header);
            if (layout.decimal_comma)
                for (std::string& cell : row) cell = with_point(path, layout, line, cell);
        }
        out.rows.push_back(std::move(row));
        out.lines.push_back(line);
    }
    if (out.rows.size() < 2)
        throw BadInput(fmt::format("{}{}: needs a header and at least one row", path.string(),
                                   layout.sheet.empty() ? "" : ", sheet " + layout.sheet));
    return out;
}

std::optional<int> line_with(const std::filesystem::path& path, const SheetFormat& layout,
                             const std::string& cell) {
    const std::vector<Row> rows = read_rows(path, layout);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const std::string& each : rows[i])
            if (single_spaced(each) == cell) return static_cast<int>(i) + 1;
    return std::nullopt;
}

std::string place_in(const std::filesystem::path& path, const SheetFormat& layout, int line) {
    if (!is_workbook(path)) return fmt::format("{}:{}", path.string(), line);
    return fmt::format("{}, {}row {}", path.string(),
                       layout.sheet.empty() ? "" : "sheet " + layout.sheet + ", ", line);
}

}  // namespace cli
