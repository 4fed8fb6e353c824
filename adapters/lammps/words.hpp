// SPDX-License-Identifier: GPL-2.0-only
// The words of a command, one after the other.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "adapters/mpm/case/case_words.hpp"
#include "adapters/mpm/case/rules.hpp"

namespace grit::lammps {

// All of these throw std::invalid_argument that says what was expected and what is there.
class Words {
  public:
    explicit Words(std::vector<std::string> given) : words(std::move(given)) {}

    bool done() const { return at == words.size(); }
    // The next word is this one; it is taken then.
    bool take(const std::string& word);
    const std::string& peek() const;
    // How many are taken, and what they are from one of them on, each with an end of line behind.
    std::size_t taken() const { return at; }
    std::string taken_since(std::size_t first) const;
    std::string word(const std::string& what);
    double number(const std::string& what);
    // A number within limits.
    double number(const std::string& what, mpm::Interval range);
    // ... of a key of cases, in SI units.
    double number(const std::string& what, const mpm::CaseWord& word) {
        return number(what, word.si_range());
    }
    int integer(const std::string& what, mpm::Interval range);
    bool yes_or_no(const std::string& what);
    // The value of one of these words.
    int choice(const std::string& what, mpm::Spellings known);
    // What the word of a member says.
    template <class Plan>
    void read(const std::string& what, const mpm::Member<Plan>& member, Plan& plan) {
        member.set(plan, value(what, *member.word));
    }

  private:
    double value(const std::string& what, const mpm::CaseWord& word);

    std::vector<std::string> words;
    std::size_t at = 0;
};

// The first member with this word; null: none.
template <class Plan>
const mpm::Member<Plan>* member_called(std::span<const mpm::Member<Plan>> members,
                                       const std::string& word) {
    for (const mpm::Member<Plan>& member : members)
        if (!member.fix.empty() && member.fix == word) return &member;
    return nullptr;
}

// Where that says the key already.
std::string no_name(std::string_view key);
// Throws std::invalid_argument for what is objected to, in front of which where is said.
void refuse(const std::string& where, const mpm::Objections& objection, const mpm::KeyName& name);

}  // namespace grit::lammps
