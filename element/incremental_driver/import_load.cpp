// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/components.hpp"
#include "element/incremental_driver/import_table.hpp"
#include "element/incremental_driver/loads.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

using element::text;
using Column = element::Imported::Column;

constexpr int most_columns = 1000;

struct Source {
    std::filesystem::path file;
    int columns;
};

Source read_source(const Lines& lines, const Keyword& keyword,
                   const std::filesystem::path& folder) {
    const std::size_t bar = keyword.argument.find('|');
    const std::string name = trimmed(keyword.argument.substr(0, bar));
    if (bar == std::string::npos || name.empty())
        lines.fail(keyword.line, "expected *ImportFile name|columns, got \"*ImportFile " +
                                     keyword.argument + "\"");
    Fields columns(lines, keyword.line, keyword.argument.substr(bar + 1));
    return {folder / name, columns.whole("the number of columns behind |", 1, most_columns)};
}

// "column [* factor]" behind what has been read of the line.
Column read_column(const Lines& lines, const Line& line, const std::string& rest, int columns) {
    const std::size_t star = rest.find('*');
    Column out;
    out.index = Fields(lines, line.number, rest.substr(0, star)).whole("column", 0, columns) - 1;
    if (star != std::string::npos)
        out.factor = Fields(lines, line.number, rest.substr(star + 1)).real("the factor behind *");
    return out;
}

void check_time(const Source& source, const element::Imported& load) {
    const Column& time = load.time;
    const auto index = static_cast<std::size_t>(time.index);
    for (std::size_t i = 1; i < load.table.size(); ++i) {
        const double change = time.factor * (load.table[i][index] - load.table[i - 1][index]);
        if (!(change >= 0.0))
            throw BadInput(text("%s: time must not run backwards, it does from row %d to %d by %g",
                                source.file.string().c_str(), static_cast<int>(i),
                                static_cast<int>(i) + 1, change));
    }
}

}  // namespace

std::filesystem::path read_import(Lines& lines, const Keyword& keyword,
                                  const std::filesystem::path& folder, element::Step& step) {
    const Source source = read_source(lines, keyword, folder);
    const element::Variables variables = read_variables(lines);
    element::Imported load;
    element::Controls controls;
    for (std::size_t i = 0; i < 6; ++i) {
        const Line& line = lines.next(text("component %d of 6", static_cast<int>(i) + 1));
        Fields fields(lines, line.number, within_forty_columns(lines, line));
        controls[i] = read_control(fields);
        load.columns[i] = read_column(lines, line, fields.rest(), source.columns);
    }
    load.rows = mixed_control(controls, variables);
    const bool timed_by_column = step.duration <= 0.0;
    if (timed_by_column) {
        const Line& line = lines.next("the column of time, for dtime is not positive");
        load.time = read_column(lines, line, within_forty_columns(lines, line), source.columns);
    }
    load.table = read_import_table(source.file, source.columns, step.increments + 1);
    if (load.time.index >= 0) check_time(source, load);
    step.increments = static_cast<int>(load.table.size()) - 1;
    step.duration = timed_by_column ? 0.0 : step.duration * step.increments;
    step.kind = std::move(load);
    return source.file;
}

}  // namespace incremental_driver
