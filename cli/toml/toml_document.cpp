// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/toml_document.hpp"

#include <algorithm>
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
constexpr int most_key_dots =
    16;  // in a key: tables within tables, which the parser does not bound

[[noreturn]] void fail(const fs::path& path, const toml::node& node, const std::string& message) {
    throw BadInput(fmt::format("{}:{}: {}", path.string(), node.source().begin.line, message));
}

// Where a string that begins at a quotation mark ends: behind its last mark, or with the text or line if it has none.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    const char mark = text[at];
    const std::string three(3, mark);
    const bool of_lines = text.compare(at, 3, three) == 0;
    for (at += of_lines ? 3 : 1; at < text.size(); ++at) {
        if (text[at] == '\\' && mark == '"') ++at;
        else if (of_lines && text.compare(at, 3, three) == 0) return at + 3;
        else if (!of_lines && text[at] == mark) return at + 1;
        else if (!of_lines && text[at] == '\n') return at;
    }
    return text.size();
}

// What follows a table's tables, level by level, has a limit of levels to its stack.
void check_depth_of_keys(std::string_view text, const fs::path& path) {
    int line = 1, dots = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char each = text[at];
        if (each == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else if (each == '"' || each == '\'') {
            const std::size_t end = end_of_string(text, at);
            line +=
                static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                            text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            at = end;
        } else {
            if (each == '.' && ++dots > most_key_dots)
                throw BadInput(
                    fmt::format("{}:{}: a key has more than {} points, the most that is read",
                                path.string(), line, most_key_dots));
            if (std::string_view("=,[]{}\n").find(each) != std::string_view::npos) dots = 0;
            if (each == '\n') ++line;
            ++at;
        }
    }
}

toml::table parse(const fs::path& path) {
    try {
        const std::string text = grit::read_text_file(path, grit::longest_case);
        check_depth_of_keys(text, path);
        return toml::parse(text, path.string());
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
    std::string setting = {};  // of an option; empty: in a file

    [[noreturn]] void refuse(const std::string& message) const {
        if (!setting.empty()) throw BadInput(fmt::format("{}: {}", setting, message));
        fail(path, value, fmt::format("override \"{}\": {}", key, message));
    }
    // Of the key, behind what it begins with.
    std::string rest() const { return key.substr(key.rfind('.') + 1); }
    const char* base() const { return setting.empty() ? "the base" : "the case"; }
};

// --set may begin a table that the case has not; whoever reads the case knows whether there is such a table.
toml::table& begun(toml::table& at, const std::string& part, const Place& place) {
    toml::table made = toml::parse(fmt::format("'{}' = {{}}", part), place.setting);
    move_to(at, part, *made.get(part));
    return *at.get_as<toml::table>(part);
}

toml::table& step_into(toml::table& at, const std::string& part, const Place& place) {
    toml::node* next = at.get(part);
    if (!next) {
        std::vector<std::string> known;
        for (const auto& [key, node] : at) known.emplace_back(key.str());
        if (!place.setting.empty() && element::nearest(part, known).empty())
            return begun(at, part, place);
        place.refuse(
            fmt::format("{} has no {}{}", place.base(), part, element::suggestion(part, known)));
    }
    if (toml::table* table = next->as_table()) return *table;
    place.refuse(part + " is no table");
}

// Of [[list]] the table that has this name or number.
toml::table& step_into(toml::array& list, const std::string& name, const std::string& which,
                       const Place& place) {
    if (which.empty())
        place.refuse(
            fmt::format("which [[{0}]], by name or number, as in {0}.1.{1}?", name, place.rest()));
    if (toml::table* table = element_of(list, which)) return *table;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (const toml::table* each = list.get_as<toml::table>(i))
            known.push_back(each->at_path("name").value_or(std::to_string(i + 1)));
    place.refuse(fmt::format("no [[{}]] of {} has the name or number {}{}", name, place.base(),
                             which, element::suggestion(which, known)));
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
        at = &step_into(*list, part, next == std::string::npos ? "" : rest.substr(0, next), place);
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

void set(toml::table& document, const CaseSetting& setting) {
    const fs::path here = setting.option;
    const std::size_t equals = setting.text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.text.size())
        throw BadInput(fmt::format("{} needs KEY=VALUE, got \"{}\"", setting.option, setting.text));
    const std::string key = setting.text.substr(0, equals), text = setting.text.substr(equals + 1);
    if (setting.text.find_first_of("'\n") < equals)
        throw BadInput(fmt::format("{}: \"{}\" is no key", setting.option, key));
    const std::string whole = setting.option + " " + setting.text;
    toml::table value;
    try {
        value = toml::parse("value = " + text, whole);
    } catch (const toml::parse_error&) {
        if (text.find_first_of("'\n") != std::string::npos)
            throw BadInput(fmt::format("{}: this is no value of TOML", whole));
        value = toml::parse(fmt::format("value = '{}'", text), whole);
    }
    apply(document, *value.get("value"), {here, *value.get("value"), key, whole});
}

}  // namespace

std::shared_ptr<const toml::table> parse_document(const fs::path& path,
                                                  std::vector<fs::path>* inputs,
                                                  const std::vector<CaseSetting>& settings) {
    toml::table document = parse_all(path, inputs, 0);
    for (const CaseSetting& setting : settings) set(document, setting);
    return std::make_shared<const toml::table>(std::move(document));
}

}  // namespace cli
