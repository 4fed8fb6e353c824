// SPDX-License-Identifier: BSD-3-Clause
// Keys of material-point cases, read as the table of their words says: in SI units, within their range.
#pragma once

#include <optional>
#include <span>

#include <adapters/mpm/case/case_words.hpp>
#include <adapters/mpm/case/rules.hpp>

#include "cli/toml/toml_table.hpp"

namespace cli {

// The table is the one that the key stands in.
double number(TomlTable& table, const grit::mpm::CaseWord& word);
std::optional<double> number_if(TomlTable& table, const grit::mpm::CaseWord& word);
int integer(TomlTable& table, const grit::mpm::CaseWord& word);
// ... or what the word says where it is not given.
double number_or_default(TomlTable& table, const grit::mpm::CaseWord& word);
int integer_or_default(TomlTable& table, const grit::mpm::CaseWord& word);
// The value of a word.
int choice(TomlTable& table, const grit::mpm::CaseWord& word);
std::optional<int> choice_if(TomlTable& table, const grit::mpm::CaseWord& word);

// Sets what is given.
template <class Plan>
void read_member(TomlTable& table, const grit::mpm::Member<Plan>& member, Plan& plan) {
    const grit::mpm::CaseWord& word = *member.word;
    const std::string key(word.key);
    using grit::mpm::Kind;
    if (!table.has(key)) return;
    switch (word.kind) {
        case Kind::yes_or_no: return member.set(plan, table.boolean_or(key, false) ? 1.0 : 0.0);
        case Kind::choice: return member.set(plan, choice(table, word));
        case Kind::integer: return member.set(plan, integer(table, word));
        default: member.set(plan, number(table, word));
    }
}

// All of a section.
template <class Plan>
void read_members(TomlTable& table, std::string_view section,
                  std::span<const grit::mpm::Member<Plan>> members, Plan& plan) {
    for (const grit::mpm::Member<Plan>& member : members)
        if (member.word->section == section) read_member(table, member, plan);
}

// Refuses what is objected to.
void refuse(const TomlTable& table, const grit::mpm::Objections& objection);
// Keys are called as they are.
std::string same_name(std::string_view key);

}  // namespace cli
