// SPDX-License-Identifier: BSD-3-Clause
#include "cli/guide/manual_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <grit/version.h>

#include "support/version_text.hpp"

namespace cli {
namespace {

// Text as roff takes it: no line begins with a control, a hyphen is one that can be copied.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') out += "\\e";
        else if (c == '-') out += "\\-";
        else if (c == '|') out += "\\:|\\:";  // a line may end beside it
        else out += c;
    }
    return !out.empty() && (out.front() == '.' || out.front() == '\'') ? "\\&" + out : out;
}

std::string usage(const CommandWords& command) {
    std::string out = fmt::format(".B {}\n", roff(command.name()));
    if (!command.commands.empty()) return out + ".I COMMAND\n";
    for (const OptionWords& each : command.positionals) {
        const std::string words =
            fmt::format("{} {}", roff(each.names.front()), each.repeats ? ".\\|.\\|.\\& " : "");
        out += each.required ? fmt::format(".I {}\n", words) : fmt::format(".RI [ {}]\n", words);
    }
    return out + ".RI [ OPTIONS ]\n";
}

std::string entry(const OptionWords& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
    if (option.takes_value && option.names.front().front() == '-') {
        names += option.choices.empty() || option.or_file
                     ? std::string(" \\fIVALUE\\fR")
                     : " " + roff(fmt::format("{}", fmt::join(option.choices, "|")));
        if (option.repeats) names += " \\&.\\|.\\|.";
    }
    return fmt::format(".TP\n{}\n{}\n", names, roff(option.description));
}

}  // namespace

std::string manual_page(const CommandWords& grit) {
    std::string out = fmt::format(
        ".TH GRIT 1 \"\" \"Grit {}\" \"User Commands\"\n"
        ".SH NAME\ngrit \\- hypoplastic sand: element tests, material points, parameters\n"
        ".SH SYNOPSIS\n",
        grit::version_text(grit_version()));
    for (const CommandWords* command : flat(grit)) {
        if (!command->commands.empty() && command->path.size() > 1) continue;
        if (command->path.size() > 1) out += ".br\n";
        out += usage(*command);
    }
    out += fmt::format(".SH DESCRIPTION\n{}\n", roff(grit.description));
    for (const OptionWords& option : grit.options) out += entry(option);
    out += ".SH COMMANDS\n";
    for (const CommandWords* command : flat(grit)) {
        if (command->path.size() == 1 || !command->commands.empty()) continue;
        out += fmt::format(".SS {}\n{}\n", roff(command->name()), roff(command->description));
        for (const OptionWords& each : command->positionals) out += entry(each);
        for (const OptionWords& each : command->options)
            if (each.names.back() != "--help") out += entry(each);
    }
    return out +
           ".SH EXIT STATUS\n0: done. 1: the computation failed or missed its reference. 2: "
           "bad input.\n"
           ".SH FILES\n.IR docs/ ,\nwhich this page names, and cases as those below are in the "
           "source tree and in the package grit\\-doc; grit doctor says where.\n"
           ".SH EXAMPLES\n.nf\ngrit sand show lausitz\n"
           "grit element verification/cases/lausitz_dense.toml \\-\\-out results\n"
           "grit plot results/lausitz_dense.csv \\-\\-pdf\n.fi\n";
}

}  // namespace cli
