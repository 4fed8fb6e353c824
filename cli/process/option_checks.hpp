// SPDX-License-Identifier: BSD-3-Clause
// What an option of the command line may be: refused with the nearest word, or with the limits that it does not keep.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace cli {

// One of a few words; completions offer them, from the type's name, "{a,b}".
CLI::Validator one_of(std::vector<std::string> words);

// A number in [low, high].
CLI::Validator within(double low, double high);

}  // namespace cli
