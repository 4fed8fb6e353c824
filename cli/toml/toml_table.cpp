// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/toml_table.hpp"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/process/exit_code.hpp"
#include "cli/toml/toml_document.hpp"
#include "element/nearest.hpp"
#include "element/number.hpp"

namespace cli {

struct TomlTable::Content {
    std::shared_ptr<const toml::table> document;  // owns values
    const toml::table* values;
    const OtherNames* names;  // null: none

    // As the file has it.
    std::string spelled(const std::string& key) const {
        if (!names) return key;
        const auto other = names->find(key);
        return other == names->end() || !values->get(other->second) ? key : other->second;
    }
    const toml::node* get(const std::string& key) const { return values->get(spelled(key)); }
};

namespace {

bool is_list_of_tables(const toml::node& node) {
    const toml::array* const list = node.as_array();
    return list && !list->empty() && list->is_homogeneous(toml::node_type::table);
}

void add_values(const toml::table& table, const std::string& before,
                std::map<std::string, std::string>& out) {
    for (const auto& [key, node] : table) {
        const std::string name = before + std::string(key.str());
        if (const toml::table* inner = node.as_table()) {
            add_values(*inner, name + ".", out);
        } else if (is_list_of_tables(node)) {
            const toml::array& list = *node.as_array();
            std::string names;
            for (std::size_t i = 0; i < list.size(); ++i) {
                const toml::table& each = *list.get_as<toml::table>(i);
                const std::string which = each.at_path("name").value_or(std::to_string(i + 1));
                names += (names.empty() ? "" : ", ") + which;
                add_values(each, name + "." + which + ".", out);
            }
            out[name] = names;
        } else {
            std::ostringstream text;
            node.visit([&text](const auto& value) { text << value; });
            out[name] = text.str();
        }
    }
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<const Content> table_content, std::string file,
                     std::string table_name, const SampleRow* row)
    : content(std::move(table_content)), path(std::move(file)), name(std::move(table_name)),
      columns(row) {}

TomlTable TomlTable::of_file(const std::filesystem::path& path,
                             std::vector<std::filesystem::path>* inputs,
                             const std::vector<CaseSetting>& settings) {
    const std::shared_ptr<const toml::table> document = parse_document(path, inputs, settings);
    return {std::make_shared<const Content>(Content{document, document.get(), nullptr}),
            path.string(), "", nullptr};
}

std::string TomlTable::full(const std::string& key) const {
    return name + (name.empty() || key.empty() ? "" : ".") + content->spelled(key);
}

void TomlTable::take_names_from(const OtherNames& names) {
    content = std::make_shared<const Content>(Content{content->document, content->values, &names});
}

std::filesystem::path TomlTable::folder_of(const std::string& key) const {
    const toml::node* node = content->get(key);
    const bool is_of_file = node && node->source().path && !node->source().path->starts_with("--");
    return std::filesystem::path(is_of_file ? *node->source().path : path).parent_path();
}

std::map<std::string, std::string> TomlTable::values() const {
    std::map<std::string, std::string> out;
    add_values(*content->values, "", out);
    return out;
}

void TomlTable::fail(const std::string& key, const std::string& message) const {
    const toml::node* node = content->get(key);
    const toml::source_region& source = node ? node->source() : content->values->source();
    const auto line = source.begin.line;
    const std::string& file = source.path ? *source.path : path;  // its own, or that of its base
    const std::string sample = columns ? fmt::format("sample {}: ", columns->name) : "";
    const bool has_lines = line && !file.starts_with("--");  // of no option
    throw BadInput(has_lines ? fmt::format("{}:{}: {}{}", file, line, sample, message)
                             : fmt::format("{}: {}{}", file, sample, message));
}

void TomlTable::refuse_case_of(const std::string& command) const {
    const char* const own = command == "grit mpm" ? "grid" : "start";
    if (content->values->get(own)) fail(own, fmt::format("{}: this is a case of {}", own, command));
}

bool TomlTable::has(const std::string& key) {
    const std::string here = content->spelled(key);
    known.insert(key);
    known.insert(here);
    if (here != key && content->values->get(key))
        fail(key, fmt::format("give {} or {}, not both", full(key), key));
    return content->get(key) != nullptr;
}

// Where a key is missing, one that looks like it and means nothing else is the better message.
void TomlTable::refuse_misspelt(const std::string& key) const {
    for (const std::string& other : given())
        if (!known.contains(other) && element::nearest(other, {key}) == key)
            fail(other, fmt::format("unknown key {}; nearest: {}", full(other), key));
}

void TomlTable::require(const std::string& key) {
    if (has(key)) return;
    refuse_misspelt(key);
    fail(key, fmt::format("{} is missing{}", full(key),
                          given().empty() ? std::string()
                                          : fmt::format("; given: {}", fmt::join(given(), ", "))));
}

std::optional<double> TomlTable::column_of(const std::string& key, const std::string& text) const {
    if (!columns || !text.starts_with("column ")) return std::nullopt;
    const auto cell = columns->cells.find(text.substr(7));
    if (cell == columns->cells.end()) {
        std::vector<std::string> names;
        for (const auto& [column, value] : columns->cells) names.push_back(column);
        fail(key, fmt::format("{}: the samples have no column {}{}", full(key), text.substr(7),
                              element::suggestion(text.substr(7), names)));
    }
    const std::optional<double> value = element::number_of(cell->second);
    if (!value)
        fail(key, fmt::format("{}: column {} has \"{}\" where a number is needed", full(key),
                              cell->first, cell->second));
    return value;
}

std::optional<double> TomlTable::value_of(const std::string& key, std::ptrdiff_t place) const {
    const toml::node* whole = content->get(key);
    const toml::node& node =
        place < 0 ? *whole : *whole->as_array()->get(static_cast<std::size_t>(place));
    if (node.is_number()) return node.value<double>();
    if (node.is_string()) return column_of(key, node.value<std::string>().value());
    return std::nullopt;
}

double TomlTable::number(const std::string& key) {
    require(key);
    const std::optional<double> value = value_of(key);
    if (!value) fail(key, full(key) + " must be a number");
    if (!std::isfinite(*value))
        fail(key, fmt::format("{} must be finite, got {}", full(key), *value));
    return *value;
}

std::optional<double> TomlTable::number_if(const std::string& key) {
    return has(key) ? std::optional(number(key)) : std::nullopt;
}

double TomlTable::positive_or(const std::string& key, double otherwise) {
    const double value = number_if(key).value_or(otherwise);
    if (has(key) && !(value > 0.0))
        fail(key, fmt::format("{} must be > 0, got {:g}", full(key), value));
    return value;
}

int TomlTable::integer_or(const std::string& key, int otherwise, int lowest, int highest) {
    if (!has(key)) return otherwise;
    const toml::node& node = *content->get(key);
    const std::optional<double> value = node.is_floating_point() ? std::nullopt : value_of(key);
    if (!value || *value != std::floor(*value)) fail(key, full(key) + " must be an integer");
    if (!(*value >= lowest && *value <= highest))
        fail(key,
             fmt::format("{} must be in [{}, {}], got {:.0f}", full(key), lowest, highest, *value));
    return static_cast<int>(*value);
}

bool TomlTable::boolean_or(const std::string& key, bool otherwise) {
    if (!has(key)) return otherwise;
    const std::optional<bool> value = content->get(key)->value_exact<bool>();
    if (!value) fail(key, full(key) + " must be true or false");
    return *value;
}

std::string TomlTable::string(const std::string& key) {
    require(key);
    const std::optional<std::string> value = content->get(key)->value_exact<std::string>();
    if (!value) fail(key, full(key) + " must be a string");
    for (const char c : *value)
        if (static_cast<unsigned char>(c) < 0x20) fail(key, full(key) + " must be a single line");
    return *value;
}

std::optional<std::string> TomlTable::string_if(const std::string& key) {
    return has(key) ? std::optional(string(key)) : std::nullopt;
}

std::string TomlTable::choice(const std::string& key, const std::vector<std::string>& words) {
    const std::string word = string(key);
    for (const std::string& known_word : words)
        if (word == known_word) return word;
    const std::string best = element::nearest(word, words);
    fail(key, fmt::format("{} must be one of {}; got \"{}\"{}", full(key), fmt::join(words, ", "),
                          word, best.empty() ? "" : "; nearest: " + best));
}

std::vector<double> TomlTable::numbers(const std::string& key, std::size_t size) {
    require(key);
    const toml::array* array = content->get(key)->as_array();
    const std::string wanted =
        size ? fmt::format("a list of {} numbers", size) : std::string("a list of numbers");
    if (!array) fail(key, fmt::format("{} must be {}", full(key), wanted));
    std::vector<double> out;
    for (std::size_t i = 0; i < array->size(); ++i) {
        const std::optional<double> value = value_of(key, static_cast<std::ptrdiff_t>(i));
        if (!value || !std::isfinite(*value))
            fail(key, fmt::format("{} must be {}: number {} is none", full(key), wanted,
                                  out.size() + 1));
        out.push_back(*value);
    }
    if (size && out.size() != size)
        fail(key, fmt::format("{} must be {}, got {}", full(key), wanted, out.size()));
    return out;
}

std::optional<std::vector<double>> TomlTable::numbers_if(const std::string& key, std::size_t size) {
    return has(key) ? std::optional(numbers(key, size)) : std::nullopt;
}

std::vector<std::string> TomlTable::strings_or_none(const std::string& key) {
    if (!has(key)) return {};
    const toml::array* array = content->get(key)->as_array();
    if (!array) return {string(key)};
    std::vector<std::string> out;
    for (const toml::node& node : *array) {
        const std::optional<std::string> value = node.value_exact<std::string>();
        if (!value) fail(key, full(key) + " must be a string or a list of strings");
        out.push_back(*value);
    }
    return out;
}

TomlTable TomlTable::table(const std::string& key) {
    require(key);
    const toml::table* inner = content->get(key)->as_table();
    if (!inner) fail(key, fmt::format("{} must be a table: [{}]", full(key), full(key)));
    return {std::make_shared<const Content>(Content{content->document, inner, content->names}),
            path, full(key), columns};
}

std::optional<TomlTable> TomlTable::table_if(const std::string& key) {
    return has(key) ? std::optional(table(key)) : std::nullopt;
}

std::vector<TomlTable> TomlTable::tables_if(const std::string& key) {
    std::vector<TomlTable> out;
    if (!has(key)) return out;
    const toml::array* array = content->get(key)->as_array();
    if (!array) fail(key, fmt::format("{} must be written [[{}]]", full(key), full(key)));
    for (const toml::node& node : *array) {
        if (!node.is_table())
            fail(key, fmt::format("{} must be written [[{}]]", full(key), full(key)));
        out.push_back(TomlTable(std::make_shared<const Content>(
                                    Content{content->document, node.as_table(), content->names}),
                                path, fmt::format("{}[{}]", full(key), out.size() + 1), columns));
    }
    return out;
}

std::vector<std::string> TomlTable::given() const {
    std::vector<std::string> out;
    for (const auto& [key, node] : *content->values) out.emplace_back(key.str());
    return out;
}

std::optional<std::string> TomlTable::one_of_if(const std::vector<std::string>& keys) {
    std::optional<std::string> found;
    for (const std::string& key : keys) {
        if (!has(key)) continue;
        if (found) fail(key, fmt::format("give {} or {}, not both", full(*found), full(key)));
        found = key;
    }
    return found;
}

std::string TomlTable::one_of(const std::vector<std::string>& keys) {
    if (const std::optional<std::string> found = one_of_if(keys)) return *found;
    for (const std::string& key : keys) refuse_misspelt(key);
    fail("", fmt::format("{} is missing", fmt::join(keys, " or ")) +
                 (name.empty() ? "" : " in " + name));
}

void TomlTable::finish() const {
    for (const std::string& key : given())
        if (!known.contains(key))
            fail(key, fmt::format("unknown key {}{}", full(key),
                                  element::suggestion(key, {known.begin(), known.end()})));
}

}  // namespace cli
