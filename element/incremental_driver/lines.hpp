// SPDX-License-Identifier: BSD-3-Clause
// Input files line by line, and values on a line as Fortran's list-directed input takes them: separated
// by blanks, commas or tabs, exponents with E or D, whatever follows the values ignored.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace incremental_driver {

// A file cannot be used: "FILE:LINE: what, value, limit", one line.
struct BadInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Line {
    int number = 0;  // from 1
    std::string text;
};

class Lines {
  public:
    // Throws BadInput if the file cannot be read or is not text.
    explicit Lines(const std::filesystem::path& path);

    // Nothing but blank lines is left.
    bool at_end() const { return position == lines.size(); }
    // The next line that is not blank; throws BadInput naming what is missing at the end.
    const Line& next(const std::string& expected);
    // The one that next() will return, null at the end.
    const Line* peek() const { return at_end() ? nullptr : &lines[position]; }

    const std::filesystem::path& path() const { return name; }
    [[noreturn]] void fail(int line, const std::string& why) const;

  private:
    std::filesystem::path name;
    std::vector<Line> lines;
    std::size_t position = 0;
    int last = 0;  // number of the file's last line
};

// The values of one line, from the left.
class Fields {
  public:
    Fields(const Lines& from, const Line& line) : Fields(from, line.number, line.text) {}
    Fields(const Lines& from, int line, std::string values)
        : lines(from), number(line), text(std::move(values)) {}

    // Finite; throws BadInput saying what was expected.
    double real(const std::string& what);
    // The only value of its line: refuses the decimal comma that "0,2" may be meant to have.
    double single(const std::string& what);
    // In [lowest, highest].
    int whole(const std::string& what, int lowest, int highest);
    std::optional<std::string> word();
    std::string rest() const;

  private:
    const Lines& lines;
    int number;
    std::string text;
    std::size_t position = 0;
};

std::string trimmed(const std::string& text);

// incrementalDriver keeps 40 characters of keyword and step lines, so that users write remarks behind
// them. What is left of the line, without a remark after # or !; throws BadInput where the cut would
// go through a number.
std::string within_forty_columns(const Lines& lines, const Line& line);

}  // namespace incremental_driver
