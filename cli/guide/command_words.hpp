// SPDX-License-Identifier: BSD-3-Clause
// What can be said on the command line, walked out of the parser that reads it: completions and the manual page follow it.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cli {

struct OptionWords {
    std::vector<std::string> names;  // "--out", "-h"; of a positional argument its name, "CASE"
    std::string description;
    bool takes_value = false;  // else a flag
    bool repeats = false;
    bool required = false;
    std::vector<std::string> choices;  // the only values it may have, where they are few ...
    bool or_file = false;              // ... besides files
};

struct CommandWords {
    std::vector<std::string> path;  // grit sand show
    std::string description;
    std::vector<OptionWords> options;      // the help first
    std::vector<OptionWords> positionals;  // of them "names" has one
    std::vector<CommandWords> commands;

    std::string name() const;  // "grit sand show"
};

// Commands of the hidden group "" are left out.
CommandWords words_of(const CLI::App& app);

// It and all below it, it first.
std::vector<const CommandWords*> flat(const CommandWords& command);

}  // namespace cli
