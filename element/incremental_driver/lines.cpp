// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/lines.hpp"

#include <algorithm>
#include <cmath>

#include "element/number.hpp"
#include "element/text.hpp"
#include "support/tables/text_file.hpp"

namespace incremental_driver {
namespace {

using element::text;

constexpr const char* blanks = " \t\r";
constexpr const char* separators = " \t\r,";
constexpr std::size_t longest = 1000;  // characters of a line; a binary file has longer ones
constexpr std::size_t most_lines = 10'000'000;
constexpr std::size_t columns = 40;
constexpr const char* byte_order_mark = "\xEF\xBB\xBF";  // of editors on Windows

// "12/" is a number that ends the input of Fortran.
std::optional<double> value_of(const std::string& word) {
    return element::number_of(word.substr(0, word.find('/')));
}

}  // namespace

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

Lines::Lines(const std::filesystem::path& path) : name(path) {
    std::string whole;
    try {
        whole = grit::read_text_file(path, grit::longest_table);
    } catch (const grit::TextFileError& error) {
        throw BadInput(error.what());
    }
    grit::TextLines text_lines(whole);
    for (std::string line; text_lines.next(line);) {
        if (++last == 1 && line.starts_with(byte_order_mark)) line.erase(0, 3);
        if (line.find('\0') != std::string::npos || line.size() > longest)
            fail(last, "this is not a line of text");
        if (trimmed(line).empty()) continue;
        if (lines.size() == most_lines) fail(last, text("more than %zu lines", most_lines));
        lines.push_back({last, line});
    }
}

const Line& Lines::next(const std::string& expected) {
    if (at_end()) fail(last, "the file ends where " + expected + " is expected");
    return lines[position++];
}

void Lines::fail(int line, const std::string& why) const {
    throw BadInput(text("%s:%d: %s", name.string().c_str(), line, why.c_str()));
}

std::optional<std::string> Fields::word() {
    const std::size_t begin = text.find_first_not_of(separators, position);
    if (begin == std::string::npos) return std::nullopt;
    position = std::min(text.find_first_of(separators, begin), text.size());
    return text.substr(begin, position - begin);
}

double Fields::real(const std::string& what) {
    const std::optional<std::string> found = word();
    if (!found) lines.fail(number, "expected " + what + ", the line ends");
    const std::optional<double> value = value_of(*found);
    if (!value) lines.fail(number, "expected " + what + ", a number, got \"" + *found + "\"");
    return *value;
}

double Fields::single(const std::string& what) {
    const double value = real(what);
    const std::string behind = text.substr(position, 2);
    if (behind.size() == 2 && behind[0] == ',' && behind[1] >= '0' && behind[1] <= '9')
        lines.fail(number, "expected " + what + ", got \"" + trimmed(text) +
                               "\": decimals follow a point, not a comma");
    return value;
}

int Fields::whole(const std::string& what, int lowest, int highest) {
    const double value = real(what);
    if (value != std::floor(value) || !(value >= lowest && value <= highest))
        lines.fail(number, element::text("%s must be a whole number in [%d, %d], got %g",
                                         what.c_str(), lowest, highest, value));
    return static_cast<int>(value);
}

std::string Fields::rest() const { return trimmed(text.substr(position)); }

std::string within_forty_columns(const Lines& lines, const Line& line) {
    const std::string kept = line.text.substr(0, line.text.find_first_of("#!"));
    if (kept.size() <= columns) return kept;
    const bool cuts_a_word = std::string(separators).find(kept[columns - 1]) == std::string::npos &&
                             std::string(separators).find(kept[columns]) == std::string::npos;
    if (cuts_a_word) {
        const std::size_t begin = kept.find_last_of(separators, columns - 1) + 1;
        const std::size_t end = std::min(kept.find_first_of(separators, columns), kept.size());
        const std::string word = kept.substr(begin, end - begin);
        if (word.find_first_of("0123456789") != std::string::npos)
            lines.fail(line.number,
                       "the line is read up to column 40, which cuts \"" + word + "\": shorten it");
    }
    return kept.substr(0, columns);
}

}  // namespace incremental_driver
