// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/report_command.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "cli/process/markup.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"
#include "cli/report/charts.hpp"
#include "cli/report/embedded.hpp"
#include "cli/report/findings.hpp"
#include "cli/report/frames.hpp"
#include "cli/report/json_text.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows = 400;  // of a table of words

// One page, written from its top.
class Page {
  public:
    Page(const ReportRequest& asked, const fs::path& place) : request(asked), file(place) {
        file.write(fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
                               "charset=\"utf-8\"><meta name=\"viewport\" "
                               "content=\"width=device-width\"><title>{0}</title>\n<style>{1}</"
                               "style></head><body>\n<h1>{0}</h1>\n",
                               escaped(title()), page_style()));
    }

    void heading(const std::string& text) {
        file.write(fmt::format("<h2>{}</h2>\n", escaped(text)));
    }

    void show(Finding& finding, const std::string& sentence) {
        if (finding.shown) return;
        finding.shown = true;
        Shown table;
        std::string problem;
        if (!finding.table.empty()) try {
                table = shown_of(finding);
            } catch (const BadInput& error) {
                problem = error.what();
            }
        file.write(fmt::format("<section id=\"{0}\"><h3>{1}</h3>\n", escaped(finding.stem),
                               escaped(table.title.empty() ? finding.stem : table.title)));
        if (!sentence.empty()) file.write(fmt::format("<p>{}</p>\n", escaped(sentence)));
        if (!problem.empty())
            file.write(fmt::format("<p class=\"bad\">{}</p>\n", escaped(problem)));
        if (!table.panels.empty()) data("curves", json_of(table.panels));
        if (!table.cells.empty()) cells(table.cells);
        if (!finding.frames.empty())
            if (const std::string frames = frames_of(finding.frames); !frames.empty())
                data("player", frames);
        if (!finding.numbers.empty()) numbers(finding.numbers);
        if (!finding.words.empty())
            file.write(fmt::format("<pre>{}</pre>\n", escaped(content_of(finding.words))));
        // Curves say all that a picture of theirs does; where there are none, the picture stays.
        if (!finding.picture.empty() && (table.panels.empty() || !curves_are_drawn()))
            picture(finding);
        if (!table.comments.empty()) {
            versions.insert(table.comments.front().substr(0, table.comments.front().find(", ")));
            std::string lines;
            for (const std::string& each : table.comments) lines += escaped(each) + "\n";
            file.write(fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n",
                                   escaped(finding.table.filename().string()), lines));
        }
        file.write("</section>\n");
        ++sections;
    }

    int complete() {
        std::string made;
        for (const std::string& each : versions) made += (made.empty() ? "" : ", ") + each;
        file.write(fmt::format(
            "<footer>Results of {}. Page by Grit {}: <code>grit report {}</code>.{}</footer>\n",
            escaped(made.empty() ? "nobody knows which version" : made), escaped(version()),
            escaped(request.folder.string()),
            curves_are_drawn() ? " Curves by Chart.js 3, © Chart.js Contributors, MIT licence."
                               : " This grit was built without Chart.js (libjs-chart.js): pictures "
                                 "stand in place of curves."));
        if (curves_are_drawn()) file.write("<script>" + chart_library() + "</script>\n");
        file.write("<script>" + page_script() + "</script>\n</body></html>\n");
        file.complete();
        return sections;
    }

  private:
    std::string title() const {
        if (!request.title.empty()) return request.title;
        const std::string name = fs::weakly_canonical(request.folder).filename().string();
        return name.empty() ? "Results" : name;
    }

    static bool curves_are_drawn() { return !chart_library().empty(); }

    // Read by the page's script, which draws it in place.
    void data(const char* what, const std::string& json) {
        file.write(fmt::format(
            "<div class=\"{}\"><script type=\"application/json\">{}</script></div>\n", what, json));
    }

    void numbers(const fs::path& path) {
        std::string text = content_of(path);
        for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3)
            text.insert(at + 1, "\\");
        data("numbers", text);
    }

    // A last column "verdict" has its colours.
    void cells(const std::vector<std::vector<std::string>>& rows) {
        const bool judged = rows.front().back() == "verdict";
        file.write("<div class=\"table\"><table>\n");
        for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
            const char* tag = i == 0 ? "th" : "td";
            std::string line = judged && i > 0
                                   ? fmt::format("<tr class=\"{}\">", escaped(rows[i].back()))
                                   : std::string("<tr>");
            for (const std::string& cell : rows[i])
                line += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
            file.write(line + "</tr>\n");
        }
        file.write("</table></div>\n");
        if (rows.size() > most_rows)
            file.write(
                fmt::format("<p>{} more rows are in the file.</p>\n", rows.size() - most_rows));
    }

    void picture(const Finding& finding) {
        file.write(fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\">\n",
                               escaped(finding.stem),
                               finding.picture.extension() == ".svg" ? "svg+xml" : "png",
                               base64(content_of(finding.picture))));
    }

    const ReportRequest& request;
    element::AtomicFile file;
    std::set<std::string> versions;
    int sections = 0;
};

}  // namespace

ExitCode report_folder(const ReportRequest& request) {
    const fs::path place = request.out.empty() ? request.folder / "index.html" : request.out;
    const std::vector<StoryLine> story = read_story(request.story);
    std::vector<Finding> findings = findings_in(request.folder);
    Outputs outputs;
    outputs.add(place, "the page");
    const auto lock = outputs.lock();
    Page page(request, place);
    std::string heading;
    for (const StoryLine& line : story) {
        if (line.heading) {
            heading = line.name;
            continue;
        }
        for (Finding& finding : findings) {
            if (finding.shown || !is_called(finding, line.name)) continue;
            if (!heading.empty()) page.heading(heading);
            heading.clear();
            page.show(finding, line.sentence);
        }
    }
    const bool rest = std::any_of(findings.begin(), findings.end(),
                                  [](const Finding& each) { return !each.shown; });
    if (rest && !story.empty()) page.heading("Further results");
    for (Finding& finding : findings) page.show(finding, "");
    say("{} results -> {}\n", page.complete(), place.string());
    return ok;
}

}  // namespace cli
