// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/reference.hpp"

#include <fmt/format.h>

#include "cli/element/curve_difference.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/table/columns.hpp"
#include "cli/table/foreign_columns.hpp"

namespace cli {
namespace {

std::string column_name(TomlTable& table, const std::string& key) {
    return table.choice(key, standard_column_names());
}

ReferenceValue read_value(TomlTable table, int stages) {
    ReferenceValue out;
    out.quantity = column_name(table, "quantity");
    if (table.has("over")) out.over = column_name(table, "over");
    if (table.has("at")) {
        const std::string at = table.choice("at", {"end", "largest", "smallest"});
        out.at = at == "end" ? At::end : at == "largest" ? At::largest : At::smallest;
        if (!out.over.empty())
            table.fail("at", table.full("at") + " makes no sense together with over");
    }
    out.stage = table.integer_or("stage", 0, 1, stages);
    if (!out.over.empty() && out.stage == 0)
        table.fail("over", table.full("over") + " needs a stage");
    out.value = table.number("value");
    if (out.value == 0.0)
        table.fail("value", table.full("value") + " must not be 0: differences are relative");
    if (table.has("tolerance")) out.tolerance = table.positive_or("tolerance", 1.0);
    table.finish();
    return out;
}

}  // namespace

Reference read_reference(TomlTable table, int stages, const std::string& sample) {
    Reference out;
    out.origin = table.string("origin");
    for (TomlTable& value : table.tables_if("value"))
        out.values.push_back(read_value(std::move(value), stages));
    if (const std::optional<std::string> curve = table.string_if("curve")) {
        out.curve_file = (table.folder_of("curve") / *curve).lexically_normal();
        try {
            out.curve = standardised(read_table(out.curve_file, sample));
            // Every column that somebody may ask for, while nothing has been computed yet.
            for (const std::string& name : standard_column_names()) out.curve.find(name);
        } catch (const BadInput& error) {
            table.fail("curve", fmt::format("{}: {}", table.full("curve"), error.what()));
        }
    }
    if (table.has("curve_tolerance")) {
        out.curve_tolerance = table.positive_or("curve_tolerance", 1.0);
        if (out.curve_file.empty())
            table.fail("curve_tolerance", table.full("curve_tolerance") + " needs a curve");
        if (const std::string why = incomparable(out.curve); !why.empty())
            table.fail("curve", fmt::format("{}: {}", table.full("curve"), why));
    }
    if (std::optional<TomlTable> exceptions = table.table_if("exceptions")) {
        if (sample.empty()) table.fail("exceptions", table.full("exceptions") + " needs samples");
        for (const std::string& name : exceptions->given()) {
            const double tolerance = exceptions->positive_or(name, 1.0);
            if (name == sample && !out.values.empty()) out.values.front().tolerance = tolerance;
        }
    }
    if (table.has("mean_ratio")) {
        if (sample.empty() || out.values.empty())
            table.fail("mean_ratio", table.full("mean_ratio") + " needs samples and a value");
        out.mean_ratio = table.number("mean_ratio");
        out.mean_ratio_tolerance = table.number("mean_ratio_tolerance");
    }
    table.finish();
    return out;
}

}  // namespace cli
