// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/words.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "adapters/mpm/step/text.hpp"

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

double Words::number(const std::string& what, mpm::Interval range) {
    const double value = number(what);
    if (!range.has(value))
        throw std::invalid_argument(what + " must be " + range.text() + ", got " +
                                    mpm::text(value));
    return value;
}

int Words::integer(const std::string& what, mpm::Interval range) {
    const double value = number(what, range);
    if (value != std::floor(value))
        throw std::invalid_argument(what + " must be an integer, got " + mpm::text(value));
    return static_cast<int>(value);
}

bool Words::yes_or_no(const std::string& what) {
    static constexpr mpm::Spelling words_for_it[] = {mpm::spelling("no", 0, ""),
                                                     mpm::spelling("yes", 1, "")};
    return choice(what, words_for_it) == 1;
}

int Words::choice(const std::string& what, mpm::Spellings known) {
    const std::string text = word(what);
    std::string all;
    for (const mpm::Spelling& spelling : known) {
        if (!spelling.in_fix) continue;
        if (text == spelling.word) return spelling.value;
        all += (all.empty() ? "" : ", ") + std::string(spelling.word);
    }
    throw std::invalid_argument(what + " must be one of " + all + ", got \"" + text + '"');
}

double Words::value(const std::string& what, const mpm::CaseWord& of) {
    switch (of.kind) {
        case mpm::Kind::yes_or_no: return yes_or_no(what) ? 1.0 : 0.0;
        case mpm::Kind::choice: return choice(what, of.words);
        case mpm::Kind::integer: return integer(what, of.range);
        default: return number(what, of);
    }
}

std::string no_name(std::string_view) { return {}; }

void refuse(const std::string& where, const mpm::Objections& objection, const mpm::KeyName& name) {
    if (objection) throw std::invalid_argument(where + name(objection->key) + objection->what);
}

}  // namespace grit::lammps
