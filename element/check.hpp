// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "element/simulate.hpp"

namespace element {

// Throws BadCase for a program that makes no sense, naming step, value and limit.
void check_program(const Program& program);

// The same of a step, which the message does not name.
void check_step(const Step& step);

// Whether the sample has a pore pressure after a step, given whether it has before: undrained steps leave one, which one
// that drains lets out. None where a drained step would keep it for good under what it prescribes; at rest it may stay.
std::optional<bool> pore_pressure_after(const Step& step, bool before);

// Throws BadCase for settings out of range.
void check_settings(const Settings& settings);

}  // namespace element
