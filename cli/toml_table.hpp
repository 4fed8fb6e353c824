// SPDX-License-Identifier: BSD-3-Clause
// A TOML table read strictly: what is asked for must have its type, what is left is an error.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <toml++/toml.h>

namespace cli {

class TomlTable {
  public:
    // path: of the file, for messages. name: of the table, "" for the root.
    TomlTable(const toml::table& values, std::string path, std::string name);

    bool has(const std::string& key);
    double number(const std::string& key);
    std::optional<double> number_if(const std::string& key);
    int integer_or(const std::string& key, int otherwise);
    std::string string(const std::string& key);
    std::optional<std::string> string_if(const std::string& key);
    TomlTable table(const std::string& key);
    std::optional<TomlTable> table_if(const std::string& key);

    // Refuse keys nobody has asked for; lists those that were.
    void finish() const;

    // Throw BadInput at the line of a key, or of the table if it is missing.
    [[noreturn]] void fail(const std::string& key, const std::string& message) const;

  private:
    const toml::node* find(const std::string& key);
    const toml::node& require(const std::string& key);
    std::string full(const std::string& key) const;

    const toml::table& values;
    std::string path;
    std::string name;
    std::set<std::string> known;
};

}  // namespace cli
