// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/found_sand.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "cli/report/findings.hpp"
#include "cli/sand/parameter_units.hpp"
#include "cli/sand/sand_file.hpp"

namespace cli {
namespace {

constexpr const char* found_by = ": found by grit calibrate (";

std::string first_line(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string out;
    std::getline(file, out);
    return out;
}

struct Interval {
    std::string lowest, highest, remark;
};

// "  h_s 4.4962e+05 ... 5.6924e+07 kPa, open to its bound".
bool take_interval(const std::string& comment, std::map<std::string, Interval>& out) {
    std::istringstream words(comment);
    std::string symbol, dots, unit;
    Interval one;
    if (!(words >> symbol >> one.lowest >> dots >> one.highest >> unit) || dots != "...")
        return false;
    std::getline(words >> std::ws, one.remark);
    out[symbol] = one;
    return true;
}

}  // namespace

bool is_found_sand(const std::filesystem::path& path) {
    return first_line(path).find(found_by) != std::string::npos;
}

bool is_calibration_page(const std::filesystem::path& path) {
    return content_of(path).find("found by <code>grit calibrate ") != std::string::npos;
}

FoundSand found_sand_of(const std::filesystem::path& path) {
    FoundSand out;
    std::map<std::string, Interval> intervals;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line) && line.starts_with("# ");) {
        line.erase(0, 2);
        if (const std::size_t at = line.find(found_by); at != std::string::npos) {
            out.title = line.substr(0, at);
            out.version = line.substr(at + std::char_traits<char>::length(found_by));
            if (out.version.ends_with(')')) out.version.pop_back();
        }
        if (line.starts_with("case ") && out.file.empty()) out.file = line.substr(5);
        if (!take_interval(line, intervals)) out.comments.push_back(line);
    }
    const grit_sand_parameters sand = read_sand_file(path);
    out.rows.push_back({"parameter", "symbol", "unit", "best", "2.5 %", "97.5 %", ""});
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        double value = NAN;
        grit_sand_parameter_get(&sand, i, &value);
        if (std::isnan(value)) continue;
        const Unit unit = unit_of(info);
        const auto interval = intervals.find(info.symbol);
        const Interval known =
            interval == intervals.end() ? Interval{"", "", "given or tied"} : interval->second;
        out.rows.push_back({info.name, info.symbol, unit.name,
                            fmt::format("{:.5g}", value / unit.size), known.lowest, known.highest,
                            known.remark});
    }
    return out;
}

}  // namespace cli
