// SPDX-License-Identifier: BSD-3-Clause
#include "incremental_driver/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace incremental_driver {
namespace {

constexpr std::size_t near = 4;  // letters to change

std::string lower(std::string word) {
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

// Levenshtein's, of one row.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string did_you_mean(const std::string& name, const std::vector<std::string>& known) {
    const auto away = [&](const std::string& word) { return distance(lower(name), lower(word)); };
    const auto best = std::min_element(
        known.begin(), known.end(),
        [&](const std::string& a, const std::string& b) { return away(a) < away(b); });
    if (away(*best) <= near) return "did you mean " + *best + "?";
    std::string all = "known are";
    for (const std::string& word : known) all += " " + word;
    return all;
}

}  // namespace incremental_driver
