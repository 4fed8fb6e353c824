// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/findings.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "cli/report/found_sand.hpp"
#include "support/tables/text_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 3;  // folders below the folder

// The smaller of two pictures is the one to be taken in.
void take_picture(Finding& finding, const fs::path& path) {
    if (finding.picture.empty() || fs::file_size(path) < fs::file_size(finding.picture))
        finding.picture = path;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "sheet2" before "sheet10", "e_0.55" before "e_0.6".
bool before(const std::string& a, const std::string& b) {
    const char *i = a.data(), *k = b.data();
    const char *const a_end = i + a.size(), *const b_end = k + b.size();
    while (i != a_end && k != b_end) {
        if (is_digit(*i) && is_digit(*k)) {
            double one = 0.0, two = 0.0;
            i = std::from_chars(i, a_end, one, std::chars_format::fixed).ptr;
            k = std::from_chars(k, b_end, two, std::chars_format::fixed).ptr;
            if (one != two) return one < two;
        } else if (*i != *k) {
            return *i < *k;
        } else {
            ++i, ++k;
        }
    }
    return i == a_end && k == b_end ? a < b : i == a_end;
}

// Without an ending that says what it is to another file; false: it has none.
bool cut_off(std::string& stem, const char* ending) {
    if (!stem.ends_with(ending)) return false;
    stem.resize(stem.size() - std::strlen(ending));
    return true;
}

// Which of a finding's files it is, and the stem by which it belongs to others; null: none, or a picture.
fs::path Finding::*place_of(const fs::path& path, std::string& stem) {
    const std::string ending = path.extension().string();
    if (ending == ".csv")
        return cut_off(stem, "_cycles")      ? &Finding::cycles
               : cut_off(stem, "_reference") ? &Finding::reference
                                             : &Finding::table;
    if (ending == ".pvd") return &Finding::frames;
    if (ending == ".json") return &Finding::numbers;
    if (ending == ".txt") return &Finding::words;
    if (ending == ".toml" && stem.ends_with("_sand") && is_found_sand(path)) return &Finding::sand;
    if (ending == ".html" && stem.ends_with("_report") && is_calibration_page(path)) {
        cut_off(stem, "_report");
        stem += "_sand";
        return &Finding::sand_page;
    }
    return nullptr;
}

void take(std::map<std::string, Finding>& found, const fs::path& folder, const fs::path& path) {
    fs::path below = path.lexically_relative(folder);
    std::string stem = below.replace_extension().generic_string();
    fs::path Finding::*place = place_of(path, stem);
    const bool picture = path.extension() == ".svg" || path.extension() == ".png";
    if (!place && !picture) return;
    Finding& finding = found[stem];
    finding.stem = stem;
    if (picture) take_picture(finding, path);
    else finding.*place = path;
}

// A reference of nothing, and cycles of nothing, are tables like others.
void free_tables(std::map<std::string, Finding>& found) {
    std::vector<Finding> alone;
    for (auto& [stem, finding] : found) {
        if (!finding.table.empty()) continue;
        const std::pair<fs::path*, const char*> parts[] = {{&finding.reference, "_reference"},
                                                           {&finding.cycles, "_cycles"}};
        for (const auto& [part, ending] : parts) {
            if (part->empty()) continue;
            alone.emplace_back().stem = stem + ending;
            alone.back().table = std::exchange(*part, {});
        }
    }
    for (Finding& finding : alone) {
        Finding& own = found[finding.stem];
        own.stem = finding.stem;
        own.table = std::move(finding.table);
    }
    std::erase_if(found, [](const auto& each) {
        const Finding& f = each.second;
        return f.table.empty() && f.cycles.empty() && f.picture.empty() && f.frames.empty() &&
               f.numbers.empty() && f.words.empty() && f.sand.empty() && f.sand_page.empty();
    });
}

}  // namespace

std::vector<Finding> findings_in(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw BadInput(fmt::format("{} is not a folder", folder.string()));
    std::map<std::string, Finding> found;
    std::error_code problem;
    for (fs::recursive_directory_iterator at(folder, problem), end; !problem && at != end;
         at.increment(problem)) {
        if (at.depth() >= deepest) at.disable_recursion_pending();
        if (at->is_regular_file(problem) && !problem) take(found, folder, at->path());
    }
    if (problem) throw BadInput(fmt::format("{}: {}", folder.string(), problem.message()));
    free_tables(found);
    if (found.empty())
        throw BadInput(fmt::format("{}: no results: neither tables, pictures, frames nor what "
                                   "grit calibrate writes",
                                   folder.string()));
    std::vector<Finding> out;
    for (auto& [stem, finding] : found) out.push_back(std::move(finding));
    std::sort(out.begin(), out.end(),
              [](const Finding& a, const Finding& b) { return before(a.stem, b.stem); });
    return out;
}

std::string content_of(const fs::path& path) {
    try {
        return grit::read_text_file(path, grit::longest_table);
    } catch (const grit::TextFileError& error) {
        throw BadInput(error.what());
    }
}

std::vector<StoryLine> read_story(const fs::path& path) {
    std::vector<StoryLine> out;
    if (path.empty()) return out;
    const std::string text = content_of(path);
    grit::TextLines lines(text);
    int number = 0;
    for (std::string line; lines.next(line);) {
        ++number;
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty() || line.front() == '#') continue;
        const std::size_t bar = line.find(" | ");
        if (line.starts_with("== ")) out.push_back({number, true, line.substr(3), ""});
        else if (bar != std::string::npos)
            out.push_back({number, false, line.substr(0, bar), line.substr(bar + 3)});
        else
            throw BadInput(
                fmt::format("{}:{}: needs \"== heading\" or \"NAME | sentence\", got \"{}\"",
                            path.string(), number, line));
    }
    return out;
}

void give_pictures_to_runs(std::vector<Finding>& findings, const std::vector<StoryLine>& story) {
    const auto is_picture = [](const Finding& f) {
        return !f.picture.empty() && f.table.empty() && f.cycles.empty() && f.frames.empty() &&
               f.numbers.empty() && f.words.empty() && f.sand.empty() && f.sand_page.empty();
    };
    const auto named = [&](const Finding& f) {
        const std::string last = f.stem.substr(f.stem.rfind('/') + 1);
        return std::any_of(story.begin(), story.end(), [&](const StoryLine& line) {
            return !line.heading && (line.name == f.stem || line.name == last);
        });
    };
    std::set<std::string> given;
    for (const Finding& picture : findings) {
        if (!is_picture(picture) || named(picture)) continue;
        Finding* run = nullptr;
        for (Finding& each : findings)
            if (!each.table.empty() && picture.stem.starts_with(each.stem + "_") &&
                picture.stem.find('/', each.stem.size()) == std::string::npos &&
                (!run || each.stem.size() > run->stem.size()))
                run = &each;
        if (!run) continue;
        run->fields.push_back(picture.picture);
        given.insert(picture.stem);
    }
    std::erase_if(findings, [&](const Finding& f) { return given.contains(f.stem); });
}

bool is_called(const Finding& finding, const std::string& name) {
    const std::string last = finding.stem.substr(finding.stem.rfind('/') + 1);
    return fnmatch(name.c_str(), finding.stem.c_str(), 0) == 0 ||
           fnmatch(name.c_str(), last.c_str(), 0) == 0;
}

}  // namespace cli
