// SPDX-License-Identifier: BSD-3-Clause
#include "element/linear_sum.hpp"

#include <algorithm>
#include <cctype>

#include "element/errors.hpp"
#include "element/number.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// Of "s1", "void_ratio", "statev(8)"; 0: none.
std::size_t name_length(std::string_view text) {
    const auto while_of = [&](std::size_t at, auto&& kind) {
        while (at < text.size() && kind(static_cast<unsigned char>(text[at]))) ++at;
        return at;
    };
    const std::size_t word =
        while_of(0, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (word == 0 || word == text.size() || text[word] != '(') return word;
    const std::size_t index = while_of(word + 1, [](unsigned char c) { return std::isdigit(c); });
    return index < text.size() && text[index] == ')' ? index + 1 : word;
}

}  // namespace

SumReader::SumReader(std::string kind, std::string given)
    : what(std::move(kind)), text(std::move(given)) {}

std::vector<Term> SumReader::sum() {
    std::vector<Term> out;
    double sign = take('-') ? -1.0 : (take('+'), 1.0);
    for (;;) {
        out.push_back(term(sign));
        if (take('+')) sign = 1.0;
        else if (take('-')) sign = -1.0;
        else return out;
    }
}

Term SumReader::term(double sign) {
    Term out;
    out.factor = sign;
    skip_blanks();
    if (number_length(std::string_view(text).substr(at)) > 0) {
        out.factor *= number();
        if (!take('*')) fail("*");
        skip_blanks();
    }
    const std::size_t length = name_length(std::string_view(text).substr(at));
    if (length == 0) fail("a quantity");
    out.name = text.substr(at, length);
    at += length;
    return out;
}

double SumReader::number() {
    const double sign = take('-') ? -1.0 : (take('+'), 1.0);
    skip_blanks();
    const std::string_view rest = std::string_view(text).substr(at);
    const std::size_t length = number_length(rest);
    const std::optional<double> value = number_of(rest.substr(0, length));
    if (!value || rest.starts_with('-') || rest.starts_with('+')) fail("a number");
    at += length;
    return sign * *value;
}

bool SumReader::take(char c) {
    skip_blanks();
    if (at == text.size() || text[at] != c) return false;
    ++at;
    return true;
}

void SumReader::end() {
    skip_blanks();
    if (at < text.size()) fail("the end");
}

void SumReader::skip_blanks() { at = std::min(text.find_first_not_of(" \t\r", at), text.size()); }

void SumReader::fail(const std::string& expected) const {
    throw BadCase(element::text("%s \"%s\": expected %s at character %d", what.c_str(),
                                text.c_str(), expected.c_str(), static_cast<int>(at) + 1));
}

}  // namespace element
