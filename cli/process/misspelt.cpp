// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/misspelt.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "element/nearest.hpp"

namespace cli {
namespace {

bool knows(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> out;
    for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; }))
        out.push_back(each->get_name());
    return out;
}

std::vector<std::string> options_of(const CLI::App& app) {
    std::vector<std::string> out;
    for (const CLI::Option* each : app.get_options())
        for (const std::string& name : each->get_lnames()) out.push_back("--" + name);
    return out;
}

}  // namespace

std::string misspelt(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* at = &app;
    std::string command = app.get_name();
    for (const std::string& word : words) {
        if (word == "--") break;
        if (word.size() == 2 && word[0] == '-' && word != "-h") {
            std::string alike;
            for (const std::string& option : options_of(*at))
                if (alike.empty() && option[2] == word[1]) alike = "; nearest: " + option;
            return fmt::format("{}: there is no option {}{}", command, word, alike);
        }
        if (word.starts_with("--")) {
            const std::string name = word.substr(0, word.find('='));
            const std::vector<std::string> known = options_of(*at);
            if (!knows(known, name))
                return fmt::format("{}: there is no option {}{}", command, name,
                                   element::suggestion(name, known));
            continue;
        }
        const std::vector<std::string> known = commands_of(*at);
        if (known.empty()) continue;  // a file
        if (!knows(known, word))
            return fmt::format("{}: there is no command \"{}\"{}", command, word,
                               element::suggestion(word, known));
        at = at->get_subcommand(word);
        command += ' ' + word;
    }
    return "";
}

}  // namespace cli
