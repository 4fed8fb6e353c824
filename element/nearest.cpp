// SPDX-License-Identifier: BSD-3-Clause
#include "element/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace element {
namespace {

std::string lower(std::string word) {
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

constexpr std::size_t longest_word = 200;  // that is likened to another

// Optimal string alignment distance.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t exchange = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, exchange});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = last;
        last = now;
    }
    return last[b.size()];
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t least = 0;
    if (word.size() > longest_word) return best;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > longest_word) continue;
        const std::size_t d = distance(lower(word), lower(candidate));
        if (2 * d > std::max(word.size(), candidate.size())) continue;
        if (best.empty() || d < least) {
            best = candidate;
            least = d;
        }
    }
    return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& candidates) {
    const std::string best = nearest(word, candidates);
    if (!best.empty()) return "; nearest: " + best;
    std::string known = "; known here:";
    for (const std::string& candidate : candidates)
        known += (candidate == candidates.front() ? " " : ", ") + candidate;
    return known;
}

}  // namespace element
