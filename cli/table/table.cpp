// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/table.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "element/number.hpp"

namespace cli {
namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\"");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> out;
    std::size_t from = 0;
    while (true) {
        const std::size_t comma = line.find(',', from);
        out.push_back(trimmed(line.substr(from, comma - from)));
        if (comma == std::string::npos) return out;
        from = comma + 1;
    }
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream words(line);
    std::vector<std::string> out;
    for (std::string word; words >> word;) out.push_back(word);
    return out;
}

// The names above incrementalDriver's columns.
bool of_incremental_driver(const std::string& header) {
    return header.find(',') == std::string::npos && header.find("stran(") != std::string::npos;
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& p) : path(p), file(p) {
        if (!file || std::filesystem::is_directory(path))
            throw BadInput(fmt::format("{}: cannot read this file", path.string()));
    }

    Cells read() {
        std::string line;
        while (std::getline(file, line)) {
            if (++number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
            if (line.starts_with('#') || trimmed(line).empty()) continue;
            if (out.rows.empty()) blanks = of_incremental_driver(line);
            take(line);
        }
        if (out.rows.size() < 2)
            throw BadInput(fmt::format("{}: needs a header and at least one row", path.string()));
        return std::move(out);
    }

  private:
    void take(const std::string& line) {
        std::vector<std::string> row = blanks ? words_of(line) : cells_of(line);
        if (out.rows.empty() && row.size() == 1 && line.find(';') != std::string::npos)
            fail("cells are separated by commas, not by semicolons");
        // Below the names, incrementalDriver repeats the heading of its test.
        if (blanks && out.rows.size() == 1 && !element::number_of(row.front())) return;
        if (!out.rows.empty() && row.size() != out.rows.front().size())
            fail(fmt::format("{} cells where the header has {}", row.size(),
                             out.rows.front().size()));
        out.rows.push_back(std::move(row));
        out.lines.push_back(number);
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw BadInput(fmt::format("{}:{}: {}", path.string(), number, why));
    }

    std::filesystem::path path;
    std::ifstream file;
    Cells out;
    int number = 0;
    bool blanks = false;  // separate the cells
};

Column column_named(const std::string& head) {
    const std::size_t bracket = head.find(" [");
    Column out;
    out.name = head.substr(0, bracket);
    if (bracket == std::string::npos || !head.ends_with(']')) out.name = head;
    else out.unit = head.substr(bracket + 2, head.size() - bracket - 3);
    return out;
}

}  // namespace

const std::vector<double>* Table::find(const std::string& name) const {
    for (const Column& column : columns) {
        if (column.name != name) continue;
        if (!column.problem.empty()) throw BadInput(column.problem);
        return &column.values;
    }
    return nullptr;
}

const std::vector<double>& Table::at(const std::string& name) const {
    if (const std::vector<double>* values = find(name)) return *values;
    throw std::out_of_range("no column " + name);
}

Cells read_cells(const std::filesystem::path& path) { return Reader(path).read(); }

Table read_table(const std::filesystem::path& path, const std::string& only) {
    const Cells cells = read_cells(path);
    Table out;
    for (const std::string& head : cells.rows.front()) out.columns.push_back(column_named(head));
    for (std::size_t row = 1; row < cells.rows.size(); ++row) {
        if (!only.empty() && cells.rows[row].front() != only) continue;
        for (std::size_t i = 0; i < out.columns.size(); ++i) {
            Column& column = out.columns[i];
            const std::string& cell = cells.rows[row][i];
            const std::optional<double> value = element::number_of(cell);
            // Grit writes nan where it does not know.
            if (!value && !cell.empty() && cell != "nan" && column.problem.empty())
                column.problem = fmt::format("{}:{}: column {} has \"{}\" where a number is needed",
                                             path.string(), cells.lines[row], column.name, cell);
            column.values.push_back(value.value_or(NAN));
        }
    }
    if (out.rows() == 0) throw BadInput(fmt::format("{}: no row of {}", path.string(), only));
    return out;
}

}  // namespace cli
