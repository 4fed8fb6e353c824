// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/toml_document.hpp"

#include <charconv>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"
#include "element/nearest.hpp"
#include "support/tables/text_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 8;  // bases of bases

[[noreturn]] void fail(const fs::path& path, const toml::node& node, const std::string& message) {
    throw BadInput(fmt::format("{}:{}: {}", path.string(), node.source().begin.line, message));
}

toml::table parse(const fs::path& path) {
    try {
        return toml::parse(grit::read_text_file(path, grit::longest_case), path.string());
    } catch (const grit::TextFileError& error) {
        throw BadInput(error.what());
    } catch (const toml::parse_error& error) {
        throw BadInput(fmt::format("{}:{}: {}", path.string(), error.source().begin.line,
                                   error.description()));
    }
}

// Copies would forget the lines they stand on.
void move_to(toml::table& table, std::string_view key, toml::node& node) {
    node.visit([&](auto& value) { table.insert_or_assign(key, std::move(value)); });
}

// The table of a list that has this name, or this number from 1; null: none.
toml::table* element_of(toml::array& list, const std::string& part) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    const bool counted = error == std::errc{} && end == part.data() + part.size();
    for (std::size_t i = 0; i < list.size(); ++i) {
        toml::table* table = list.get_as<toml::table>(i);
        if (table && (counted ? i + 1 == number : table->at_path("name").value_or("") == part))
            return table;
    }
    return nullptr;
}

// Of one override: where it is written, and all of its key.
struct Place {
    const fs::path& path;
    const toml::node& value;
    const std::string& key;
};

toml::table& step_into(toml::table& at, const std::string& part, const Place& place) {
    toml::node* next = at.get(part);
    if (!next) {
        std::vector<std::string> known;
        for (const auto& [key, node] : at) known.emplace_back(key.str());
        fail(place.path, place.value,
             fmt::format("override \"{}\": the base has no {}{}", place.key, part,
                         element::suggestion(part, known)));
    }
    if (toml::table* table = next->as_table()) return *table;
    fail(place.path, place.value, fmt::format("override \"{}\": {} is no table", place.key, part));
}

void apply(toml::table& base, toml::node& value, const Place& place) {
    toml::table* at = &base;
    std::string rest = place.key;
    for (std::size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
        const std::string part = rest.substr(0, dot);
        rest = rest.substr(dot + 1);
        toml::array* list = at->get_as<toml::array>(part);
        if (!list) {
            at = &step_into(*at, part, place);
            continue;
        }
        const std::size_t next = rest.find('.');
        const std::string which = rest.substr(0, next);
        toml::table* element = next == std::string::npos ? nullptr : element_of(*list, which);
        if (!element)
            fail(place.path, place.value,
                 fmt::format("override \"{}\": no [[{}]] of the base has the name or number {}",
                             place.key, part, which));
        at = element;
        rest = rest.substr(next + 1);
    }
    move_to(*at, rest, value);
}

toml::table parse_all(const fs::path& path, std::vector<fs::path>* inputs, int depth) {
    toml::table own = parse(path);
    if (inputs) inputs->push_back(path);
    const toml::node* base_key = own.get("base");
    if (!base_key) return own;
    const auto base_name = base_key->value_exact<std::string>();
    if (!base_name) fail(path, *base_key, "base must be the name of a file");
    if (depth == deepest) fail(path, *base_key, "bases of bases: too many, or a circle");
    for (const auto& [key, node] : own)
        if (key != "base" && key != "name" && key != "title" && key != "override")
            fail(path, node,
                 fmt::format("unknown key {}: a file with a base has name, title and [override] "
                             "besides",
                             key.str()));
    toml::table base = parse_all(path.parent_path() / *base_name, inputs, depth + 1);
    for (const char* key : {"name", "title"}) {
        base.erase(key);
        if (toml::node* node = own.get(key)) move_to(base, key, *node);
    }
    if (toml::node* node = own.get("override")) {
        if (!node->is_table()) fail(path, *node, "override must be a table: [override]");
        for (auto&& [name, value] : *node->as_table()) {
            const std::string key(name.str());
            apply(base, value, {path, value, key});
        }
    }
    return base;
}

// "KEY=VALUE".
void set(toml::table& document, const std::string& setting) {
    static const fs::path here = "--set";
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size())
        throw BadInput(fmt::format("--set needs KEY=VALUE, got \"{}\"", setting));
    const std::string key = setting.substr(0, equals), text = setting.substr(equals + 1);
    toml::table value;
    try {
        value = toml::parse("value = " + text, "--set " + setting);
    } catch (const toml::parse_error&) {
        value.insert("value", text);
    }
    apply(document, *value.get("value"), {here, *value.get("value"), key});
}

}  // namespace

std::shared_ptr<const toml::table> parse_document(const fs::path& path,
                                                  std::vector<fs::path>* inputs,
                                                  const std::vector<std::string>& settings) {
    toml::table document = parse_all(path, inputs, 0);
    for (const std::string& setting : settings) set(document, setting);
    return std::make_shared<const toml::table>(std::move(document));
}

}  // namespace cli
