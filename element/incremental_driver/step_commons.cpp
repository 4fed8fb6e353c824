// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/step_commons.hpp"

#include <algorithm>

#include "element/errors.hpp"
#include "element/schedule.hpp"

namespace incremental_driver {
namespace {

constexpr int most_iterations = 100000;
const std::string import_file = "*ImportFile";

// Where "T" or "T20" begins, npos if nowhere. Other words that hold a T are remarks.
std::size_t temperature_of(const std::string& text) {
    for (std::size_t t = text.find('T'); t != std::string::npos; t = text.find('T', t + 1)) {
        const bool begins = t == 0 || std::string(" \t,").find(text[t - 1]) != std::string::npos;
        const bool ends = t + 1 == text.size() ||
                          std::string(" \t,+-.0123456789").find(text[t + 1]) != std::string::npos;
        if (begins && ends) return t;
    }
    return std::string::npos;
}

}  // namespace

Keyword read_keyword(const Lines& lines, const Line& line) {
    const std::string kept = within_forty_columns(lines, line);
    std::string text = trimmed(kept);
    Keyword out;
    out.line = line.number;
    out.cut = kept.size() < line.text.size();
    if (const std::size_t mark = text.find('?'); mark != std::string::npos) {
        out.condition = trimmed(text.substr(mark + 1));
        if (out.condition.empty())
            lines.fail(line.number, "expected a condition behind ?, such as s1 < -400");
        text = trimmed(text.substr(0, mark));
    }
    if (text.starts_with(import_file)) {  // its name may follow without a blank
        out.name = import_file;
        out.argument = trimmed(text.substr(import_file.size()));
        return out;
    }
    const std::size_t end = std::min(text.find_first_of(" \t,"), text.size());
    out.name = text.substr(0, end);
    // Words behind it are a remark, unless they look like a condition that lost its mark.
    if (text.find_first_of("<>", end) != std::string::npos)
        lines.fail(line.number, "a condition follows ?, got \"" + trimmed(text.substr(end)) +
                                    "\" behind " + out.name);
    return out;
}

element::Condition read_condition(const Lines& lines, const Keyword& keyword,
                                  const element::Vocabulary& vocabulary) {
    try {
        return element::parse_condition(keyword.condition, vocabulary);
    } catch (const element::BadCase& error) {
        lines.fail(keyword.line, "exit condition \"" + keyword.condition + "\": " + error.what() +
                                     (keyword.cut ? " (the line is read up to column 40)" : ""));
    }
}

Commons read_commons(Lines& lines, const std::string& keyword) {
    const Line& line = lines.next("ninc maxiter dtime of " + keyword);
    std::string text = within_forty_columns(lines, line);
    Commons out;
    if (const std::size_t t = temperature_of(text); t != std::string::npos) {
        std::string behind = text.substr(t + 1);
        out.temperature_change = Fields(lines, line.number, behind.substr(0, behind.find(':')))
                                     .real("the change of temperature behind T");
        const std::size_t colon = behind.find(':');
        text = text.substr(0, t) + (colon == std::string::npos ? "" : behind.substr(colon));
    }
    if (const std::size_t colon = text.find(':'); colon != std::string::npos) {
        const int every =
            Fields(lines, line.number, text.substr(colon + 1))
                .whole("every, behind :,", -element::increment_limit, element::increment_limit);
        out.every = std::max(every, 1);
        text = text.substr(0, colon);
    }
    Fields fields(lines, line.number, text);
    out.increments = fields.whole("ninc", 1, element::increment_limit);
    out.iterations = fields.whole("maxiter", 0, most_iterations);
    out.duration = fields.real("dtime");
    if (out.duration < 0.0 && keyword != import_file)
        lines.fail(line.number, "dtime must be >= 0, got " + trimmed(text));
    out.every = std::min(out.every, out.increments);
    return out;
}

}  // namespace incremental_driver
