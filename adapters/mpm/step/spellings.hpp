// SPDX-License-Identifier: BSD-3-Clause
// How enumerations are spelt, in files and in fix grit/mpm: those of a step.
#pragma once

#include <span>
#include <string_view>

#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

// A word of an enumeration.
struct Spelling {
    std::string_view word;
    int value;
    const char* text;
    bool in_fix = true;  // fix grit/mpm has it too
};
using Spellings = std::span<const Spelling>;

template <class Value>
constexpr Spelling spelling(const char* word, Value value, const char* text) {
    return {word, static_cast<int>(value), text};
}
constexpr Spelling only_in_files(Spelling spelling) {
    spelling.in_fix = false;
    return spelling;
}

namespace words {

inline constexpr Spelling shapes[] = {
    spelling("cpdi", Shape::cpdi, "corners weighted by their radii"),
    spelling("cpdi_published", Shape::cpdi_published, "unweighted corners"),
    spelling("ugimp", Shape::ugimp,
             "the undeformed, upright domain, no thinner than a quarter of a cell"),
    spelling("linear", Shape::point, "at the particle: the original method")};
inline constexpr Spelling schemes[] = {
    spelling("usl", Scheme::usl, "stress last"),
    spelling("musl", Scheme::musl, "stress last, by velocities mapped back from the particles"),
    spelling("usf", Scheme::usf, "stress first")};

}  // namespace words

// The word of a value that is among them.
std::string_view word_of(Spellings words, int value);
template <class Value> std::string_view word_of(Spellings words, Value value) {
    return word_of(words, static_cast<int>(value));
}

}  // namespace grit::mpm
