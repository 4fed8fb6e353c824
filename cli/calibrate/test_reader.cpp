// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/test_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cli/calibrate/followed_steps.hpp"
#include "cli/calibrate/laboratory_column.hpp"
#include "cli/element/material_reader.hpp"
#include "cli/element/stage_reader.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/table/columns.hpp"
#include "cli/table/sheet.hpp"
#include "cli/table/workbook.hpp"
#include "element/check.hpp"
#include "element/errors.hpp"
#include "element/nearest.hpp"
#include "element/number.hpp"
#include "element/schedule.hpp"

namespace cli {
namespace {

using calibration::Experiment;
using element::Vector6;

constexpr double largest_stress = 1e6;  // kPa: beyond, somebody has mistaken the unit

struct Sheet {
    std::filesystem::path path;
    SheetFormat format;
    Cells cells;

    [[noreturn]] void fail(std::size_t row, const std::string& why) const {
        throw BadInput(place_in(path, format, cells.lines[row]) + ": " + why);
    }
};

// The laboratory's word for the test and what drives it.
struct Driver {
    const LaboratoryTest* test = nullptr;
    const Way* way = nullptr;
    std::string quantity;  // the column that says it
};

// Rows of one test as Grit sees them: a value per column, NaN where a cell is empty.
struct Rows {
    std::string name;
    std::vector<std::size_t> of_sheet;
    std::vector<std::vector<double>> values;
};

// What [[test]] says, the sheets apart.
struct TestTable {
    TomlTable& table;
    const TestDefaults& defaults;
    Sheet sheet;
    Driver driver;
    std::vector<LaboratoryColumn> columns;
    bool staged = false;  // stages come before the rows

    // As the sheet has it.
    const std::string& cell(const Rows& rows, std::size_t row, std::size_t column) const {
        return sheet.cells.rows[rows.of_sheet[row]][columns[column].place];
    }

    // Place among the columns.
    std::optional<std::size_t> find(const std::string& quantity) const {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i].quantity == quantity) return i;
        return std::nullopt;
    }
};

Sheet read_sheet_of(TomlTable& table, std::vector<std::filesystem::path>& inputs) {
    Sheet out;
    out.path = table.folder_of("file") / table.string("file");
    out.format.sheet = table.string_if("sheet").value_or("");
    out.format.header_line = table.integer_or("header_line", 0, 1, 1000000);
    out.format.first_line = table.integer_or("first_line", 0, 1, 1000000);
    out.format.last_line = table.integer_or("last_line", 0, 1, 1000000);
    const char* const stranger = is_workbook(out.path) ? "separator" : "sheet";
    if (table.has(stranger))
        table.fail(stranger, fmt::format("{} is said of {} alone", table.full(stranger),
                                         is_workbook(out.path) ? "a CSV" : "a workbook, .xlsx"));
    if (table.has("separator")) {
        const std::string word = table.choice("separator", {",", ";", "tab"});
        out.format.separator = word == "tab" ? '\t' : word.front();
    }
    out.format.decimal_comma = table.boolean_or("decimal_comma", false);
    const bool commas = out.format.separator == 0 || out.format.separator == ',';
    if (out.format.decimal_comma && commas && !is_workbook(out.path))
        table.fail("decimal_comma", fmt::format("{} needs another separator than \",\"",
                                                table.full("decimal_comma")));
    try {
        out.cells = read_sheet(out.path, out.format);
    } catch (const BadInput& error) {
        table.fail("file", fmt::format("{}: {}", table.full("file"), error.what()));
    }
    if (std::find(inputs.begin(), inputs.end(), out.path) == inputs.end())
        inputs.push_back(out.path);
    return out;
}

Driver read_driver(TomlTable& table) {
    Driver out;
    std::vector<std::string> names;
    for (const LaboratoryTest& each : laboratory_tests()) names.push_back(each.name);
    const std::string name = table.choice("test", names);
    for (const LaboratoryTest& each : laboratory_tests())
        if (each.name == name) out.test = &each;
    std::vector<std::string> ways;
    for (const Way& each : out.test->ways) ways.push_back(each.key);
    // An oedometer is loaded by weights, other machines move.
    const bool weights = name == "oedometer" || name == "k0_consolidation";
    const std::string key =
        table.has("driven_by") ? table.choice("driven_by", ways) : ways[weights ? 1 : 0];
    for (const Way& each : out.test->ways)
        if (each.key == key) out.way = &each;
    out.quantity = key == "pressure_kPa"       ? "p"
                   : key == "axial_stress_kPa" ? "stress_11"
                   : key == "shear_stress_kPa" ? "shear_stress"
                                               : key;
    return out;
}

double read_cell(const TestTable& test, std::size_t row, const LaboratoryColumn& column) {
    const Sheet& sheet = test.sheet;
    const std::string& cell = sheet.cells.rows[row][column.place];
    if (cell.empty()) {
        if (column.may_be_empty) return NAN;
        sheet.fail(row, fmt::format("column {} is empty: fill it, or set may_be_empty of {}",
                                    column.name, column.quantity));
    }
    std::optional<double> theirs = element::number_of(cell);
    // A percentage of a workbook, as it is shown there.
    if (!theirs && column.unit == "-" && cell.ends_with(" %"))
        if ((theirs = element::number_of(cell.substr(0, cell.size() - 2))))
            *theirs *= 0.01 / std::abs(column.factor);
    if (!theirs)
        sheet.fail(
            row, fmt::format("column {} has \"{}\" where a number is needed{}", column.name, cell,
                             cell.find(',') != std::string::npos ? ": decimal_comma = true?" : ""));
    const std::optional<double> value = column.value(*theirs);
    const double size = std::abs(*theirs * column.factor);
    if (column.unit == "-" && column.quantity != "void_ratio" && !(value && size <= 1.0))
        sheet.fail(row,
                   fmt::format("column {}: a strain of {:g} is {}: unit = \"percent\"?",
                               column.name, size, size > 1.0 ? "beyond 1" : "all of the sample"));
    if (column.quantity == "void_ratio" && !(*value > 0.05 && *value < 5.0))
        sheet.fail(row,
                   fmt::format("column {}: a void ratio must be in (0.05, 5), got {:g}{}",
                               column.name, *value, *value > 5.0 ? ": unit = \"percent\"?" : ""));
    if (column.unit == "kPa" && !(size <= largest_stress))
        sheet.fail(row, fmt::format("column {}: {:g} kPa is more than sand bears: unit = \"Pa\"?",
                                    column.name, size));
    if (column.quantity.starts_with("stress_11") && *value > 0.0)
        sheet.fail(row,
                   fmt::format("column {}: {:g} would pull: compression = \"{}\"?", column.name,
                               *theirs, column.factor < 0.0 ? "negative" : "positive"));
    return *value;
}

// Rows of the whole sheet, or by the names in a column.
std::vector<Rows> split(TestTable& test, const std::string& name) {
    TomlTable& table = test.table;
    const std::vector<std::string>& header = test.sheet.cells.rows.front();
    std::vector<Rows> out;
    std::optional<std::size_t> by;
    if (table.has("split_by")) {
        const std::string word = table.choice("split_by", header);
        by = static_cast<std::size_t>(std::find(header.begin(), header.end(), word) -
                                      header.begin());
    }
    std::map<std::string, std::size_t> places;
    for (std::size_t row = 1; row < test.sheet.cells.rows.size(); ++row) {
        const std::string& which = by ? test.sheet.cells.rows[row][*by] : name;
        if (which.empty())
            test.sheet.fail(row,
                            fmt::format("column {} is empty: whose row is this?", header[*by]));
        const auto [at, is_new] = places.try_emplace(which, out.size());
        if (is_new) out.push_back(Rows{which, {}, {}});
        out[at->second].of_sheet.push_back(row);
    }
    return out;
}

// Tests of a sheet that take part; fitted or held out.
std::vector<std::pair<Rows, bool>> choose(TestTable& test, std::vector<Rows> all) {
    TomlTable& table = test.table;
    std::vector<std::string> known;
    for (const Rows& each : all) known.push_back(each.name);
    std::vector<std::pair<Rows, bool>> out;
    std::set<std::string> taken;
    for (const char* key : {"fit", "check"})
        for (const std::string& name : table.strings_or_none(key)) {
            const auto at = std::find(known.begin(), known.end(), name);
            if (at == known.end())
                table.fail(key, fmt::format("{}: the sheet has no test \"{}\"{}", table.full(key),
                                            name, element::suggestion(name, known)));
            if (!taken.insert(name).second)
                table.fail(key, fmt::format("{}: {} is named twice", table.full(key), name));
            out.emplace_back(all[static_cast<std::size_t>(at - known.begin())], key[0] == 'f');
        }
    if (table.has("fit") || table.has("check")) return out;
    for (Rows& each : all) out.emplace_back(std::move(each), true);
    return out;
}

// Which rows of a test are used.
struct Selection {
    bool first_loading = false;
    double least = 0.0,
           most = INFINITY;  // of what drives the test, as large as it is in the sheet's unit
    int at_most = 0;

    // A value of what drives the test.
    bool takes(double value, const LaboratoryColumn& column) const {
        const double size = std::abs(column.theirs(value));
        return size >= least * (1.0 - 1e-12) && size <= most * (1.0 + 1e-12);
    }
    void apply(Rows& rows, std::size_t driver, const LaboratoryColumn& column) const;
};

Selection read_selection(TomlTable& table) {
    Selection out;
    out.first_loading = table.boolean_or("first_loading", false);
    out.least = table.has("from") ? table.number("from") : 0.0;
    out.most = table.has("to") ? table.positive_or("to", 1.0) : INFINITY;
    out.at_most = table.integer_or("rows_at_most", 0, 2, 1000000);
    return out;
}

void keep(Rows& rows, const std::vector<std::size_t>& which) {
    Rows out{rows.name, {}, {}};
    for (const std::size_t i : which) {
        out.of_sheet.push_back(rows.of_sheet[i]);
        out.values.push_back(rows.values[i]);
    }
    rows = std::move(out);
}

void Selection::apply(Rows& rows, std::size_t driver, const LaboratoryColumn& column) const {
    std::vector<std::size_t> which;
    double direction = 0.0, before = NAN;
    for (std::size_t i = 0; i < rows.values.size(); ++i) {
        const double value = rows.values[i][driver];
        if (std::isnan(value)) continue;
        const double last = std::exchange(before, value);
        if (first_loading && !std::isnan(last)) {
            const double change = value - last;
            if (direction == 0.0) direction = change;
            if (change * direction < 0.0) break;
            if (change == 0.0) continue;  // at rest, as where the load turns
        }
        if (takes(value, column)) which.push_back(i);
    }
    if (at_most > 0 && which.size() > static_cast<std::size_t>(at_most)) {
        std::vector<std::size_t> fewer;
        const double stride =
            static_cast<double>(which.size() - 1) / static_cast<double>(at_most - 1);
        for (int i = 0; i < at_most; ++i)
            fewer.push_back(which[static_cast<std::size_t>(std::lround(i * stride))]);
        which = std::move(fewer);
    }
    keep(rows, which);
}

// Rows that first_loading leaves out, and that go on from where it ended; several tests below each other.
std::vector<std::string> doubts_about(const TestTable& test, const Rows& all, const Rows& used,
                                      std::size_t driver, const Selection& selection) {
    std::vector<std::string> out;
    const std::string& name = test.columns[driver].name;
    const auto size = [&](const Rows& rows, std::size_t i) {
        return std::abs(rows.values[i][driver]);
    };
    double largest = 0.0, before = 0.0;
    for (std::size_t i = 0; i < used.values.size(); ++i) largest = std::max(largest, size(used, i));
    const auto last = std::find(all.of_sheet.begin(), all.of_sheet.end(), used.of_sheet.back());
    const auto after = static_cast<std::size_t>(last - all.of_sheet.begin()) + 1;
    for (std::size_t i = after; selection.first_loading && i < all.values.size(); ++i)
        if (size(all, i) > 1.05 * largest &&
            selection.takes(all.values[i][driver], test.columns[driver])) {
            out.push_back(fmt::format(
                "test {}: first_loading ends where {} turns back after {}, and it is {} later: "
                "are rows out of order?",
                all.name, name, test.cell(used, used.values.size() - 1, driver),
                test.cell(all, i, driver)));
            break;
        }
    const double first = all.values.front()[driver];
    for (std::size_t i = 1; i + 1 < all.values.size(); ++i) {
        const double now = std::abs(all.values[i][driver] - first);
        if (before > 0.0 && now < 1e-3 * before &&
            std::abs(all.values[i - 1][driver] - first) == before) {
            out.push_back(fmt::format(
                "test {}: {} goes back from {} to {} in one row: are these several tests "
                "(split_by)?",
                all.name, name, test.cell(all, i - 1, driver), test.cell(all, i, driver)));
            break;
        }
        before = std::max(before, now);
    }
    return out;
}

// Where a sample that is pressed swells, or one that is shortened bears less, a sign is wrong.
void check_signs(const TestTable& test, const Rows& rows) {
    const auto changes = [&](const char* of, const char* with, double sign) {
        const auto a = test.find(of), b = test.find(with);
        if (!a || !b) return;
        const std::vector<std::vector<double>>& values = rows.values;
        double largest = 0.0;
        for (const auto& row : values)
            largest = std::max(largest, std::abs(row[*a] - values[0][*a]));
        for (std::size_t i = 1; i < values.size(); ++i) {
            const double x = values[i][*a] - values[0][*a], y = values[i][*b] - values[0][*b];
            if (!(std::abs(x) >= 0.2 * largest) || std::isnan(y)) continue;
            if (sign * x * y < 0.0)
                test.sheet.fail(
                    rows.of_sheet[i],
                    fmt::format("column {} goes from {} to {}, while {} goes from {} to {}: is the "
                                "sign of one of them wrong?",
                                test.columns[*a].name, test.cell(rows, 0, *a),
                                test.cell(rows, i, *a), test.columns[*b].name,
                                test.cell(rows, 0, *b), test.cell(rows, i, *b)));
            return;
        }
    };
    const std::string& kind = test.driver.test->name;
    if (kind.starts_with("triaxial")) changes("axial_deviator", "axial_strain", -1.0);
    if (kind == "oedometer" || kind == "k0_consolidation") {
        changes("stress_11", "void_ratio", 1.0);
        changes("stress_11", "axial_strain", 1.0);
    }
    if (kind == "isotropic") {
        changes("p", "void_ratio", -1.0);
        changes("p", "volumetric_strain", -1.0);
    }
}

double first_of(const TestTable& test, const Rows& rows, std::size_t column) {
    if (test.staged)
        test.table.fail(
            "stage", fmt::format("{}.start: stages come before the first row, which does not tell "
                                 "what the sample starts with: say all of it",
                                 test.table.full("")));
    const double value = rows.values.front()[column];
    if (std::isnan(value))
        test.sheet.fail(
            rows.of_sheet.front(),
            fmt::format("column {} is empty, and the test starts here", test.columns[column].name));
    return value;
}

double first_of(const TestTable& test, const Rows& rows, const char* quantity, const char* key) {
    if (const auto column = test.find(quantity)) return first_of(test, rows, *column);
    test.table.fail("start",
                    fmt::format("{}.start: give {}, or name the column of {} in {}.columns: "
                                "its first row that is used counts",
                                test.table.full(""), key, quantity, test.table.full("")));
}

// Of an isotropic start: p, or the pressure in the cell.
double first_pressure(const TestTable& test, const Rows& rows) {
    for (const char* cell : {"stress_33", "stress_22"})
        if (const auto column = test.find(cell); column && !test.find("p"))
            return -first_of(test, rows, *column);
    return first_of(test, rows, "p", "pressure_kPa");
}

// A seat of the piston apart, what starts isotropic has no deviator.
void refuse_a_start_in_shear(const TestTable& test, const Rows& rows, double pressure) {
    constexpr double most = 0.2;
    const auto column = test.find("axial_deviator");
    if (!column || !(pressure > 0.0)) return;
    const double q = rows.values.front()[*column];
    if (!(std::abs(q) > most * pressure)) return;
    test.sheet.fail(rows.of_sheet.front(),
                    fmt::format("the test starts here with a deviator of {:g} kPa at a pressure of "
                                "{:g} kPa: begin where there is none, or say in start the stresses",
                                q, pressure));
}

// own: what is said of this test of the sheet alone.
void read_start_of_test(const TestTable& test, const Rows& rows, std::optional<TomlTable> own,
                        Experiment& out) {
    auto given = own ? std::move(own) : test.table.table_if("start");
    const bool oedometric =
        test.driver.test->name == "oedometer" || test.driver.test->name == "k0_consolidation";
    element::Start& start = out.start;
    if (oedometric) start.direction = -Vector6::Unit(0);
    if (given && (given->has("pressure_kPa") || given->has("stress_kPa"))) {
        start.stress = read_start_stress(*given);
    } else if (given && given->has("axial_stress_at_rest_kPa")) {
        start.stress[0] = -given->positive_or("axial_stress_at_rest_kPa", 1.0);
        out.at_rest = true;
    } else if (oedometric) {
        start.stress[0] = first_of(test, rows, "stress_11", "axial_stress_at_rest_kPa");
        out.at_rest = true;
    } else {
        start.stress = -first_pressure(test, rows) * element::unit_tensor();
        refuse_a_start_in_shear(test, rows, -start.stress[0]);
    }
    if (!(start.stress[0] < 0.0))
        test.sheet.fail(rows.of_sheet.front(),
                        fmt::format("a test starts here at {:g} kPa, where nothing presses: begin "
                                    "later with from, or say in start what it starts with",
                                    -start.stress[0]));
    const auto e = given ? given->one_of_if({"void_ratio", "void_ratio_at_zero_pressure"})
                         : std::optional<std::string>();
    start.void_ratio =
        e ? given->positive_or(*e, 1.0) : first_of(test, rows, "void_ratio", "void_ratio");
    if (e && !(start.void_ratio > 0.05 && start.void_ratio < 5.0))
        given->fail(*e, fmt::format("{} must be in (0.05, 5), got {:g}{}", given->full(*e),
                                    start.void_ratio, start.void_ratio > 5.0 ? ": percent?" : ""));
    out.at_zero_pressure = e == "void_ratio_at_zero_pressure";
    if (given && given->has("void_ratio_error"))
        out.void_ratio_error = given->positive_or("void_ratio_error", 1.0);
    if (given) {
        read_intergranular_start(*given, test.defaults.parameters, start);
        given->finish();
    } else {
        start.intergranular_strain = element::usual_intergranular_strain(test.defaults.parameters);
    }
    out.options.intergranular_strain =
        start.intergranular_strain != element::IntergranularStrain::off;
}

// What drives the test, a value per row.
std::vector<double> driving(const TestTable& test, const Rows& rows, std::size_t column) {
    std::vector<double> out;
    const LaboratoryColumn& of = test.columns[column];
    for (std::size_t i = 0; i < rows.values.size(); ++i) {
        const double value = rows.values[i][column];
        if (std::isnan(value))
            test.sheet.fail(rows.of_sheet[i],
                            fmt::format("column {} is empty, and it drives the test", of.name));
        out.push_back(value);
    }
    return out;
}

std::size_t driving_column(const TestTable& test) {
    // Machines prescribe total stress, columns of stress are effective: where pore pressure rises, the deviator tells.
    const bool undrained = test.driver.test->name.ends_with("undrained");
    const bool axial = test.driver.quantity == "stress_11";
    if (undrained && axial && !test.find("axial_deviator"))
        test.table.fail(
            "columns",
            fmt::format("{}: an undrained test that is driven by axial stress needs the column of "
                        "axial_deviator: stress_11 is effective",
                        test.table.full("columns")));
    if (const auto at = test.find(test.driver.quantity); at && !(undrained && axial)) return *at;
    if (axial)
        if (const auto at = test.find("axial_deviator")) return *at;
    test.table.fail("columns", fmt::format("{}: the test is driven by {}: name the column of {}",
                                           test.table.full("columns"), test.driver.way->key,
                                           test.driver.quantity));
}

void read_readings(const TestTable& test, const Rows& rows, std::size_t driver, Experiment& out) {
    for (std::size_t c = 0; c < test.columns.size(); ++c) {
        const LaboratoryColumn& column = test.columns[c];
        if (!column.compared() || c == driver) continue;
        calibration::Channel channel;
        channel.name = column.quantity;
        channel.unit = column.unit;
        channel.quantity = *linear_quantity(column.quantity, test.driver.test->shear);
        channel.change = column.is_change();
        const double first = channel.change ? column.zero.value_or(rows.values.front()[c]) : 0.0;
        if (std::isnan(first))
            test.sheet.fail(
                rows.of_sheet.front(),
                fmt::format("column {} is empty, and its changes count from here: give zero of {}",
                            column.name, column.quantity));
        const int number = static_cast<int>(out.channels.size());
        out.channels.push_back(std::move(channel));
        for (std::size_t i = 1; i < rows.values.size(); ++i) {
            const double value = rows.values[i][c] - first;
            if (!std::isnan(value))
                out.readings.push_back(
                    {static_cast<int>(i), number, value, column.deviation(value)});
        }
    }
    for (std::size_t i = 0; i < out.readings.size(); ++i)
        if (!(out.readings[i].error > 0.0)) {
            const calibration::Channel& channel =
                out.channels[static_cast<std::size_t>(out.readings[i].channel)];
            test.sheet.fail(rows.of_sheet[static_cast<std::size_t>(out.readings[i].row)],
                            fmt::format("{} is 0, and a relative_error of it is none: give error "
                                        "besides",
                                        channel.name));
        }
    if (out.readings.empty())
        test.table.fail("columns",
                        fmt::format("{}: what drives the test, {}, is prescribed: give another "
                                    "column an error",
                                    test.table.full("columns"), test.driver.quantity));
}

// Stages before the rows are followed.
element::Program prepare(TestTable& test) {
    element::Program out;
    const Columns columns(nullptr, {});  // what depends on the sand itself is not known yet
    StageContext context{columns};
    for (TomlTable& stage : test.table.tables_if("stage")) {
        CaseStage read = read_stage(std::move(stage), context);
        out.insert(out.end(), read.program.begin(), read.program.end());
    }
    return out;
}

// Where a sheet has the deviator in place of the axial stress, a row of its own prescribes it, whatever the lateral
// stress is and becomes.
const Vector6& deviator() {
    static const Vector6 weights = linear_quantity("axial_deviator", false)->total_stress;
    return weights;
}

void prescribe_what_drives(const Experiment& of, element::Restrictions& rows) {
    if (of.driver == "axial_deviator") rows.stress.row(0) = deviator();
}

// Stages before may end at another stress than that of the first row.
element::Step to_first_row(const TestTable& test, const Experiment& of, double value) {
    const Way& way = *test.driver.way;
    element::Step out = way.step(way.sign * value);
    element::Linear& kind = std::get<element::Linear>(out.kind);
    for (const int row : way.reached) kind.absolute[static_cast<std::size_t>(row)] = true;
    prescribe_what_drives(of, kind.rows);
    return out;
}

// The start that is said is not the stress of the first row.
bool starts_elsewhere(const Experiment& of, double first) {
    const Vector6& stress = of.start.stress;
    const double start = of.driver == "stress_11"        ? stress[0]
                         : of.driver == "axial_deviator" ? deviator().dot(stress)
                         : of.driver == "p"              ? -stress.head<3>().sum() / 3.0
                                                         : first;
    return std::abs(start - first) > 1e-9 * std::abs(first);
}

// What [[test]] says of all its tests.
struct Treatment {
    Selection selection;
    element::Program before;
    std::optional<TomlTable> starts;  // by the name of a test
};

void make(TestTable& test, Rows rows, bool fitted, Treatment& treatment, LaboratoryTests& made) {
    const Selection& selection = treatment.selection;
    const element::Program& before = treatment.before;
    Experiment out;
    out.name = rows.name;
    out.kind = test.driver.test->name;
    out.fitted = fitted;
    out.options = test.defaults.options;
    out.settings = test.defaults.settings;
    for (const std::size_t row : rows.of_sheet) {
        std::vector<double>& values = rows.values.emplace_back();
        for (const LaboratoryColumn& column : test.columns)
            values.push_back(read_cell(test, row, column));
    }
    const std::size_t driver = driving_column(test);
    if (test.columns[driver].zero)
        test.table.fail(
            "columns",
            fmt::format("{}.{}.zero: it drives the test, which counts from its first row",
                        test.table.full("columns"), test.columns[driver].quantity));
    const Rows all = rows;
    selection.apply(rows, driver, test.columns[driver]);
    if (rows.values.size() < 2)
        test.table.fail("", fmt::format("{}: of test {}, {} row{} left: two are needed",
                                        test.table.full(""), rows.name, rows.values.size(),
                                        rows.values.size() == 1 ? " is" : "s are"));
    check_signs(test, rows);
    for (std::string& each : doubts_about(test, all, rows, driver, selection))
        made.doubts.push_back(std::move(each));
    read_start_of_test(
        test, rows, treatment.starts ? treatment.starts->table_if(rows.name) : std::nullopt, out);
    std::vector<double> values = driving(test, rows, driver);
    out.driver = test.columns[driver].quantity;
    if (test.driver.way->strain() &&
        std::all_of(values.begin(), values.end(), [&](double x) { return x == values[0]; }))
        test.sheet.fail(rows.of_sheet.front(),
                        fmt::format("column {} does not change, and it drives the test",
                                    test.columns[driver].name));
    read_readings(test, rows, driver, out);
    out.driven = values;
    out.program = before;
    if (!test.driver.way->strain() && (!before.empty() || starts_elsewhere(out, values.front())))
        out.program.push_back(to_first_row(test, out, values.front()));
    Followed followed = follow(*test.driver.way, values, test.defaults.resolution);
    prescribe_what_drives(out, std::get<element::Imported>(followed.step.kind).rows);
    out.program.push_back(std::move(followed.step));
    out.records = std::move(followed.increments);
    try {
        element::check_program(out.program);
    } catch (const element::BadCase& error) {
        test.table.fail(
            "", fmt::format("{}: test {}: {}", test.table.full(""), out.name, error.what()));
    }
    const Sheet& sheet = test.sheet;
    made.sources.push_back(
        fmt::format("{}{}, {} of {} rows", sheet.path.filename().string(),
                    sheet.format.sheet.empty() ? "" : ", sheet " + sheet.format.sheet,
                    rows.values.size(), all.values.size()));
    made.experiments.push_back(std::move(out));
}

}  // namespace

LaboratoryTests read_tests(TomlTable table, const TestDefaults& defaults,
                           std::vector<std::filesystem::path>& inputs) {
    const std::string name = table.string("name");
    const Driver driver = read_driver(table);
    TestTable test{table, defaults, read_sheet_of(table, inputs), driver, {}};
    const auto where = [&sheet = test.sheet](const std::string& column) {
        if (const auto line = line_with(sheet.path, sheet.format, column))
            return fmt::format("; line {0} has it: header_line = {0}", *line);
        if (!is_workbook(sheet.path) || !sheet.format.sheet.empty()) return std::string();
        return fmt::format("; the first sheet was read of: {}",
                           fmt::join(read_workbook(sheet.path, "").sheets, ", "));
    };
    test.columns = read_columns(table.table("columns"), test.sheet.cells.rows.front(), where,
                                driver.test->shear);
    Treatment treatment{read_selection(table), prepare(test), table.table_if("starts")};
    test.staged = !treatment.before.empty();
    const double independent_readings =
        table.has("independent_readings") ? table.positive_or("independent_readings", 1.0) : 0.0;
    LaboratoryTests out;
    for (auto& [rows, fitted] : choose(test, split(test, name))) {
        make(test, std::move(rows), fitted, treatment, out);
        out.experiments.back().independent = independent_readings;
    }
    if (treatment.starts) treatment.starts->finish();
    table.finish();
    return out;
}

}  // namespace cli
