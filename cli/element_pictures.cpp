// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element_pictures.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "cli/foreign_columns.hpp"
#include "cli/panels.hpp"

namespace cli {
namespace {

Curve computed(const CaseFile& file, const CaseResult& result, int colour) {
    return {file.title, result.table, result.cycles, false, colour};
}

bool has_reference(const CaseFile& file) { return !file.reference.curve.empty(); }

Curve reference(const CaseFile& file, const std::string& label) {
    return {
        label, standardised(read_table(file.reference.curve, file.reference.only)), {}, true, -1};
}

std::vector<Curve> curves_of(const CaseFile& file, const CaseResult& result) {
    Curve run = computed(file, result, 0);
    run.label = "computed";
    std::vector<Curve> out = {run};
    if (has_reference(file))
        out.push_back(reference(file, file.sample.empty() ? "reference" : "measured"));
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
        const Start& start = files[i]->start;
        panel.title = fmt::format("{}: p0 {:.0f} kPa, e {:.3f}", files[i]->sample,
                                  -start.stress.head<3>().sum() / 3.0, start.void_ratio);
        out.title = panel.y_label + " over " + panel.x_label;
        out.panels.push_back(std::move(panel));
    }
    return out;
}

class Drawer {
  public:
    Drawer(std::filesystem::path where, bool no_words)
        : folder(std::move(where)), quiet(no_words) {}

    void draw(const std::string& name, const Picture& picture) {
        if (!problem.empty()) return;
        problem = cli::draw(folder / name, picture);
        if (!problem.empty()) fmt::print(stderr, "grit: no picture: {}\n", problem);
        else if (!quiet) fmt::print("picture: {} and .png\n", (folder / (name + ".svg")).string());
    }

  private:
    std::filesystem::path folder;
    bool quiet;
    std::string problem;
};

}  // namespace

void draw_cases(const std::filesystem::path& folder, const std::vector<CaseFile>& cases,
                const std::vector<CaseResult>& results, bool quiet) {
    Drawer drawer(folder, quiet);
    std::vector<Curve> all;
    std::map<std::filesystem::path, std::vector<std::size_t>> samples;
    bool alike = true;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        alike = alike && cases[i].picture == cases.front().picture;
        if (!cases[i].sample.empty()) {
            samples[cases[i].path].push_back(i);
            continue;
        }
        drawer.draw(cases[i].name, picture_of_curves(cases[i].picture, cases[i].title,
                                                     curves_of(cases[i], results[i])));
        all.push_back(computed(cases[i], results[i], static_cast<int>(all.size())));
    }
    const bool referenced = std::any_of(cases.begin(), cases.end(), has_reference);
    if (referenced && alike) {
        bool labelled = false;
        for (const CaseFile& file : cases)
            if (file.sample.empty() && has_reference(file)) {
                all.push_back(reference(file, labelled ? "" : "reference"));
                labelled = true;
            }
    }
    if (alike && samples.empty() && cases.size() > 1)
        drawer.draw("comparison", picture_of_curves(cases.front().picture, "Comparison", all));
    for (const auto& [path, which] : samples) {
        std::vector<const CaseFile*> files;
        std::vector<const CaseResult*> runs;
        for (const std::size_t i : which) {
            files.push_back(&cases[i]);
            runs.push_back(&results[i]);
        }
        for (std::size_t panel = 0; panel < 4; ++panel) {
            if (panel >= panels_of(files.front()->picture)) break;
            drawer.draw(fmt::format("{}_sheet{}", path.stem().string(), panel + 1),
                        sheet(files, runs, panel));
        }
    }
}

}  // namespace cli
