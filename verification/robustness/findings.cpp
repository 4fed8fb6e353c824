// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/findings.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace robustness {
namespace {

constexpr char line_end = '\x1f';  // of a program that stands in one line

std::string with(std::string text, char from, char to) {
    std::replace(text.begin(), text.end(), from, to);
    return text;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

}  // namespace

void Findings::add(const Findings& other) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
    for (std::size_t i = 0; i < largest.size(); ++i) measure(static_cast<int>(i), other.largest[i]);
    for (std::size_t i = 0; i < broken.size(); ++i) {
        if (broken[i].program.empty()) broken[i].program = other.broken[i].program;
        broken[i].times += other.broken[i].times;
    }
}

int Findings::rules_broken() const {
    return static_cast<int>(std::count_if(broken.begin(), broken.end(),
                                          [](const Broken& one) { return one.times != 0; }));
}

std::string Findings::line(const Vocabulary& words) const {
    std::string out;
    for (std::size_t i = 0; i < counts.size(); ++i)
        out += '\t' + words.counts[i] + '=' + std::to_string(counts[i]);
    for (std::size_t i = 0; i < largest.size(); ++i)
        out += '\t' + words.largest[i] + '=' + number(largest[i]);
    for (std::size_t i = 0; i < broken.size(); ++i)
        out += '\t' + words.rules[i] + '=' + std::to_string(broken[i].times) + ' ' +
               with(broken[i].program, '\n', line_end);
    return out;
}

Findings Findings::of_line(const Vocabulary& words, const std::string& line) {
    Findings out(words);
    std::istringstream fields(line);
    std::string field;
    std::getline(fields, field, '\t');
    const auto next = [&](const std::string& name) {
        if (!std::getline(fields, field, '\t') || field.rfind(name + '=', 0) != 0)
            throw std::runtime_error("\"" + name + "\" is missing");
        return field.substr(name.size() + 1);
    };
    for (std::size_t i = 0; i < words.counts.size(); ++i)
        out.counts[i] = std::stol(next(words.counts[i]));
    for (std::size_t i = 0; i < words.largest.size(); ++i)
        out.largest[i] = std::strtod(next(words.largest[i]).c_str(), nullptr);
    for (std::size_t i = 0; i < words.rules.size(); ++i) {
        const std::string text = next(words.rules[i]);
        out.broken[i].times = std::stol(text);
        out.broken[i].program = with(text.substr(text.find(' ') + 1), line_end, '\n');
    }
    return out;
}

void Findings::print(const Vocabulary& words) const {
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] != 0) std::printf("%14ld  %s\n", counts[i], words.counts[i].c_str());
    for (std::size_t i = 0; i < largest.size(); ++i)
        std::printf("%14.3g  %s\n", largest[i], words.largest[i].c_str());
    for (std::size_t i = 0; i < broken.size(); ++i)
        std::printf("%14ld  times not: %s\n", broken[i].times, words.rules[i].c_str());
    for (std::size_t i = 0; i < broken.size(); ++i)
        if (broken[i].times != 0)
            std::printf("\n// not: %s\n%s", words.rules[i].c_str(), broken[i].program.c_str());
}

}  // namespace robustness
