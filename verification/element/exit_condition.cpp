// SPDX-License-Identifier: BSD-3-Clause
#include "element/exit_condition.hpp"

#include <cctype>
#include <cstdlib>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// Reads from the left: sign, [number *] name, ... < number.
class Reader {
  public:
    explicit Reader(const std::string& given) : text_(given) {}

    Condition condition() {
        Condition out;
        out.text = text_;
        double sign = take('-') ? -1.0 : (take('+'), 1.0);
        for (;;) {
            out.sum.push_back(term(sign));
            if (take('+')) sign = 1.0;
            else if (take('-')) sign = -1.0;
            else break;
        }
        if (take('<')) out.comparison = Comparison::less;
        else if (take('>')) out.comparison = Comparison::greater;
        else fail("< or >");
        out.limit = number();
        skip();
        if (at < text_.size()) fail("the end");
        return out;
    }

  private:
    Term term(double sign) {
        Term out;
        out.factor = sign;
        skip();
        if (at < text_.size() && (std::isdigit(byte()) || text_[at] == '.')) {
            out.factor *= number();
            if (!take('*')) fail("*");
            skip();
        }
        const std::size_t begin = at;
        while (at < text_.size() && (std::isalnum(byte()) || text_[at] == '_')) ++at;
        if (at == begin) fail("a quantity");
        out.quantity = text_.substr(begin, at - begin);
        return out;
    }

    double number() {
        skip();
        char* end = nullptr;
        const double value = std::strtod(text_.c_str() + at, &end);
        if (end == text_.c_str() + at || !(value - value == 0.0)) fail("a number");
        at = static_cast<std::size_t>(end - text_.c_str());
        return value;
    }

    bool take(char c) {
        skip();
        if (at >= text_.size() || text_[at] != c) return false;
        ++at;
        return true;
    }

    void skip() {
        while (at < text_.size() && std::isspace(byte())) ++at;
    }
    unsigned char byte() const { return static_cast<unsigned char>(text_[at]); }

    [[noreturn]] void fail(const char* expected) const {
        throw BadCase(text("condition \"%s\": expected %s at character %d", text_.c_str(), expected,
                           static_cast<int>(at) + 1));
    }

    const std::string& text_;
    std::size_t at = 0;
};

}  // namespace

Condition parse_condition(const std::string& text) { return Reader(text).condition(); }

double excess(const Condition& condition, const Record& record,
              const std::vector<std::string>& state_names) {
    double sum = 0.0;
    for (const Term& term : condition.sum)
        sum += term.factor * quantity(term.quantity, record, state_names);
    return sum - condition.limit;
}

bool holds(const Condition& condition, const Record& record,
           const std::vector<std::string>& state_names) {
    const double value = excess(condition, record, state_names);
    return condition.comparison == Comparison::less ? value < 0.0 : value > 0.0;
}

}  // namespace element
