// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/result_head.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "cli/report/charts.hpp"
#include "cli/table/table.hpp"

namespace cli {
namespace {

constexpr const char* with = "with ";

// What a comparison calls its runs, by their stems; false: it is none.
bool add_names(const Finding& finding, std::map<std::string, std::string>& out) {
    try {
        if (!is_comparison(finding)) return false;
        const std::string folder = finding.stem.substr(0, finding.stem.rfind('/') + 1);
        for (const ComparedRun& run : compared_runs(finding)) out[folder + run.name] = run.label;
        return true;
    } catch (const BadInput&) {  // told where it is shown
        return false;
    }
}

}  // namespace

ResultHead head_of(const std::filesystem::path& table) {
    ResultHead out;
    out.comments = comments_above(table);
    for (const std::string& line : out.comments)
        if (line.starts_with(with) &&
            (line.find('=') != std::string::npos || line.find("--") != std::string::npos))
            out.settings = line.substr(std::char_traits<char>::length(with));
    // "Grit 0.1.0, case NAME: TITLE".
    if (out.comments.empty() || !out.comments.front().starts_with("Grit ")) return out;
    const std::string& first = out.comments.front();
    const std::size_t comma = first.find(", "), colon = first.find(": ");
    out.version = first.substr(0, std::min(comma, colon));
    if (colon == std::string::npos) return out;
    out.title = first.substr(colon + 2);
    if (comma < colon) out.made = first.substr(comma + 2, colon - comma - 2);
    return out;
}

std::map<std::string, std::string> headings_of(const std::vector<Finding>& findings) {
    std::map<std::string, std::string> out, names;
    std::map<std::string, int> as_often;
    std::map<std::string, ResultHead> heads;
    for (const Finding& finding : findings) {
        std::string& heading = out[finding.stem] = finding.stem;
        if (finding.table.empty()) continue;
        const ResultHead head = head_of(finding.table);
        if (head.title.empty()) continue;
        heading = head.title;
        if (add_names(finding, names)) {
            heading += ": all runs";
            continue;
        }
        ++as_often[head.title];
        heads[finding.stem] = head;
    }
    for (const auto& [stem, head] : heads) {
        const auto name = names.find(stem);
        if (name != names.end() && !name->second.empty()) out[stem] += ": " + name->second;
        else if (!head.settings.empty()) out[stem] += fmt::format(" {}{}", with, head.settings);
        else if (as_often[head.title] > 1) out[stem] += fmt::format(" ({})", stem);
    }
    return out;
}

}  // namespace cli
