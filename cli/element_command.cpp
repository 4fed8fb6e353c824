// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element_command.hpp"

#include <numeric>
#include <set>

#include <fmt/format.h>

#include "cli/case_file.hpp"
#include "cli/plot.hpp"
#include "cli/progress.hpp"
#include "cli/reference_table.hpp"
#include "element/csv.hpp"
#include "element/errors.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

fs::path in(const fs::path& folder, const std::string& name, const char* ending) {
    return folder / (name + ending);
}

std::vector<CaseFile> read_cases(const std::vector<fs::path>& paths) {
    std::vector<CaseFile> cases;
    std::set<std::string> names;
    for (const fs::path& path : paths) {
        cases.push_back(read_case_file(path));
        const std::string& name = cases.back().test.name;
        if (!names.insert(name).second)
            throw BadInput(fmt::format("{}: another case is called \"{}\" too, and would overwrite "
                                       "its files: set name",
                                       path.string(), name));
    }
    return cases;
}

element::Run compute(const CaseFile& file, const fs::path& path, const fs::path& csv) {
    Progress progress(file.test.name);
    element::Run run;
    try {
        run = element::run(file.test, std::ref(progress));
    } catch (const element::BadCase& error) {
        throw BadInput(fmt::format("{}: {}", path.string(), error.what()));
    }
    progress.finish();
    const double seconds = progress.seconds();
    element::write_csv(csv, file.test, run);
    int iterations = 0, evaluations = 0;
    for (const element::Row& row : run.rows) {
        iterations += row.iterations;
        evaluations += row.evaluations;
    }
    fmt::print("{}: {} increments, {} Newton iterations, {} evaluations of the rate, {} halvings, "
               "{:.3f} s\n",
               file.test.name, run.rows.size() - 1, iterations, evaluations, run.halvings, seconds);
    if (!run.failure.empty())
        fmt::print(stderr, "grit: {}: stopped early at {}\n", file.test.name, run.failure);
    return run;
}

// Pictures never fail a computation: what went wrong with them is said, and the data stay.
void draw(const ElementRequest& request, const std::vector<CaseFile>& cases) {
    std::vector<Curve> curves;
    std::string problem;
    std::vector<std::string> drawn;
    const auto add = [&](const std::string& name, const std::string& title,
                         const std::vector<Curve>& which) {
        if (!problem.empty()) return;
        problem = plot(request.out / name, title, which);
        if (problem.empty()) drawn.push_back(name);
    };
    for (const CaseFile& file : cases) {
        curves.push_back({in(request.out, file.test.name, ".csv"), file.reference.curve,
                          file.test.title, file.test.loading.change[0]});
        Curve alone = curves.back();
        alone.label = "computed";
        add(file.test.name, file.test.title, {alone});
    }
    if (cases.size() > 1) add("comparison", "Drained triaxial tests", curves);
    if (!problem.empty()) fmt::print(stderr, "grit: no picture: {}\n", problem);
    for (const std::string& name : drawn)
        fmt::print("picture: {} and .png\n", in(request.out, name, ".svg").string());
}

}  // namespace

ExitCode run_element_tests(const ElementRequest& request) {
    const std::vector<CaseFile> cases = read_cases(request.cases);
    std::error_code refused;
    fs::create_directories(request.out, refused);
    if (refused)
        throw BadInput(fmt::format("{}: cannot make this folder: {}", request.out.string(),
                                   refused.message()));
    std::vector<element::Run> runs;
    bool complete = true;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const fs::path csv = in(request.out, cases[i].test.name, ".csv");
        runs.push_back(compute(cases[i], request.cases[i], csv));
        complete = complete && runs.back().failure.empty();
    }
    for (const CaseFile& file : cases)
        fmt::print("data:    {}\n", in(request.out, file.test.name, ".csv").string());
    std::fflush(stdout);
    if (!request.no_plot) draw(request, cases);
    const Comparison comparison = compare(cases, runs);
    if (!comparison.text.empty()) fmt::print("\n{}", comparison.text);
    if (!comparison.within) fmt::print(stderr, "grit: a difference exceeds its limit\n");
    return complete && comparison.within ? ok : failed_computation;
}

}  // namespace cli
