// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "element/number.hpp"

namespace cli {
namespace {

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

// Of a sheet whose cells are parted by semicolons or tabs, where a comma may be the decimal one.
std::vector<std::string> parted_cells(const std::string& line, char mark, bool numbers) {
    std::vector<std::string> out = grit::csv::cells_of(line, mark);
    if (!numbers) return out;
    for (std::string& cell : out) {
        std::string pointed = cell;
        std::replace(pointed.begin(), pointed.end(), ',', '.');
        if (element::number_of(pointed)) cell = pointed;
    }
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

std::vector<std::string> comments_above(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<std::string> out;
    std::string text(grit::longest_line, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    grit::TextLines lines(text);
    for (std::string line; lines.next(line) && line.starts_with('#');)
        out.push_back(line.substr(std::min<std::size_t>(line.size(), 2)));
    return out;
}

Cells read_cells(const std::filesystem::path& path) {
    bool blanks = false;  // separate the cells
    char mark = ',';      // if not they
    const auto cut = [&](const std::string& line,
                         std::size_t rows) -> std::optional<std::vector<std::string>> {
        if (rows == 0) blanks = of_incremental_driver(line);
        if (rows == 0)
            for (const char each : {'\t', ',', ';'})
                if (line.find(each) != std::string::npos) mark = each;
        if (!blanks && mark != ',') return parted_cells(line, mark, rows > 0);
        if (!blanks) return grit::csv::cells_of(line);
        std::vector<std::string> words = words_of(line);
        // Below the names, incrementalDriver repeats the heading of its test.
        if (rows == 1 && !element::number_of(words.front())) return std::nullopt;
        return words;
    };
    try {
        return grit::csv::read(path, cut);
    } catch (const grit::csv::Error& error) {
        throw BadInput(error.what());
    }
}

Table read_table(const std::filesystem::path& path, const std::string& only) {
    const Cells cells = read_cells(path);
    Table out;
    out.file = path.string();
    for (const std::string& cell : cells.rows.front()) {
        const grit::csv::Head head = grit::csv::head_of(cell);
        out.columns.push_back({head.name, head.unit, {}, {}});
    }
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
