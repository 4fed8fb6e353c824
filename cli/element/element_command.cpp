// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/element_command.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/element/case_run.hpp"
#include "cli/element/comparison.hpp"
#include "cli/element/curve_difference.hpp"
#include "cli/element/cycles.hpp"
#include "cli/element/element_pictures.hpp"
#include "cli/plot/panels.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"
#include "cli/table/table_file.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// What one run of a study has besides --set.
struct Variant {
    std::vector<CaseSetting> settings;
    std::string name, words;  // "0.6" of files, "void_ratio = 0.6" for people
};

// Without the blanks around them. Between brackets a comma belongs to a list.
std::vector<std::string> values_in(const std::string& text) {
    std::vector<std::string> out(1);
    int depth = 0;
    for (const char c : text) {
        depth += c == '[' ? 1 : c == ']' ? -1 : 0;
        if (c == ',' && depth == 0) out.emplace_back();
        else if (c != ' ' || !out.back().empty()) out.back() += c;
    }
    for (std::string& value : out) value.erase(value.find_last_not_of(' ') + 1);
    return out;
}

std::vector<Variant> variants_of(const std::vector<std::string>& varied,
                                 const std::vector<CaseSetting>& set) {
    std::vector<Variant> out(1);
    for (const std::string& each : varied) {
        const std::size_t equals = each.find('=');
        const std::string key = each.substr(0, equals);
        for (const std::vector<CaseSetting>& others : {set, out.front().settings})
            for (const CaseSetting& other : others)
                if (other.text.substr(0, other.text.find('=')) == key)
                    throw BadInput(fmt::format("--vary {}: {} {} says otherwise", each,
                                               other.option, other.text));
        const std::vector<std::string> values = equals == std::string::npos
                                                    ? std::vector<std::string>{}
                                                    : values_in(each.substr(equals + 1));
        if (key.empty() || values.size() < 2 ||
            std::any_of(values.begin(), values.end(),
                        [](const auto& value) { return value.empty(); }))
            throw BadInput(fmt::format("--vary needs KEY=VALUE,VALUE,..., got \"{}\"", each));
        std::vector<Variant> longer;
        for (const Variant& variant : out)
            for (const std::string& value : values) {
                Variant& next = longer.emplace_back(variant);
                next.settings.emplace_back(key + "=" + value, "--vary");
                next.name += "_" + value;
                next.words += fmt::format("{}{} = {}", next.words.empty() ? "" : ", ",
                                          key.substr(key.rfind('.') + 1), value);
            }
        out = std::move(longer);
    }
    for (Variant& variant : out)
        for (char& c : variant.name)
            if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-' && c != '+')
                c = '_';
    return out;
}

// What is wrong with a file may be so for what was given beside it alone, and is told with that.
std::vector<CaseFile> read_variant(const ElementRequest& request, const fs::path& path,
                                   const std::vector<CaseSetting>& settings) {
    try {
        return read_case_file(path, request.umat, request.sand, settings);
    } catch (const BadInput& error) {
        const std::string said = error.what();
        if (settings.empty() || (settings.size() == 1 && said.starts_with("--"))) throw;
        throw BadInput(fmt::format("{}, {}", said, words_of(settings, {})));
    }
}

std::vector<CaseFile> read_cases(const ElementRequest& request) {
    std::vector<CaseFile> cases;
    for (const fs::path& path : request.cases)
        for (const Variant& variant : variants_of(request.varied, request.settings)) {
            std::vector<CaseSetting> settings = request.settings;
            settings.insert(settings.end(), variant.settings.begin(), variant.settings.end());
            for (CaseFile& file : read_variant(request, path, settings)) {
                if (!variant.words.empty()) {
                    file.name += variant.name;
                    file.variant = variant.words;
                    file.reference = {};  // that of the case as it stands
                    file.limits = {};
                }
                cases.push_back(std::move(file));
            }
        }
    return cases;
}

fs::path csv_of(const ElementRequest& request, const CaseFile& file) {
    return request.out / (file.name + ".csv");
}

fs::path cycles_of(const ElementRequest& request, const CaseFile& file) {
    return request.out / (file.name + "_cycles.csv");
}

// Points of the case's reference, to be drawn with the result.
fs::path reference_of(const ElementRequest& request, const CaseFile& file) {
    return request.out / (file.name + "_reference.csv");
}

// Which runs belong together.
fs::path comparison_of(const ElementRequest& request) { return request.out / "comparison.csv"; }

fs::path references_of(const ElementRequest& request) { return request.out / "references.csv"; }

// By runs at one time in one folder the last one's stays: nobody is kept from writing it.
void write_rows(const fs::path& path, const std::vector<std::vector<std::string>>& rows,
                const std::string& comment = {}) {
    element::AtomicFile file(path);
    if (!comment.empty()) file.write(fmt::format("# {}\n", comment));
    for (const std::vector<std::string>& row : rows)
        file.write(fmt::format("{}\n", fmt::join(row, ",")));
    file.complete();
}

void write_reference(const fs::path& path, const CaseFile& file) {
    Table curve = file.reference.curve;
    std::erase_if(curve.columns, [](const Column& column) { return !column.problem.empty(); });
    write_table(path,
                {made_by_grit(fmt::format("{} beside case {}", reference_label(file), file.name),
                              file.reference.origin)},
                curve);
}

void write_comparison(const fs::path& path, const std::vector<CaseFile>& cases) {
    std::vector<std::vector<std::string>> rows = {{"run", "label"}};
    for (const CaseFile& file : cases) {
        std::string label = file.variant;  // a case as it stands is called by its title
        std::replace(label.begin(), label.end(), ',', ';');
        rows.push_back({file.name, label});
    }
    write_rows(path, rows, made_by_grit("comparison", title_of_comparison(cases)));
}

bool is_judged(const CaseFile& file) {
    return !file.reference.values.empty() || file.reference.curve_tolerance ||
           file.limits.increments || file.limits.milliseconds;
}

// Of an older run of the case that had cycles or a reference: they are none of this one's.
void remove_older(const fs::path& path) {
    std::string first;
    {
        std::ifstream file(path);
        std::getline(file, first);
    }
    std::error_code stays;
    if (first.starts_with("# Grit ")) fs::remove(path, stays);
}

Outputs outputs_of(const ElementRequest& request, const std::vector<CaseFile>& cases) {
    Outputs outputs;
    for (const CaseFile& file : cases) {
        const std::string who = fmt::format("case {} ({})", file.name, file.path.string());
        outputs.add(csv_of(request, file), who);
        if (std::any_of(file.stages.begin(), file.stages.end(),
                        [](const CaseStage& stage) { return stage.cyclic; }))
            outputs.add(cycles_of(request, file), who);
        if (file.reference.curve.rows() > 0) outputs.add(reference_of(request, file), who);
    }
    if (are_compared(cases)) outputs.add(comparison_of(request), "the comparison of cases");
    if (!request.no_plot)
        for (const auto& [picture, who] : pictures_of(cases))
            for (const char* ending : {".svg", ".png"})
                outputs.add(request.out / (picture + ending), who);
    // Runs at one time in one folder may all have verdicts: the file is not kept from others.
    Outputs with_verdicts = outputs;
    if (std::any_of(cases.begin(), cases.end(), is_judged))
        with_verdicts.add(references_of(request), "the verdicts on cases");
    for (const CaseFile& file : cases) with_verdicts.spare(file.inputs);
    return outputs;
}

std::vector<std::string> comments_of_cycles(const CaseFile& file) {
    std::vector<std::string> out = file.heading();
    const std::vector<std::string>& of_columns = Cycles::comments();
    out.insert(out.end(), of_columns.begin(), of_columns.end());
    return out;
}

std::set<std::string> columns_wanted(const ElementRequest& request, const CaseFile& file,
                                     const std::vector<CaseFile>& cases) {
    std::set<std::string> out;
    const auto want = [&](const std::vector<std::string>& names) {
        out.insert(names.begin(), names.end());
    };
    for (const ReferenceValue& value : file.reference.values) want({value.quantity, value.over});
    if (file.reference.curve_tolerance) want(compared_columns(file.reference.curve));
    if (!request.no_plot) want(columns_of_picture(file.picture));
    if (!request.no_plot && are_compared(cases)) want(columns_of_picture(cases.front().picture));
    return out;
}

void report(const ElementRequest& request, const CaseFile& file, const CaseResult& result) {
    if (!result.failure.empty()) warn("grit: {}: stopped early at {}\n", file.name, result.failure);
    if (request.quiet) return;
    say("{}: {} increments, {} Newton iterations, {} evaluations of the rate, {} halvings, "
        "{:.3f} s -> {}\n",
        file.name, result.increments, result.iterations, result.evaluations, result.halvings,
        result.seconds, csv_of(request, file).string());
    for (const std::string& exit : result.exits) say("{}: ended by {}\n", file.name, exit);
    for (const std::string& condition : result.never)
        say("{}: note: until never held: {}\n", file.name, condition);
    flush_words();
}

}  // namespace

ExitCode run_element_tests(const ElementRequest& request) {
    const std::vector<CaseFile> cases = read_cases(request);
    const auto lock = outputs_of(request, cases).lock();
    std::vector<CaseResult> results;
    bool complete = true;
    for (const CaseFile& file : cases) {
        results.push_back(
            run_case(file, {csv_of(request, file), columns_wanted(request, file, cases),
                            request.residuals}));
        const CaseResult& result = results.back();
        if (!result.cycles.columns.empty())
            write_table(cycles_of(request, file), comments_of_cycles(file), result.cycles);
        else remove_older(cycles_of(request, file));
        if (file.reference.curve.rows() > 0) write_reference(reference_of(request, file), file);
        else remove_older(reference_of(request, file));
        report(request, file, result);
        complete = complete && result.failure.empty();
    }
    if (are_compared(cases)) write_comparison(comparison_of(request), cases);
    else if (const CaseFile* other = stranger_among(cases); other && !request.quiet)
        say("no comparison: {} is for a picture of {}, and {} for one of {}\n", cases.front().name,
            cases.front().picture, other->name, other->picture);
    if (!request.no_plot && !draw_cases(request.out, cases, results, request.quiet))
        complete = false;
    const Comparison comparison = compare(cases, results);
    if (!comparison.text.empty()) {
        say("\n{}", comparison.text);
        write_rows(references_of(request), comparison.rows);
    }
    if (!comparison.within) warn("grit: a difference exceeds its limit\n");
    return complete && comparison.within ? ok : failed_computation;
}

}  // namespace cli
