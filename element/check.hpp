// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/simulate.hpp"

namespace element {

// Throws BadCase for a program that makes no sense, naming step, value and limit.
void check_program(const Program& program);

// The same of a step, which the message does not name.
void check_step(const Step& step);

// Throws BadCase for settings out of range.
void check_settings(const Settings& settings);

}  // namespace element
