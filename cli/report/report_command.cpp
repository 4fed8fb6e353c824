// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/report_command.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/viridis.hpp"
#include "cli/process/markup.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"
#include "cli/report/charts.hpp"
#include "cli/report/embedded.hpp"
#include "cli/report/findings.hpp"
#include "cli/report/found_sand.hpp"
#include "cli/report/frames.hpp"
#include "cli/report/json_check.hpp"
#include "cli/report/json_text.hpp"
#include "cli/report/result_head.hpp"
#include "cli/table/table.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows = 400;  // of a table of words

constexpr const char* generator = "<meta name=\"generator\" content=\"grit report\">";

// Nobody's page but one of grit report is written over; the first ones had no generator in their head.
void spare_pages_of_others(const fs::path& place) {
    if (!fs::is_regular_file(place) || fs::is_empty(place)) return;
    const std::string page = content_of(place);
    if (page.find(generator) < 1000 || page.find(". Page by Grit ") != std::string::npos) return;
    throw BadInput(fmt::format("{}: this file is none that grit report wrote and stays as it is; "
                               "--out FILE writes the page to another place",
                               place.string()));
}

// As a link has it.
std::string as_link(const fs::path& path) {
    std::string out;
    for (const char c : path.generic_string())
        if (std::isalnum(static_cast<unsigned char>(c)) || std::strchr("/._-~", c)) out += c;
        else out += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    return out;
}

// A word of a command line.
std::string as_word(const std::string& text) {
    return text.find_first_of(" '\"") == std::string::npos ? text : fmt::format("\"{}\"", text);
}

// Forces of plane strain are those of a metre.
std::string across(const fs::path& table) {
    const std::vector<std::string> names = read_cells(table).rows.front();
    return std::any_of(names.begin(), names.end(),
                       [](const std::string& name) { return name.ends_with("[kN/m]"); })
               ? "x"
               : "r";
}

// What is known of a result before the page begins: its place in the contents, and what cannot be read.
struct Section {
    const Finding* finding;
    std::string heading, sentence;
    Shown table;
    ResultHead head;
    FoundSand sand;
    std::vector<std::string> problems;
    std::string axis = "r";  // of bodies in the plane
};

struct Chapter {
    std::string heading;  // of a story; empty: none
    std::vector<Section> sections;
};

template <class Read> void try_to(Section& section, Read&& read) {
    try {
        read();
    } catch (const BadInput& error) {
        section.problems.emplace_back(error.what());
    }
}

Section read_section(const Finding& finding, const std::string& heading,
                     const std::string& sentence) {
    Section out{&finding, heading, sentence, {}, {}, {}, {}};
    try_to(out, [&] {
        if (!finding.sand.empty()) out.sand = found_sand_of(finding.sand);
    });
    try_to(out, [&] {
        if (finding.table.empty()) return;
        out.head = head_of(finding.table);
        out.table = shown_of(finding);
        out.axis = across(finding.table);
    });
    try_to(out, [&] {
        if (finding.numbers.empty()) return;
        const std::string problem = problem_of_json(content_of(finding.numbers));
        if (!problem.empty())
            throw BadInput(fmt::format("{}:{}", finding.numbers.string(), problem));
    });
    if (!out.sand.title.empty()) out.heading = out.sand.title;
    return out;
}

// As the story has them; of the others verdicts come first, and what cannot be read last.
std::vector<Chapter> chapters_of(const ReportRequest& request, std::vector<Finding>& findings,
                                 const std::vector<StoryLine>& story) {
    const std::map<std::string, std::string> headings = headings_of(findings);
    std::vector<Chapter> out(1);
    const auto add = [&](Finding& finding, const std::string& sentence) {
        finding.shown = true;
        out.back().sections.push_back(read_section(finding, headings.at(finding.stem), sentence));
    };
    for (const StoryLine& line : story) {
        if (line.heading) {
            out.push_back({line.name, {}});
            continue;
        }
        bool known = false;
        for (Finding& finding : findings) {
            if (!is_called(finding, line.name)) continue;
            known = true;
            if (!finding.shown) add(finding, line.sentence);
        }
        if (!known)
            warn("grit: {}:{}: no result is called {}\n", request.story.string(), line.number,
                 line.name);
    }
    out.push_back({story.empty() ? "" : "Further results", {}});
    for (Finding& finding : findings)
        if (!finding.shown) add(finding, "");
    std::vector<Section>& rest = out.back().sections;
    std::stable_partition(rest.begin(), rest.end(),
                          [](const Section& each) { return each.problems.empty(); });
    std::stable_partition(rest.begin(), rest.end(), [](const Section& each) {
        return each.problems.empty() && is_called(*each.finding, "references");
    });
    std::erase_if(out, [](const Chapter& each) { return each.sections.empty(); });
    return out;
}

// One page, written from its top.
class Page {
  public:
    Page(const ReportRequest& asked, const fs::path& place) : request(asked), file(place) {
        file.write(fmt::format(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">{2}<meta "
            "name=\"viewport\" content=\"width=device-width\"><title>{0}</title>\n<style>{1}</"
            "style></head><body>\n<h1>{0}</h1>\n",
            escaped(title()), page_style(), generator));
    }

    // Links to all sections, where there are enough of them to be looked for.
    void contents(const std::vector<Chapter>& chapters) {
        constexpr std::size_t few = 3;
        std::size_t count = 0;
        for (const Chapter& chapter : chapters) count += chapter.sections.size();
        if (count <= few) return;
        file.write("<nav><ul>\n");
        for (const Chapter& chapter : chapters) {
            if (!chapter.heading.empty())
                file.write(
                    fmt::format("<li class=\"chapter\">{}</li>\n", escaped(chapter.heading)));
            for (const Section& section : chapter.sections)
                file.write(fmt::format("<li{}><a href=\"#{}\">{}</a></li>\n",
                                       section.problems.empty() ? "" : " class=\"bad\"",
                                       as_link(section.finding->stem), escaped(section.heading)));
        }
        file.write("</ul></nav>\n");
    }

    void heading(const std::string& text) {
        file.write(fmt::format("<h2>{}</h2>\n", escaped(text)));
    }

    void show(const Section& section) {
        const Finding& finding = *section.finding;
        const Shown& table = section.table;
        const ResultHead& head = section.head;
        const FoundSand& sand = section.sand;
        file.write(fmt::format("<section id=\"{0}\"><h3>{1}</h3>\n", escaped(finding.stem),
                               escaped(section.heading)));
        if (!section.sentence.empty())
            file.write(fmt::format("<p>{}</p>\n", escaped(section.sentence)));
        for (const std::string& problem : section.problems)
            file.write(fmt::format("<p class=\"bad\">{}</p>\n", escaped(problem)));
        if (!sand.rows.empty()) {
            cells(sand.rows);
            made_by(finding.sand, sand.comments, sand.version,
                    "grit calibrate " + as_word(sand.file), "");
        }
        if (!finding.sand_page.empty()) calibration_page(finding.sand_page);
        if (!table.panels.empty()) data("curves", json_of(table));
        if (!table.cells.empty()) cells(table.cells);
        const Frames frames = frames_to_play(section);
        if (!frames.json.empty()) data("player", frames.json);
        fields(finding, frames.variables);
        if (!finding.numbers.empty() && section.problems.empty()) numbers(finding.numbers);
        if (!finding.words.empty())
            file.write(fmt::format("<pre>{}</pre>\n", escaped(content_of(finding.words))));
        // Curves say all that a picture of theirs does; where there are none, the picture stays.
        if (!finding.picture.empty() && (table.panels.empty() || !curves_are_drawn()))
            picture(finding.stem, finding.picture);
        if (!head.comments.empty())
            made_by(finding.table, head.comments, head.version,
                    table.command + (table.command.empty() || head.made.empty() ? "" : ", ") +
                        head.made,
                    head.settings);
        file.write("</section>\n");
        ++sections;
    }

    int complete() {
        if (!made.empty()) {
            file.write("<section id=\"versions\"><h2>Versions and commands</h2>\n");
            std::vector<std::vector<std::string>> rows = {
                {"file", "made by", "version", "--set and --vary"}};
            rows.insert(rows.end(), made.begin(), made.end());
            cells(rows);
            file.write("</section>\n");
        }
        file.write(fmt::format(
            "<footer>Results of {}. Page by Grit {}: <code>{}</code>.{}</footer>\n",
            versions.empty() ? "nobody knows which version"
                             : escaped(fmt::format("{}", fmt::join(versions, ", "))),
            escaped(version()), escaped(command()),
            curves_are_drawn() ? " Curves by Chart.js 3, © Chart.js Contributors, MIT licence."
                               : " This grit was built without Chart.js (libjs-chart.js): pictures "
                                 "stand in place of curves."));
        if (curves_are_drawn()) file.write("<script>" + chart_library() + "</script>\n");
        file.write(fmt::format("<script>const viridis = [\"{}\"];\n", fmt::join(viridis, "\",\"")));
        file.write(page_script() + "</script>\n</body></html>\n");
        file.complete();
        return sections;
    }

  private:
    std::string title() const {
        if (!request.title.empty()) return request.title;
        const std::string name = fs::weakly_canonical(request.folder).filename().string();
        return name.empty() ? "Results" : name;
    }

    std::string command() const {
        std::string out = "grit report " + as_word(request.folder.string());
        if (!request.title.empty()) out += " --title " + as_word(request.title);
        if (!request.story.empty()) out += " --story " + as_word(request.story.string());
        if (!request.out.empty()) out += " --out " + as_word(request.out.string());
        return out;
    }

    static bool curves_are_drawn() { return !chart_library().empty(); }

    // What is wrong with them is said: there are too many to be read before.
    Frames frames_to_play(const Section& section) {
        const fs::path& list = section.finding->frames;
        if (list.empty()) return {};
        std::string problem = list.string() + ": none of its frames can be read";
        try {
            Frames frames = frames_of(list, section.axis);
            if (!frames.json.empty()) return frames;
        } catch (const BadInput& error) {
            problem = error.what();
        }
        warn("grit: {}\n", problem);
        file.write(fmt::format("<p class=\"bad\">{}</p>\n", escaped(problem)));
        return {};
    }

    // Read by the page's script, which draws it in place.
    void data(const char* what, const std::string& json) {
        file.write(fmt::format(
            "<div class=\"{}\"><script type=\"application/json\">{}</script></div>\n", what, json));
    }

    void numbers(const fs::path& path) {
        std::string text;
        for (const char c : content_of(path))  // no tag of the page's, and only in strings
            if (c == '<') text += "\\u003c";
            else text += c;
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

    void picture(const std::string& name, const fs::path& path) {
        file.write(fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\">\n", escaped(name),
                               path.extension() == ".svg" ? "svg+xml" : "png",
                               base64(content_of(path))));
    }

    // Pictures of the end that the player does not show.
    void fields(const Finding& run, const std::vector<std::string>& played) {
        for (const fs::path& path : run.fields) {
            const std::string stem = path.stem().string();
            const std::string name = stem.substr(run.table.stem().string().size() + 1);
            const auto is_played = [&](const std::string& variable) {
                return variable == name || variable.starts_with(name + " [");
            };
            if (std::any_of(played.begin(), played.end(), is_played)) continue;
            file.write(fmt::format("<details><summary>picture: {}</summary>\n", escaped(name)));
            picture(stem, path);
            file.write("</details>\n");
        }
    }

    // How a file was made; a click shows all that stands above its columns.
    void made_by(const fs::path& path, const std::vector<std::string>& lines, const std::string& by,
                 const std::string& how, const std::string& settings) {
        std::string all, words = path.filename().string();
        for (const std::string& each : lines) all += each + "\n";
        for (const std::string& each : {by, how}) words += each.empty() ? "" : ", " + each;
        if (!settings.empty()) words += ", with " + settings;
        file.write(fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n",
                               escaped(words), escaped(all)));
        if (by.empty()) return;
        versions.insert(by);
        made.push_back(
            {path.lexically_relative(request.folder).generic_string(), how, by, settings});
    }

    // Beside this one as a link, and in it without its scripts, so that this one can be sent alone.
    void calibration_page(const fs::path& page) {
        const fs::path from = fs::absolute(file.path()).parent_path();
        file.write(fmt::format(
            "<p>Data against model, bands, correlations and what to measure next: <a "
            "href=\"{0}\">{1}</a>.</p>\n<details><summary>{1}, as it is</summary><iframe sandbox "
            "title=\"{1}\" srcdoc=\"{2}\"></iframe></details>\n",
            as_link(fs::absolute(page).lexically_relative(from)), escaped(page.filename().string()),
            escaped(content_of(page))));
    }

    const ReportRequest& request;
    element::AtomicFile file;
    std::set<std::string> versions;
    std::vector<std::vector<std::string>> made;  // file, by what, version, settings
    int sections = 0;
};

}  // namespace

ExitCode report_folder(const ReportRequest& request) {
    const fs::path place = request.out.empty() ? request.folder / "index.html" : request.out;
    const std::vector<StoryLine> story = read_story(request.story);
    std::vector<Finding> findings = findings_in(request.folder);
    give_pictures_to_runs(findings, story);
    Outputs outputs;
    outputs.add(place, "the page");
    spare_pages_of_others(place);
    const auto lock = outputs.lock();
    const std::vector<Chapter> chapters = chapters_of(request, findings, story);
    Page page(request, place);
    page.contents(chapters);
    for (const Chapter& chapter : chapters) {
        if (!chapter.heading.empty()) page.heading(chapter.heading);
        for (const Section& section : chapter.sections) page.show(section);
    }
    say("{} results -> {}\n", page.complete(), place.string());
    return ok;
}

}  // namespace cli
