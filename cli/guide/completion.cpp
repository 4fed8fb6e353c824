// SPDX-License-Identifier: BSD-3-Clause
#include "cli/guide/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cli {
namespace {

std::vector<std::string> command_names(const CommandWords& command) {
    std::vector<std::string> out;
    for (const CommandWords& below : command.commands) out.push_back(below.path.back());
    return out;
}

std::vector<std::string> option_names(const CommandWords& command) {
    std::vector<std::string> out;
    for (const OptionWords& option : command.options)
        out.insert(out.end(), option.names.begin(), option.names.end());
    return out;
}

// What may stand where no option does: commands, or the choices of the first argument.
std::vector<std::string> plain_words(const CommandWords& command) {
    if (!command.commands.empty()) return command_names(command);
    return command.positionals.empty() ? std::vector<std::string>{}
                                       : command.positionals.front().choices;
}

// 'text' for a shell; inner quotes as QUOTE says.
std::string quoted(const std::string& text, const char* quote) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string(quote) : std::string(1, c);
    return out + "'";
}

// The command that the words before the cursor name, in variable "at".
std::string bash(const CommandWords& grit) {
    std::string names, cases;
    for (const CommandWords* command : flat(grit)) {
        for (const CommandWords& below : command->commands)
            names += fmt::format("            '{} {}') at='{}' ;;\n", command->name(),
                                 below.path.back(), below.name());
        std::string values, silent;
        for (const OptionWords& option : command->options) {
            if (!option.takes_value) continue;
            if (option.choices.empty())
                silent +=
                    fmt::format("{}{}", silent.empty() ? "" : "|", fmt::join(option.names, "|"));
            else
                values += fmt::format("                {}) words='{}' ;;\n",
                                      fmt::join(option.names, "|"), fmt::join(option.choices, " "));
        }
        if (!silent.empty()) values += fmt::format("                {}) words= ;;\n", silent);
        cases += fmt::format(
            "        '{}')\n            words='{}'\n            [[ $word == -* ]] && words='{}'\n"
            "            case $before in\n{}                *) ;;\n            esac ;;\n",
            command->name(), fmt::join(plain_words(*command), " "),
            fmt::join(option_names(*command), " "), values);
    }
    return fmt::format(R"(# bash completion of grit, printed by: grit completion bash
_grit() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} at=grit words= i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$at ${{COMP_WORDS[i]}}" in
{}        esac
    done
    case $at in
{}    esac
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _grit grit
)",
                       names, cases);
}

std::string fish(const CommandWords& grit) {
    std::string out = "# fish completion of grit, printed by: grit completion fish\n";
    for (const CommandWords* command : flat(grit)) {
        std::string seen;
        for (std::size_t i = 1; i < command->path.size(); ++i)
            seen += fmt::format("{}__fish_seen_subcommand_from {}", seen.empty() ? "" : "; and ",
                                command->path[i]);
        if (!command->commands.empty()) {
            const std::string none = fmt::format("not __fish_seen_subcommand_from {}",
                                                 fmt::join(command_names(*command), " "));
            const std::string when = seen.empty() ? none : seen + "; and " + none;
            for (const CommandWords& below : command->commands)
                out += fmt::format("complete -c grit -f -n {} -a {} -d {}\n", quoted(when, "\\'"),
                                   below.path.back(), quoted(below.description, "\\'"));
        } else if (!plain_words(*command).empty()) {
            out += fmt::format("complete -c grit{} -n {} -a '{}'\n",
                               command->positionals.front().or_file ? "" : " -f",
                               quoted(seen, "\\'"), fmt::join(plain_words(*command), " "));
        }
        for (const OptionWords& option : command->options) {
            std::string names;
            for (const std::string& name : option.names)
                names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            const std::string when = seen.empty() ? "__fish_use_subcommand" : seen;
            std::string value = option.takes_value ? " -r" : "";
            if (!option.choices.empty())
                value = fmt::format(" {} -a '{}'", option.or_file ? "-r" : "-x",
                                    fmt::join(option.choices, " "));
            out += fmt::format("complete -c grit -n {}{}{} -d {}\n", quoted(when, "\\'"), names,
                               value, quoted(option.description, "\\'"));
        }
    }
    return out;
}

// A description within an argument of _arguments or _describe.
std::string bare(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
        out += c;
    }
    return out;
}

std::string function_of(const CommandWords& command) {
    return fmt::format("_{}", fmt::join(command.path, "_"));
}

std::string zsh_value(const OptionWords& option) {
    if (option.choices.empty()) return ":value:_files";
    const std::string words = fmt::format("{}", fmt::join(option.choices, " "));
    return option.or_file ? ":value: _grit_or_files " + words : ":value:(" + words + ")";
}

std::string zsh(const CommandWords& grit) {
    std::string out = "#compdef grit\n# zsh completion of grit, printed by: grit completion zsh\n"
                      "_grit_or_files() { compadd -- \"$@\"; _files }\n";
    for (const CommandWords* command : flat(grit)) {
        std::string lines;
        const auto add = [&](const std::string& text) {
            lines += " \\\n        " + quoted(text, "'\\''");
        };
        for (const OptionWords& option : command->options)
            for (const std::string& name : option.names)
                add(fmt::format("{}{}[{}]{}", option.repeats ? "*" : "", name,
                                bare(option.description),
                                option.takes_value ? zsh_value(option) : ""));
        std::string dispatch;
        if (!command->commands.empty()) {
            add("1:command:->command");
            add("*::argument:->argument");
            for (const CommandWords& below : command->commands)
                dispatch += fmt::format("                {}) {} ;;\n", below.path.back(),
                                        function_of(below));
        } else if (!command->positionals.empty()) {
            const OptionWords& first = command->positionals.front();
            add("*" + zsh_value(first));
        }
        out += fmt::format("{}() {{\n    local line state\n    _arguments -C{}\n",
                           function_of(*command), lines);
        if (!dispatch.empty()) {
            std::string described;
            for (const CommandWords& below : command->commands)
                described +=
                    " " + quoted(below.path.back() + ":" + bare(below.description), "'\\''");
            out += fmt::format(
                "    case $state in\n        command)\n            local -a commands=({} )\n"
                "            _describe command commands ;;\n        argument)\n"
                "            case $line[1] in\n{}            esac ;;\n    esac\n",
                described, dispatch);
        }
        out += "}\n";
    }
    return out +
           "if [ \"$funcstack[1]\" = _grit ]; then _grit \"$@\"; else compdef _grit grit; fi\n";
}

}  // namespace

const std::vector<std::string>& shells() {
    static const std::vector<std::string> names = {"bash", "fish", "zsh"};
    return names;
}

std::string completion_of(const CommandWords& grit, const std::string& shell) {
    if (shell == "bash") return bash(grit);
    return shell == "fish" ? fish(grit) : zsh(grit);
}

}  // namespace cli
