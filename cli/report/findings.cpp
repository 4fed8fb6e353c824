// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/findings.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 3;  // folders below the folder

// The smaller of two pictures is the one to be taken in.
void take_picture(Finding& finding, const fs::path& path) {
    if (finding.picture.empty() || fs::file_size(path) < fs::file_size(finding.picture))
        finding.picture = path;
}

// "sheet2" before "sheet10".
bool before(const std::string& a, const std::string& b) {
    return strverscmp(a.c_str(), b.c_str()) < 0;
}

void take(std::map<std::string, Finding>& found, const fs::path& folder, const fs::path& path) {
    const std::string ending = path.extension().string();
    fs::path below = fs::relative(path, folder);
    std::string stem = below.replace_extension().generic_string();
    const bool cycles = ending == ".csv" && stem.ends_with("_cycles");
    if (cycles) stem.resize(stem.size() - std::strlen("_cycles"));
    fs::path Finding::*place = ending == ".csv"    ? (cycles ? &Finding::cycles : &Finding::table)
                               : ending == ".pvd"  ? &Finding::frames
                               : ending == ".json" ? &Finding::numbers
                               : ending == ".txt"  ? &Finding::words
                                                   : nullptr;
    const bool picture = ending == ".svg" || ending == ".png";
    if (!place && !picture) return;
    Finding& finding = found[stem];
    finding.stem = stem;
    if (picture) take_picture(finding, path);
    else finding.*place = path;
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
    if (found.empty())
        throw BadInput(fmt::format("{}: no results: neither tables nor pictures", folder.string()));
    std::vector<Finding> out;
    for (auto& [stem, finding] : found) out.push_back(std::move(finding));
    std::sort(out.begin(), out.end(),
              [](const Finding& a, const Finding& b) { return before(a.stem, b.stem); });
    return out;
}

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw BadInput(fmt::format("{} cannot be read", path.string()));
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<StoryLine> read_story(const fs::path& path) {
    std::vector<StoryLine> out;
    if (path.empty()) return out;
    std::ifstream file(path);
    if (!file) throw BadInput(fmt::format("{} cannot be read", path.string()));
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        const std::size_t bar = line.find(" | ");
        if (line.starts_with("== ")) out.push_back({true, line.substr(3), ""});
        else if (bar != std::string::npos)
            out.push_back({false, line.substr(0, bar), line.substr(bar + 3)});
        else
            throw BadInput(
                fmt::format("{}:{}: needs \"== heading\" or \"NAME | sentence\", got \"{}\"",
                            path.string(), number, line));
    }
    return out;
}

bool is_called(const Finding& finding, const std::string& name) {
    const std::string last = finding.stem.substr(finding.stem.rfind('/') + 1);
    return fnmatch(name.c_str(), finding.stem.c_str(), 0) == 0 ||
           fnmatch(name.c_str(), last.c_str(), 0) == 0;
}

}  // namespace cli
