// SPDX-License-Identifier: BSD-3-Clause
// The two lines that every step begins with: "*LinearLoad [a remark] ? s1 < -400" and
// "ninc maxiter dtime [: every] [T temperature change]".
#pragma once

#include <string>

#include "element/incremental_driver/lines.hpp"
#include "element/step.hpp"

namespace incremental_driver {

struct Keyword {
    int line = 0;
    std::string name;       // "*LinearLoad"
    std::string argument;   // of *ImportFile: "table.txt|3"
    std::string condition;  // behind "?", empty: none
    bool cut = false;       // the line goes on beyond column 40
};

// Throws BadInput for text that is neither.
Keyword read_keyword(const Lines& lines, const Line& line);

// Throws BadInput.
element::Condition read_condition(const Lines& lines, const Keyword& keyword,
                                  const element::Vocabulary& vocabulary);

struct Commons {
    int increments = 1;
    int iterations = 0;     // at least so many are allowed
    double duration = 0.0;  // of the step; *ImportFile: of an increment, <= 0 if a column says it
    int every = 1;          // increments 1, 1 + every, ... are written
    double temperature_change = 0.0;
};

Commons read_commons(Lines& lines, const std::string& keyword);

}  // namespace incremental_driver
