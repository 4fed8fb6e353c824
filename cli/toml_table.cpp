// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml_table.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/exit_code.hpp"

namespace cli {

TomlTable::TomlTable(const toml::table& table_values, std::string file, std::string table_name)
    : values(table_values), path(std::move(file)), name(std::move(table_name)) {}

std::string TomlTable::full(const std::string& key) const {
    return name.empty() ? key : name + "." + key;
}

void TomlTable::fail(const std::string& key, const std::string& message) const {
    const toml::node* node = values.get(key);
    const auto line = (node ? node->source() : values.source()).begin.line;
    throw BadInput(line ? fmt::format("{}:{}: {}", path, line, message)
                        : fmt::format("{}: {}", path, message));
}

const toml::node* TomlTable::find(const std::string& key) {
    known.insert(key);
    return values.get(key);
}

const toml::node& TomlTable::require(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) {
        std::vector<std::string> given;
        for (const auto& [k, value] : values) given.emplace_back(k.str());
        fail(key, fmt::format("{} is missing; given here: {}", full(key), fmt::join(given, ", ")));
    }
    return *node;
}

bool TomlTable::has(const std::string& key) { return find(key) != nullptr; }

double TomlTable::number(const std::string& key) {
    const std::optional<double> value = require(key).value<double>();
    if (!value || !require(key).is_number()) fail(key, full(key) + " must be a number");
    if (!std::isfinite(*value))
        fail(key, fmt::format("{} must be finite, got {}", full(key), *value));
    return *value;
}

std::optional<double> TomlTable::number_if(const std::string& key) {
    return has(key) ? std::optional(number(key)) : std::nullopt;
}

int TomlTable::integer_or(const std::string& key, int otherwise) {
    if (!has(key)) return otherwise;
    const toml::node& node = require(key);
    if (!node.is_integer()) fail(key, full(key) + " must be an integer");
    const auto value = node.value<std::int64_t>().value();
    constexpr std::int64_t limit = std::numeric_limits<int>::max();
    if (value < -limit || value > limit)
        fail(key, fmt::format("{} must be within +-{}, got {}", full(key), limit, value));
    return static_cast<int>(value);
}

std::string TomlTable::string(const std::string& key) {
    const toml::node& node = require(key);
    if (!node.is_string()) fail(key, full(key) + " must be a string");
    const std::string value = node.value<std::string>().value();
    for (const char c : value)
        if (static_cast<unsigned char>(c) < 0x20) fail(key, full(key) + " must be a single line");
    return value;
}

std::optional<std::string> TomlTable::string_if(const std::string& key) {
    return has(key) ? std::optional(string(key)) : std::nullopt;
}

TomlTable TomlTable::table(const std::string& key) {
    const toml::table* inner = require(key).as_table();
    if (!inner) fail(key, full(key) + " must be a table: [" + full(key) + "]");
    return {*inner, path, full(key)};
}

std::optional<TomlTable> TomlTable::table_if(const std::string& key) {
    return has(key) ? std::optional(table(key)) : std::nullopt;
}

void TomlTable::finish() const {
    for (const auto& [key, node] : values)
        if (const std::string k{key.str()}; !known.contains(k))
            fail(k, fmt::format("unknown key {}; known here: {}", full(k), fmt::join(known, ", ")));
}

}  // namespace cli
