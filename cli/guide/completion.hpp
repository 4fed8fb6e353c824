// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/guide/command_words.hpp"

namespace cli {

const std::vector<std::string>& shells();  // bash, fish, zsh

// A script that teaches SHELL, one of shells(), to complete commands, options, their values and files.
std::string completion_of(const CommandWords& grit, const std::string& shell);

}  // namespace cli
