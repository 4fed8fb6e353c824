// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/words.hpp"

#include <fmt/format.h>

namespace cli {

using grit::mpm::CaseWord;
using grit::mpm::Spelling;

std::optional<double> number_if(TomlTable& table, const CaseWord& word) {
    const std::string key(word.key);
    const std::optional<double> value = table.number_if(key);
    if (!value) return {};
    if (!word.range.has(*value))
        table.fail(key, fmt::format("{} must be {}, got {:g}", table.full(key), word.range.text(),
                                    *value));
    return word.si * *value;
}

double number(TomlTable& table, const CaseWord& word) {
    if (const auto value = number_if(table, word)) return *value;
    return table.number(std::string(word.key));  // says that it is missing
}

int integer(TomlTable& table, const CaseWord& word) {
    const std::string key(word.key);
    if (!table.has(key)) table.number(key);  // says that it is missing
    return table.integer_or(key, 0, static_cast<int>(word.range.low),
                            static_cast<int>(word.range.high));
}

double number_or_default(TomlTable& table, const CaseWord& word) {
    return number_if(table, word).value_or(word.otherwise_number());
}

int integer_or_default(TomlTable& table, const CaseWord& word) {
    if (table.has(std::string(word.key))) return integer(table, word);
    return static_cast<int>(word.otherwise_number());
}

int choice(TomlTable& table, const CaseWord& word) {
    std::vector<std::string> known;
    for (const Spelling& spelling : word.words) known.emplace_back(spelling.word);
    const std::string chosen = table.choice(std::string(word.key), known);
    for (const Spelling& spelling : word.words)
        if (spelling.word == chosen) return spelling.value;
    return 0;
}

std::optional<int> choice_if(TomlTable& table, const CaseWord& word) {
    if (!table.has(std::string(word.key))) return {};
    return choice(table, word);
}

void refuse(const TomlTable& table, const grit::mpm::Objections& objection) {
    if (!objection) return;
    const std::string key(objection->key);
    table.fail(key, table.full(key) + objection->what);
}

std::string same_name(std::string_view key) { return std::string(key); }

}  // namespace cli
