// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/table_file.hpp"

#include <iterator>

#include <fmt/format.h>

namespace cli {

TableFile::TableFile(const std::filesystem::path& path, const std::vector<std::string>& comments,
                     const std::vector<Column>& columns)
    : file(path) {
    for (const std::string& text : comments) comment(text);
    std::string header;
    for (const Column& column : columns)
        header += fmt::format("{}{}{}", header.empty() ? "" : ",", column.name,
                              column.unit.empty() ? "" : fmt::format(" [{}]", column.unit));
    file.write(header + "\n");
}

void TableFile::row(const std::vector<double>& values) {
    fmt::memory_buffer out;
    for (const double& value : values)
        fmt::format_to(std::back_inserter(out), "{:.12g}{}", value,
                       &value == &values.back() ? "\n" : ",");
    file.write({out.data(), out.size()});
}

void TableFile::comment(const std::string& text) { file.write("# " + text + "\n"); }

void write_table(const std::filesystem::path& path, const std::vector<std::string>& comments,
                 const Table& table) {
    TableFile file(path, comments, table.columns);
    for (std::size_t i = 0; i < table.rows(); ++i) {
        std::vector<double> row;
        for (const Column& column : table.columns) row.push_back(column.values[i]);
        file.row(row);
    }
    file.complete();
}

}  // namespace cli
