// SPDX-License-Identifier: BSD-3-Clause
#include "incremental_driver/restriction.hpp"

#include <algorithm>
#include <string_view>

namespace incremental_driver {
namespace {

// Sign, factor and name of a term; position is moved behind it.
struct Term {
    double factor = 1.0;
    std::string name;  // empty: a number alone
};

class Reader {
  public:
    Reader(const Lines& from, const Line& at, std::string part)
        : lines(from), line(at), text(std::move(part)) {}

    bool done() {
        skip_blanks();
        return position == text.size();
    }

    // [+|-] [number *] name, or [+|-] number
    Term term(bool first) {
        skip_blanks();
        double sign = 1.0;
        if (position < text.size() && (text[position] == '+' || text[position] == '-'))
            sign = text[position++] == '-' ? -1.0 : 1.0;
        else if (!first) fail("expected + or -");
        Term out;
        std::string word = next_word();
        skip_blanks();
        if (starts_a_number(word)) {
            out.factor = Fields(lines, line.number, word).real("a factor");
            word.clear();
            if (position < text.size() && text[position] == '*') {
                ++position;
                word = next_word();
            }
        }
        out.factor *= sign;
        out.name = word;
        return out;
    }

    [[noreturn]] void fail(const std::string& why) const {
        const std::string from = trimmed(text.substr(std::min(position, text.size())));
        lines.fail(line.number,
                   why + (from.empty() ? " at the end of the line" : " at \"" + from + "\""));
    }

  private:
    static bool starts_a_number(const std::string& word) {
        return word.find_first_of("0123456789.") == 0;
    }

    void skip_blanks() {
        position = std::min(text.find_first_not_of(" \t\r", position), text.size());
    }

    // Up to a blank, an operator or the end; the sign of an exponent belongs to its number.
    std::string next_word() {
        skip_blanks();
        const std::size_t begin = position;
        while (position < text.size()) {
            const std::string_view so_far(text.data() + begin, position - begin);
            const bool exponent = !so_far.empty() && so_far.find_first_of("0123456789.") == 0 &&
                                  std::string_view("eEdD").find(so_far.back()) != so_far.npos;
            const char c = text[position];
            if (std::string_view(" \t\r*").find(c) != std::string_view::npos) break;
            if ((c == '+' || c == '-') && !exponent) break;
            ++position;
        }
        if (position == begin) fail("expected a factor, sd1 ... sd6 or ed1 ... ed6");
        return text.substr(begin, position - begin);
    }

    const Lines& lines;
    const Line& line;
    std::string text;
    std::size_t position = 0;
};

void add(const Term& term, Restriction& out, const Lines& lines, int line) {
    const bool known = term.name.size() == 3 && term.name[1] == 'd' &&
                       (term.name[0] == 's' || term.name[0] == 'e') && term.name[2] >= '1' &&
                       term.name[2] <= '6';
    if (!known)
        lines.fail(line,
                   "a restriction speaks of sd1 ... sd6 and ed1 ... ed6, got " +
                       (term.name.empty() ? "a number on its left" : "\"" + term.name + "\""));
    (term.name[0] == 's' ? out.stress : out.strain)[term.name[2] - '1'] += term.factor;
}

}  // namespace

Restriction read_restriction(const Lines& lines, const Line& line) {
    const std::string text = line.text.substr(0, line.text.find_first_of("#!"));
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        lines.fail(line.number, "expected a restriction such as \"-sd1 + sd2 = 0\", got \"" +
                                    trimmed(text) + "\"");
    Restriction out;
    Reader left(lines, line, text.substr(0, equals));
    for (bool first = true; first || !left.done(); first = false)
        add(left.term(first), out, lines, line.number);
    if (out.stress.isZero(0.0) && out.strain.isZero(0.0))
        lines.fail(line.number, "this restriction restricts nothing: all factors are 0");
    // Unlike incrementalDriver, allow a blank between the sign and the number.
    Reader right(lines, line, text.substr(equals + 1));
    const Term change = right.term(true);
    if (!change.name.empty() || !right.done())
        lines.fail(line.number, "expected one number to the right of =, got \"" +
                                    trimmed(text.substr(equals + 1)) + "\"");
    out.change = change.factor;
    return out;
}

}  // namespace incremental_driver
