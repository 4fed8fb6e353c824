// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/element_pictures.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "cli/plot/panels.hpp"
#include "cli/plot/picture_maker.hpp"

namespace cli {
namespace {

Curve computed(const CaseFile& file, const CaseResult& result, int colour) {
    return {file.variant.empty() ? file.title : file.variant, result.table, result.cycles, false,
            colour};
}

bool has_reference(const CaseFile& file) { return file.reference.curve.rows() > 0; }

Curve reference(const CaseFile& file, const std::string& label) {
    return {label, file.reference.curve, {}, true, -1};
}

constexpr std::size_t most_sheets = 4;

std::string sheet_name(const CaseFile& file, std::size_t panel) {
    return fmt::format("{}_sheet{}", file.path.stem().string(), panel + 1);
}

std::vector<Curve> curves_of(const CaseFile& file, const CaseResult& result) {
    Curve run = computed(file, result, 0);
    run.label = "computed";
    std::vector<Curve> out = {run};
    if (has_reference(file)) out.push_back(reference(file, reference_label(file)));
    return out;
}

// Panel number of every sample's picture, on one sheet.
Picture sheet(const std::vector<const CaseFile*>& files,
              const std::vector<const CaseResult*>& results, std::size_t number) {
    Picture out;
    out.columns = 5;
    out.width = 300;
    out.height = 240;
    out.labels_above = true;
    out.title_in_markup = true;
    for (std::size_t i = 0; i < files.size(); ++i) {
        Panel panel = panel_of_curves(files[i]->picture, number, curves_of(*files[i], *results[i]));
        const element::Start& start = files[i]->start;
        panel.title = fmt::format("{}: p0 {:.0f} kPa, e {:.3f}", files[i]->sample,
                                  -start.stress.head<3>().sum() / 3.0, start.void_ratio);
        out.title = panel.y_label + " over " + panel.x_label;
        out.panels.push_back(std::move(panel));
    }
    return out;
}

}  // namespace

bool are_compared(const std::vector<CaseFile>& cases) {
    const bool samples = std::any_of(cases.begin(), cases.end(),
                                     [](const CaseFile& file) { return !file.sample.empty(); });
    return cases.size() > 1 && !samples && !stranger_among(cases);
}

const CaseFile* stranger_among(const std::vector<CaseFile>& cases) {
    for (const CaseFile& file : cases)
        if (!may_be_together(file.picture, cases.front().picture)) return &file;
    return nullptr;
}

std::string title_of_comparison(const std::vector<CaseFile>& cases) {
    const bool study = std::all_of(cases.begin(), cases.end(), [&](const CaseFile& file) {
        return !file.variant.empty() && file.path == cases.front().path;
    });
    return study ? cases.front().title : "Comparison";
}

std::string reference_label(const CaseFile& file) {
    return file.sample.empty() ? "reference" : "measured";
}

std::vector<std::pair<std::string, std::string>> pictures_of(const std::vector<CaseFile>& cases) {
    std::vector<std::pair<std::string, std::string>> out;
    std::set<std::filesystem::path> sampled;
    for (const CaseFile& file : cases) {
        const std::string who = fmt::format("case {} ({})", file.name, file.path.string());
        if (file.sample.empty()) out.emplace_back(file.name, who);
        else if (sampled.insert(file.path).second)
            for (std::size_t i = 0; i < std::min(most_sheets, panels_of(file.picture)); ++i)
                out.emplace_back(sheet_name(file, i), "the samples of " + file.path.string());
    }
    if (are_compared(cases)) out.emplace_back("comparison", "the comparison of cases");
    return out;
}

bool draw_cases(const std::filesystem::path& folder, const std::vector<CaseFile>& cases,
                const std::vector<CaseResult>& results, bool quiet) {
    PictureMaker maker(folder, quiet);
    std::vector<Curve> all;
    std::vector<std::string> names;  // of these
    std::map<std::filesystem::path, std::vector<std::size_t>> samples;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!cases[i].sample.empty()) {
            samples[cases[i].path].push_back(i);
            continue;
        }
        const std::string title =
            cases[i].title + (cases[i].variant.empty() ? "" : ", " + cases[i].variant);
        maker.draw(cases[i].name,
                   picture_of_curves(cases[i].picture, title, curves_of(cases[i], results[i])));
        if (cases.size() > 1) {
            all.push_back(computed(cases[i], results[i], static_cast<int>(all.size())));
            names.push_back(cases[i].name);
        }
    }
    if (are_compared(cases)) {
        tell_apart(all, names);
        bool labelled = false;
        for (const CaseFile& file : cases)
            if (has_reference(file)) {
                all.push_back(reference(file, labelled ? "" : "reference"));
                labelled = true;
            }
        maker.draw("comparison",
                   picture_of_curves(cases.front().picture, title_of_comparison(cases), all));
    }
    for (const auto& [path, which] : samples) {
        std::vector<const CaseFile*> files;
        std::vector<const CaseResult*> runs;
        for (const std::size_t i : which) {
            files.push_back(&cases[i]);
            runs.push_back(&results[i]);
        }
        for (std::size_t i = 0; i < std::min(most_sheets, panels_of(files.front()->picture)); ++i)
            maker.draw(sheet_name(*files.front(), i), sheet(files, runs, i));
    }
    return !maker.failed();
}

}  // namespace cli
