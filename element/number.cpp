// SPDX-License-Identifier: BSD-3-Clause
#include "element/number.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace element {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view digits = "0123456789";

// First character from `at` that is none of these.
std::size_t behind(std::string_view text, std::size_t at, std::string_view skipped) {
    return std::min(text.find_first_not_of(skipped, at), text.size());
}

}  // namespace

std::size_t number_length(std::string_view text) {
    const std::size_t mantissa = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
    std::size_t at = behind(text, mantissa, digits);
    std::size_t count = at - mantissa;
    if (at < text.size() && text[at] == '.') {
        const std::size_t decimals = at + 1;
        at = behind(text, decimals, digits);
        count += at - decimals;
    }
    if (count == 0) return 0;
    if (at < text.size() && std::string_view("eEdD").find(text[at]) != std::string_view::npos) {
        std::size_t exponent = at + 1;
        if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
        if (const std::size_t end = behind(text, exponent, digits); end > exponent) at = end;
    }
    return at;
}

std::optional<double> number_of(std::string_view text) {
    text.remove_prefix(behind(text, 0, blanks));
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    if (text.empty() || number_length(text) != text.size()) return std::nullopt;
    std::string plain(text.substr(text.front() == '+' ? 1 : 0));
    for (char& c : plain)
        if (c == 'd' || c == 'D') c = 'e';
    double value = 0.0;
    const auto [end, problem] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (problem != std::errc() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace element
