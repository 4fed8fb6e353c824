// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/words.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "adapters/mpm/io/text.hpp"

namespace grit::lammps {

bool Words::take(const std::string& word) {
    if (done() || words[at] != word) return false;
    ++at;
    return true;
}

const std::string& Words::peek() const {
    static const std::string nothing;
    return done() ? nothing : words[at];
}

std::string Words::taken_since(std::size_t first) const {
    std::string out;
    for (std::size_t i = first; i < at; ++i) out += words[i] + '\n';
    return out;
}

std::string Words::word(const std::string& what) {
    if (done()) throw std::invalid_argument("the command ends where " + what + " is expected");
    return words[at++];
}

double Words::number(const std::string& what) {
    const std::string text = word(what);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !std::isfinite(value))
        throw std::invalid_argument(what + " must be a number, got \"" + text + '"');
    return value;
}

double Words::number(const std::string& what, mpm::limits::Range range) {
    const double value = number(what);
    if (!(value >= range.low && value <= range.high))
        throw std::invalid_argument(what + " must be in [" + mpm::text(range.low) + ", " +
                                    mpm::text(range.high) + "], got " + mpm::text(value));
    return value;
}

double Words::positive(const std::string& what) {
    const double value = number(what);
    if (!(value > 0.0)) throw std::invalid_argument(what + " must be > 0, got " + mpm::text(value));
    return value;
}

int Words::integer(const std::string& what, mpm::limits::Range range) {
    const double value = number(what, range);
    if (value != std::floor(value)) throw std::invalid_argument(what + " must be an integer");
    return static_cast<int>(value);
}

bool Words::yes_or_no(const std::string& what) { return choice(what, {"no", "yes"}) == 1; }

int Words::choice(const std::string& what, std::initializer_list<const char*> names) {
    const std::string text = word(what);
    std::string all;
    int i = 0;
    for (const char* name : names) {
        if (text == name) return i;
        all += (i++ == 0 ? "" : ", ") + std::string(name);
    }
    throw std::invalid_argument(what + " must be one of " + all + ", got \"" + text + '"');
}

}  // namespace grit::lammps
