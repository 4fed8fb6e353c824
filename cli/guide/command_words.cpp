// SPDX-License-Identifier: BSD-3-Clause
#include "cli/guide/command_words.hpp"

#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "element/sand_names.hpp"

namespace cli {
namespace {

// one_of tells its values as "{a,b}" in the type of the option.
std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t open = type.find('{'), close = type.rfind('}');
    std::vector<std::string> out;
    if (open == std::string::npos || close == std::string::npos) return out;
    std::istringstream words(type.substr(open + 1, close - open - 1));
    for (std::string word; std::getline(words, word, ',');) out.push_back(word);
    return out;
}

OptionWords option_words(const CLI::Option& option) {
    OptionWords out;
    for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
    if (out.names.empty()) out.names.push_back(option.get_name(true, false));
    out.description = option.get_description();
    out.takes_value = option.get_items_expected_max() > 0;
    out.repeats = option.get_items_expected_max() > 1 ||
                  option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    out.required = option.get_required();
    out.choices = choices_of(option);
    return out;
}

void walk(const CLI::App& app, CommandWords& out) {
    out.description = app.get_description();
    for (const CLI::Option* each : app.get_options())
        (each->get_positional() ? out.positionals : out.options).push_back(option_words(*each));
    const auto take_sands = [](OptionWords& words) {
        words.choices = element::sand_names();
        words.or_file = true;
    };
    if (out.name() == "grit sand show") take_sands(out.positionals.front());
    for (OptionWords& each : out.options)
        if (each.names.back() == "--sand") take_sands(each);
    for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (each->get_group().empty()) continue;
        CommandWords below;
        below.path = out.path;
        below.path.push_back(each->get_name());
        walk(*each, below);
        out.commands.push_back(std::move(below));
    }
}

}  // namespace

std::string CommandWords::name() const { return fmt::format("{}", fmt::join(path, " ")); }

CommandWords words_of(const CLI::App& app) {
    CommandWords out;
    out.path.push_back(app.get_name());
    walk(app, out);
    return out;
}

std::vector<const CommandWords*> flat(const CommandWords& command) {
    std::vector<const CommandWords*> out = {&command};
    for (const CommandWords& below : command.commands)
        for (const CommandWords* each : flat(below)) out.push_back(each);
    return out;
}

}  // namespace cli
