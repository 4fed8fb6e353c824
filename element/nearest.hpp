// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace element {

// The candidate with the fewest letters to insert, delete, exchange or swap, capital or not; empty if
// none is alike, that is if more than half of the letters would have to change.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

// "; nearest: that" or, if nothing is alike, "; known here: a, b, c".
std::string suggestion(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace element
