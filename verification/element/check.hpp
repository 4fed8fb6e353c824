// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/simulate.hpp"

namespace element {

// Throws BadCase for a program that makes no sense, naming step, value and limit.
void check_program(const Program& program, const std::vector<std::string>& state_names);

// Throws BadCase for settings out of range.
void check_settings(const Settings& settings);

}  // namespace element
