// SPDX-License-Identifier: BSD-3-Clause
// Comma-separated tables: comments (#) and empty lines, a header "name [unit],...", rows of as many cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/tables/text_file.hpp"

namespace grit::csv {

// What is wrong with a file: its name, the line and why.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Of a table, empty ones too: each takes some 50 bytes or more.
constexpr std::size_t most_cells = 20'000'000;

// As they are written, the header first, and the lines they stand on.
struct Cells {
    std::vector<std::vector<std::string>> rows;
    std::vector<int> lines;
};

inline std::string trimmed(const std::string& text) {
    constexpr const char* blank = " \t\v\f\r\"";
    const auto first = text.find_first_not_of(blank);
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// Between quotation marks, where each is closed, what parts cells is a letter.
inline std::vector<std::string> cells_of(const std::string& line, char mark = ',') {
    const bool marked = std::count(line.begin(), line.end(), '"') % 2 == 0;  // or an inch
    std::vector<std::string> out = {""};
    bool quoted = false;
    for (const char each : line) {
        if (each == '"' && marked) quoted = !quoted;
        else if (each == mark && !quoted) out.emplace_back();
        else out.back() += each;
    }
    for (std::string& cell : out) cell = trimmed(cell);
    return out;
}

// cut(line, rows so far): the cells of a line, or none where it is to be passed over.
template <class Cut> Cells read(const std::filesystem::path& path, Cut&& cut) {
    std::string whole;
    try {
        whole = read_text_file(path, longest_table);
    } catch (const TextFileError& error) {
        throw Error(error.what());
    }
    if (whole.find('\0') != std::string::npos)
        throw Error(path.string() + ": is no table, it has bytes that no text has");
    Cells out;
    int number = 0;
    std::size_t cells = 0;
    TextLines lines(whole);
    for (std::string line; lines.next(line);) {
        if (++number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
        const auto fail = [&](const std::string& why) {
            throw Error(path.string() + ':' + std::to_string(number) + ": " + why);
        };
        if (line.size() > longest_line)
            fail("a line is longer than " + std::to_string(longest_line / megabyte) + " MiB");
        if (line.starts_with('#') || trimmed(line).empty()) continue;
        std::optional<std::vector<std::string>> row = cut(line, out.rows.size());
        if (!row) continue;
        if (out.rows.empty() && row->size() == 1 && line.find(';') != std::string::npos)
            fail("cells are separated by commas, not by semicolons");
        if (!out.rows.empty() && row->size() != out.rows.front().size())
            fail(std::to_string(row->size()) + " cells where the header has " +
                 std::to_string(out.rows.front().size()));
        cells += row->size();
        if (cells > most_cells) fail("more than " + std::to_string(most_cells) + " cells");
        out.rows.push_back(std::move(*row));
        out.lines.push_back(number);
    }
    if (out.rows.size() < 2) throw Error(path.string() + ": needs a header and at least one row");
    return out;
}

inline Cells read(const std::filesystem::path& path) {
    return read(path,
                [](const std::string& line, std::size_t) { return std::optional(cells_of(line)); });
}

// "name [unit]", of which the unit may be missing.
struct Head {
    std::string name, unit;
};
inline Head head_of(const std::string& cell) {
    const std::size_t bracket = cell.find(" [");
    if (bracket == std::string::npos || !cell.ends_with(']')) return {cell, {}};
    return {cell.substr(0, bracket), cell.substr(bracket + 2, cell.size() - bracket - 3)};
}

// Tables of numbers alone, as data of tests and results are; "nan" is one.
struct Numbers {
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;

    std::optional<std::size_t> find(const std::string& name) const {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name) return i;
        return std::nullopt;
    }
    std::size_t at(const std::string& name) const {
        if (const auto place = find(name)) return *place;
        throw Error("no column " + name);
    }
};

inline Numbers read_numbers(const std::filesystem::path& path) {
    const Cells cells = read(path);
    Numbers out;
    for (const std::string& cell : cells.rows.front()) out.names.push_back(head_of(cell).name);
    for (std::size_t i = 1; i < cells.rows.size(); ++i) {
        std::vector<double>& row = out.rows.emplace_back();
        for (const std::string& cell : cells.rows[i]) {
            char* end = nullptr;
            row.push_back(std::strtod(cell.c_str(), &end));
            if (cell.empty() || *end != '\0')
                throw Error(path.string() + ':' + std::to_string(cells.lines[i]) + ": \"" + cell +
                            "\" where a number is needed");
        }
    }
    return out;
}

}  // namespace grit::csv
