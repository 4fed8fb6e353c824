// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/exit_code.hpp"

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

double number_of(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end ? NAN : value;
}

}  // namespace

const std::vector<double>* Table::find(const std::string& name) const {
    for (const Column& column : columns)
        if (column.name == name) return &column.values;
    return nullptr;
}

const std::vector<double>& Table::at(const std::string& name) const {
    if (const std::vector<double>* values = find(name)) return *values;
    throw std::out_of_range("no column " + name);
}

std::vector<std::vector<std::string>> read_cells(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path))
        throw BadInput(fmt::format("{}: cannot read this file", path.string()));
    std::vector<std::vector<std::string>> out;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.starts_with('#') || trimmed(line).empty()) continue;
        out.push_back(cells_of(line));
        if (out.back().size() != out.front().size())
            throw BadInput(fmt::format("{}:{}: {} cells where the header has {}", path.string(),
                                       number, out.back().size(), out.front().size()));
    }
    if (out.size() < 2)
        throw BadInput(fmt::format("{}: needs a header and at least one row", path.string()));
    return out;
}

Table read_table(const std::filesystem::path& path, const std::string& only) {
    const auto cells = read_cells(path);
    Table out;
    for (const std::string& head : cells.front()) {
        const std::size_t bracket = head.find(" [");
        const bool has_unit = bracket != std::string::npos && head.ends_with(']');
        out.columns.push_back({has_unit ? head.substr(0, bracket) : head,
                               has_unit ? head.substr(bracket + 2, head.size() - bracket - 3) : "",
                               {}});
    }
    for (std::size_t row = 1; row < cells.size(); ++row) {
        if (!only.empty() && cells[row].front() != only) continue;
        for (std::size_t i = 0; i < out.columns.size(); ++i)
            out.columns[i].values.push_back(number_of(cells[row][i]));
    }
    if (out.rows() == 0) throw BadInput(fmt::format("{}: no row of {}", path.string(), only));
    return out;
}

void write_file(const std::filesystem::path& path, const std::string& content) {
    std::filesystem::path aside = path;
    aside += ".part";
    std::ofstream file(aside, std::ios::binary);
    file << content;
    file.close();
    std::error_code refused;
    if (file) std::filesystem::rename(aside, path, refused);
    if (!file || refused) throw BadInput(fmt::format("{}: cannot write this file", path.string()));
}

void write_table(const std::filesystem::path& path, const Table& table) {
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    for (const std::string& comment : table.comments) fmt::format_to(to, "# {}\n", comment);
    for (const Column& column : table.columns)
        fmt::format_to(to, "{}{}{}", &column == &table.columns.front() ? "" : ",", column.name,
                       column.unit.empty() ? "" : fmt::format(" [{}]", column.unit));
    fmt::format_to(to, "\n");
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (const Column& column : table.columns)
            fmt::format_to(to, "{:.12g}{}", column.values[row],
                           &column == &table.columns.back() ? "\n" : ",");
    write_file(path, fmt::to_string(out));
}

}  // namespace cli
