// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element_command.hpp"

#include <set>

#include <fmt/format.h>

#include "cli/case_run.hpp"
#include "cli/comparison.hpp"
#include "cli/element_pictures.hpp"
#include "cli/material_reader.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// --umat, or a library that the case names; otherwise the law is Grit's own.
void choose_law(CaseFile& file, const fs::path& umat) {
    if (umat.empty()) {
        if (file.umat && !file.umat->library.empty()) return;
        if (file.sand.empty())
            throw BadInput(fmt::format("{}: umat.library is missing: name it, or give --umat FILE",
                                       file.path.string()));
        file.umat.reset();
        return;
    }
    if (!file.umat) fill_classic_umat(file);
    file.umat->library = umat;
}

std::vector<CaseFile> read_cases(const ElementRequest& request) {
    std::vector<CaseFile> cases;
    std::set<std::string> names;
    for (const fs::path& path : request.cases)
        for (CaseFile& file : read_case_file(path)) {
            choose_law(file, request.umat);
            if (!names.insert(file.name).second)
                throw BadInput(fmt::format("{}: another case is called \"{}\" too, and would "
                                           "overwrite its files: set name",
                                           path.string(), file.name));
            cases.push_back(std::move(file));
        }
    return cases;
}

void write(const ElementRequest& request, const CaseFile& file, const CaseResult& result) {
    const fs::path csv = request.out / (file.name + ".csv");
    write_table(csv, result.table);
    if (!result.cycles.columns.empty())
        write_table(request.out / (file.name + "_cycles.csv"), result.cycles);
    if (!result.failure.empty())
        fmt::print(stderr, "grit: {}: stopped early at {}\n", file.name, result.failure);
    if (request.quiet) return;
    fmt::print("{}: {} increments, {} Newton iterations, {} evaluations of the rate, {} halvings, "
               "{:.3f} s -> {}\n",
               file.name, result.increments, result.iterations, result.evaluations, result.halvings,
               result.seconds, csv.string());
    for (const std::string& exit : result.exits) fmt::print("{}: ended by {}\n", file.name, exit);
}

}  // namespace

ExitCode run_element_tests(const ElementRequest& request) {
    const std::vector<CaseFile> cases = read_cases(request);
    std::vector<CaseResult> results;
    for (const CaseFile& file : cases) results.push_back(run_case(file));
    std::error_code refused;
    fs::create_directories(request.out, refused);
    if (refused)
        throw BadInput(fmt::format("{}: cannot make this folder: {}", request.out.string(),
                                   refused.message()));
    bool complete = true;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        write(request, cases[i], results[i]);
        complete = complete && results[i].failure.empty();
    }
    std::fflush(stdout);
    if (!request.no_plot) draw_cases(request.out, cases, results, request.quiet);
    const Comparison comparison = compare(cases, results);
    if (!comparison.text.empty()) fmt::print("\n{}", comparison.text);
    if (!comparison.within) fmt::print(stderr, "grit: a difference exceeds its limit\n");
    return complete && comparison.within ? ok : failed_computation;
}

}  // namespace cli
