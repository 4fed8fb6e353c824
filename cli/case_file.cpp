// SPDX-License-Identifier: BSD-3-Clause
#include "cli/case_file.hpp"

#include <cctype>

#include <fmt/format.h>

#include "cli/exit_code.hpp"
#include "cli/material_reader.hpp"
#include "cli/panels.hpp"
#include "cli/stage_reader.hpp"
#include "cli/table.hpp"
#include "element/errors.hpp"

namespace cli {
namespace {

// The name becomes part of file names.
void check_name(const TomlTable& table, const std::string& key, const std::string& name) {
    for (const char c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '.')
            table.fail(key, fmt::format("{}: a case may be named with letters, digits, _ - . only, "
                                        "got \"{}\"",
                                        key, name));
    if (name.empty() || name.front() == '.') table.fail(key, key + ": a case needs a name");
}

// The samples of a case: rows of a CSV and the column that names them; one empty row without.
struct Samples {
    std::vector<SampleRow> rows = {{}};
    std::string name_column;
};

Samples read_samples(TomlTable& root) {
    Samples out;
    std::optional<TomlTable> table = root.table_if("samples");
    if (!table) return out;
    const std::string name = table->string("table");
    std::vector<std::vector<std::string>> cells;
    try {
        cells = read_cells(table->folder() / name);
    } catch (const BadInput& error) {
        table->fail("table", fmt::format("{}: {}", table->full("table"), error.what()));
    }
    out.name_column = table->choice("name", cells.front());
    table->finish();
    out.rows.clear();
    for (std::size_t i = 1; i < cells.size(); ++i) {
        SampleRow row;
        for (std::size_t j = 0; j < cells.front().size(); ++j) row[cells.front()[j]] = cells[i][j];
        out.rows.push_back(std::move(row));
    }
    return out;
}

void read_numerics(TomlTable table, CaseFile& file) {
    file.options.tolerance = table.positive_or("tolerance", file.options.tolerance);
    if (!(file.options.tolerance >= 1e-12 && file.options.tolerance <= 0.1))
        table.fail("tolerance", fmt::format("{} must be in [1e-12, 0.1], got {:g}",
                                            table.full("tolerance"), file.options.tolerance));
    file.stress_tolerance = table.positive_or("stress_tolerance", file.stress_tolerance);
    file.iteration_limit = table.integer_or("iteration_limit", file.iteration_limit, 1, 1000);
    file.options.evaluation_limit =
        table.integer_or("evaluation_limit", file.options.evaluation_limit, 2, 1000000);
    table.finish();
}

void read_limits(TomlTable table, Limits& limits) {
    if (table.has("increments")) limits.increments = table.integer_or("increments", 0, 1, 10000000);
    if (table.has("milliseconds")) limits.milliseconds = table.positive_or("milliseconds", 1.0);
    table.finish();
}

std::vector<std::string> state_names_of(const CaseFile& file) {
    if (file.sand.empty()) return file.umat->state_names;
    return element::GritLaw(file.parameters, file.options).state_names();
}

void read_stages(TomlTable& root, CaseFile& file) {
    const std::vector<std::string> state_names = state_names_of(file);
    for (TomlTable& stage : root.tables_if("stage"))
        file.stages.push_back(read_stage(std::move(stage), state_names));
    if (file.stages.empty()) root.fail("stage", "stage is missing: a case needs a [[stage]]");
}

std::string default_picture(const CaseFile& file) {
    return picture_of(file.stages.back().test, file.stages.back().cyclic);
}

CaseFile read_case(const std::filesystem::path& path, TomlTable& root, const std::string& sample) {
    CaseFile out;
    out.path = path;
    out.options.tolerance = 1e-6;
    out.sample = sample;
    out.name = root.string_if("name").value_or(path.stem().string());
    check_name(root, "name", out.name);
    out.title = root.string_if("title").value_or(out.name);
    if (!sample.empty()) {
        check_name(root, "samples", sample);
        out.title = sample;
        out.name += "_" + sample;
    }
    if (std::optional<TomlTable> umat = root.table_if("umat")) read_umat(std::move(*umat), out);
    if (!out.umat || root.has("sand")) read_sand(root.table("sand"), out);
    if (auto numerics = root.table_if("numerics")) read_numerics(std::move(*numerics), out);
    read_start(root.table("start"), out);
    out.options.intergranular_strain = out.start.intergranular_strain != IntergranularStrain::off;
    read_stages(root, out);
    out.picture =
        root.has("picture") ? root.choice("picture", picture_names()) : default_picture(out);
    if (auto limits = root.table_if("limits")) read_limits(std::move(*limits), out.limits);
    if (auto reference = root.table_if("reference"))
        out.reference =
            read_reference(std::move(*reference), static_cast<int>(out.stages.size()), sample);
    root.finish();
    return out;
}

}  // namespace

std::vector<CaseFile> read_case_file(const std::filesystem::path& path) {
    TomlTable root = TomlTable::of_file(path);
    const Samples samples = read_samples(root);
    std::vector<CaseFile> out;
    for (const SampleRow& row : samples.rows) {
        if (!samples.name_column.empty()) root.take_columns_from(row);
        try {
            out.push_back(read_case(
                path, root, samples.name_column.empty() ? "" : row.at(samples.name_column)));
        } catch (const element::BadCase& error) {
            throw BadInput(fmt::format("{}: {}", path.string(), error.what()));
        }
    }
    return out;
}

}  // namespace cli
