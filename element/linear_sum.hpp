// SPDX-License-Identifier: BSD-3-Clause
// "-s1 + 2.5*s3": sums of named quantities, in exit conditions and restrictions.
#pragma once

#include <string>
#include <vector>

namespace element {

struct Term {
    double factor = 1.0;
    std::string name;
};

// Reads a text from the left. Everything throws BadCase saying what was expected at which character.
class SumReader {
  public:
    // what: of which the text is one, for messages.
    SumReader(std::string what, std::string text);

    // [sign] [number *] name, then the same with a sign as often as there is one
    std::vector<Term> sum();
    // [sign] number, blanks between them allowed
    double number();
    bool take(char c);
    void end();
    [[noreturn]] void fail(const std::string& expected) const;

  private:
    Term term(double sign);
    void skip_blanks();

    std::string what, text;
    std::size_t at = 0;
};

}  // namespace element
