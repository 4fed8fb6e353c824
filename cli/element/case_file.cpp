// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/case_file.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "cli/element/material_reader.hpp"
#include "cli/element/numerics_reader.hpp"
#include "cli/plot/panels.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/process/version.hpp"
#include "cli/table/table.hpp"
#include "element/check.hpp"
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
    bool given = false;
    std::filesystem::path table;
};

Samples read_samples(TomlTable& root) {
    Samples out;
    std::optional<TomlTable> table = root.table_if("samples");
    if (!table) return out;
    const std::string name = table->string("table");
    out.given = true;
    out.table = table->folder_of("table") / name;
    Cells cells;
    try {
        cells = read_cells(out.table);
    } catch (const BadInput& error) {
        table->fail("table", fmt::format("{}: {}", table->full("table"), error.what()));
    }
    const std::vector<std::string>& head = cells.rows.front();
    const std::string name_column = table->choice("name", head);
    table->finish();
    out.rows.clear();
    for (std::size_t i = 1; i < cells.rows.size(); ++i) {
        SampleRow row;
        for (std::size_t j = 0; j < head.size(); ++j) row.cells[head[j]] = cells.rows[i][j];
        row.name = row.cells.at(name_column);
        out.rows.push_back(std::move(row));
    }
    return out;
}

void read_limits(TomlTable table, Limits& limits) {
    if (table.has("increments")) limits.increments = table.integer_or("increments", 0, 1, 10000000);
    if (table.has("milliseconds")) limits.milliseconds = table.positive_or("milliseconds", 1.0);
    table.finish();
}

// --umat, or a library that the case names; otherwise the law is Grit's own.
void choose_law(TomlTable& root, CaseFile& file, const UmatChoice& umat) {
    if (!umat.library.empty() && file.umat && !umat.layout.empty())
        root.fail("umat", "umat: PROPS and STATEV are given here, --layout does not apply");
    if (umat.library.empty() && file.umat && file.umat->library.empty()) {
        if (file.sand.empty())
            root.fail("umat", "umat.library is missing: name it, or give --umat FILE");
        file.umat.reset();
    }
    try {
        if (!umat.library.empty()) {
            if (!file.umat) fill_umat(file, umat.layout == "radian");
            file.umat->library = umat.library;
        }
        make_material(file);
    } catch (const element::BadCase& error) {
        root.fail(file.umat && root.has("umat") ? "umat" : "start", error.what());
    }
}

void read_stages(TomlTable& root, CaseFile& file) {
    const Columns columns(file.own_law, file.law->state_names());
    StageContext context{columns};
    double increments = 0.0;
    for (TomlTable& stage : root.tables_if("stage")) {
        file.stages.push_back(read_stage(std::move(stage), context));
        try {
            element::check_program(file.stages.back().program);
        } catch (const element::BadCase& error) {
            root.fail("stage", fmt::format("stage[{}]: {}", file.stages.size(), error.what()));
        }
        increments += static_cast<double>(element::count_increments(file.stages.back().program));
    }
    if (file.stages.empty()) root.fail("stage", "stage is missing: a case needs a [[stage]]");
    if (increments > static_cast<double>(element::run_limit))
        root.fail("stage", fmt::format("a run has at most {} increments, got {:g}",
                                       element::run_limit, increments));
}

// Of the last stage that does anything but wait.
std::string default_picture(const CaseFile& file) {
    const auto waits = [](const CaseStage& stage) {
        return stage.test == "rest" || stage.test == "creep" || stage.test == "drain";
    };
    const auto last = std::find_if_not(file.stages.rbegin(), file.stages.rend(), waits);
    const CaseStage& stage = last == file.stages.rend() ? file.stages.back() : *last;
    return picture_of(stage.test, stage.cyclic);
}

void read_picture(TomlTable& root, CaseFile& file) {
    file.picture =
        root.has("picture") ? root.choice("picture", picture_names()) : default_picture(file);
    const bool cycles = std::any_of(file.stages.begin(), file.stages.end(),
                                    [](const CaseStage& stage) { return stage.cyclic; });
    if (shows_cycles(file.picture) && !cycles)
        root.fail("picture",
                  fmt::format("picture: \"{}\" shows cycles, and no stage has any", file.picture));
}

CaseFile read_case(const std::filesystem::path& path, TomlTable& root, const std::string& sample,
                   const UmatChoice& choice, const std::filesystem::path& sand) {
    root.refuse_case_of("grit mpm");
    CaseFile out;
    out.path = path;
    out.inputs = {path};
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
    if (out.umat && !sand.empty() && !root.has("sand"))
        root.fail("umat", "--sand: this case has the PROPS of a UMAT and no sand");
    if (!out.umat && !sand.empty() && !root.has("sand")) take_sand(out, sand);
    else if (!out.umat || root.has("sand")) read_sand(root.table("sand"), out, sand);
    if (auto numerics = root.table_if("numerics")) {
        read_numerics(*numerics, out.options, out.settings);
        numerics->finish();
    }
    read_start(root.table("start"), out);
    choose_law(root, out, choice);
    if (out.umat) out.inputs.push_back(out.umat->library);
    read_stages(root, out);
    read_picture(root, out);
    if (auto limits = root.table_if("limits")) read_limits(std::move(*limits), out.limits);
    if (auto reference = root.table_if("reference"))
        out.reference =
            read_reference(std::move(*reference), static_cast<int>(out.stages.size()), sample);
    if (!out.reference.curve_file.empty()) out.inputs.push_back(out.reference.curve_file);
    root.finish();
    return out;
}

}  // namespace

std::vector<std::string> CaseFile::heading() const {
    std::vector<std::string> out{made_by_grit("case " + name, title)};
    if (!changes.empty()) out.push_back(changes);
    return out;
}

std::vector<CaseFile> read_case_file(const std::filesystem::path& path, const UmatChoice& umat,
                                     const std::filesystem::path& sand,
                                     const std::vector<CaseSetting>& settings) {
    std::vector<std::filesystem::path> inputs;
    TomlTable root = TomlTable::of_file(path, &inputs, settings);
    const Samples samples = read_samples(root);
    std::vector<std::string> options;
    if (!sand.empty()) options.push_back(fmt::format("--sand {}", sand.string()));
    if (!umat.layout.empty()) options.push_back(fmt::format("--layout {}", umat.layout));
    std::vector<CaseFile> out;
    for (const SampleRow& row : samples.rows) {
        if (samples.given) root.take_columns_from(row);
        out.push_back(read_case(path, root, row.name, umat, sand));
        CaseFile& file = out.back();
        file.changes = words_of(settings, options);
        file.inputs.insert(file.inputs.end(), inputs.begin() + 1, inputs.end());
        if (samples.given) file.inputs.push_back(samples.table);
    }
    return out;
}

}  // namespace cli
