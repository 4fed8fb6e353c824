// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/import_table.hpp"

#include "element/incremental_driver/lines.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

bool starts_a_number(const Line& line) {
    return trimmed(line.text).find_first_of("0123456789+-.") == 0;
}

}  // namespace

std::vector<std::vector<double>> read_import_table(const std::filesystem::path& path, int columns,
                                                   int rows) {
    Lines lines(path);
    while (lines.peek() && !starts_a_number(*lines.peek())) lines.next("a heading");
    std::vector<std::vector<double>> table;
    int last = 0;
    while (!lines.at_end() && table.size() < static_cast<std::size_t>(rows)) {
        const Line& line = lines.next("a row");
        last = line.number;
        Fields fields(lines, line);
        std::vector<double> row;
        for (int c = 1; c <= columns; ++c)
            row.push_back(fields.real(element::text("column %d of %d", c, columns)));
        table.push_back(std::move(row));
    }
    if (table.size() < 2)
        lines.fail(last, "expected at least two rows of numbers, the increments lie between them");
    return table;
}

}  // namespace incremental_driver
