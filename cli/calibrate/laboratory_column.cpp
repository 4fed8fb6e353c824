// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/laboratory_column.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/table/columns.hpp"
#include "cli/table/laboratory_unit.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

bool is_strain(const std::string& quantity) { return quantity.find("strain") != std::string::npos; }

// Tension is positive of these; of p, q, axial_deviator, pore pressure and void ratio there is one sign only, and
// that of shear follows the machine.
bool has_sign(const std::string& quantity) {
    for (const char* each : {"axial_strain", "volumetric_strain", "strain_11", "strain_22",
                             "strain_33", "stress_11", "stress_22", "stress_33"})
        if (quantity == each) return true;
    return false;
}

using Where = std::function<std::string(const std::string&)>;

std::size_t place_of(TomlTable& table, const std::vector<std::string>& header, const Where& where) {
    const std::string name = table.string("column");
    const auto count = std::count(header.begin(), header.end(), name);
    if (count > 1)
        table.fail("column", fmt::format("{}: the sheet has {} columns \"{}\", or merged cells: "
                                         "rename one in the sheet",
                                         table.full("column"), count, name));
    if (count == 0)
        table.fail("column",
                   fmt::format("{}: the sheet has no column \"{}\"{}{}", table.full("column"), name,
                               element::suggestion(name, header), where(name)));
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
}

const LaboratoryUnit& read_unit(TomlTable& table, const std::string& column,
                                const std::string& unit) {
    const std::string said = unit_in(column);
    const LaboratoryUnit* found = laboratory_unit(said, unit);
    if (table.has("unit")) {
        const LaboratoryUnit& given =
            *laboratory_unit(table.choice("unit", laboratory_units(unit)), unit);
        if (found && found->name != std::string("-") && found->size != given.size)
            table.fail("unit", fmt::format("{} is \"{}\", and the header says \"{}\": rename the "
                                           "column in the sheet if that is wrong",
                                           table.full("unit"), given.name, found->name));
        return given;
    }
    if (found) return *found;
    for (const char* length : {"mm", "cm", "m"})
        if (said == length)
            table.fail("column", fmt::format("{}: \"{}\" is a length: give a column that is a "
                                             "strain, its share of the sample's height",
                                             table.full("column"), column));
    if (unit == "-" && table.full("").ends_with("void_ratio")) return *laboratory_unit("-", unit);
    std::string known;
    for (const std::string& each : laboratory_units(unit))
        known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", each);
    table.fail("column", fmt::format("{}: the header \"{}\" does not say its unit: give unit = "
                                     "one of {}",
                                     table.full("column"), column, known));
}

LaboratoryColumn read_column(TomlTable table, const std::string& quantity, const std::string& unit,
                             const std::vector<std::string>& header, const Where& where) {
    LaboratoryColumn out;
    out.quantity = quantity;
    out.unit = unit;
    out.place = place_of(table, header, where);
    out.name = header[out.place];
    const LaboratoryUnit& theirs = read_unit(table, out.name, unit);
    out.factor = theirs.size;
    if (has_sign(quantity) && table.choice("compression", {"positive", "negative"}) == "positive")
        out.factor = -out.factor;
    if (is_strain(quantity) && has_sign(quantity))
        out.engineering = !table.has("strain") ||
                          table.choice("strain", {"engineering", "logarithmic"}) == "engineering";
    if (table.has("error")) out.error = theirs.size * table.positive_or("error", 1.0);
    if (table.has("relative_error")) {
        out.relative_error = table.positive_or("relative_error", 1.0);
        if (!(out.relative_error <= 1.0))
            table.fail("relative_error",
                       fmt::format("{} must be in (0, 1], got {:g}: percent?",
                                   table.full("relative_error"), out.relative_error));
    }
    out.may_be_empty = table.boolean_or("may_be_empty", false);
    if (out.is_change() && table.has("zero")) {
        out.zero = out.value(table.number("zero"));
        if (!out.zero)
            table.fail("zero", fmt::format("{} leaves nothing of the sample", table.full("zero")));
    }
    table.finish();
    return out;
}

}  // namespace

std::optional<double> LaboratoryColumn::value(double theirs) const {
    const double value = factor * theirs;
    if (!engineering) return value;
    if (!(value > -1.0)) return std::nullopt;
    return std::log1p(value);
}

double LaboratoryColumn::theirs(double value) const {
    return (engineering ? std::expm1(value) : value) / factor;
}

bool counts_from_start(const std::string& quantity, const std::string& unit) {
    return quantity == "pore_pressure" || (unit == "-" && quantity != "void_ratio");
}

double LaboratoryColumn::deviation(double value) const {
    return std::hypot(error, relative_error * value);
}

std::vector<LaboratoryColumn> read_columns(TomlTable table, const std::vector<std::string>& header,
                                           const Where& where, bool shear) {
    std::vector<LaboratoryColumn> out;
    std::vector<std::string> known;
    for (const Column& column : linear_columns()) {
        known.push_back(column.name);
        if (shear && column.name == "axial_strain") continue;
        if (auto inner = table.table_if(column.name))
            out.push_back(read_column(std::move(*inner), column.name, column.unit, header, where));
    }
    table.finish();
    if (out.empty())
        table.fail("", fmt::format("{}: no column is named: give at least what drives the test and "
                                   "one that is compared",
                                   table.full("")));
    if (std::none_of(out.begin(), out.end(),
                     [](const LaboratoryColumn& each) { return each.compared(); }))
        table.fail("", fmt::format("{}: none has an error: give error or relative_error to what is "
                                   "to be compared",
                                   table.full("")));
    return out;
}

}  // namespace cli
