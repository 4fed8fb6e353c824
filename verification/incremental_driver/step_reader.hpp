// SPDX-License-Identifier: BSD-3-Clause
// One step of test.inp, of any kind but *Repetition and *End.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "element/step.hpp"
#include "incremental_driver/step_commons.hpp"

namespace incremental_driver {

struct StepContext {
    std::filesystem::path folder;          // where *ImportFile looks
    std::vector<std::string> state_names;  // of the law, for exit conditions
};

struct ReadStep {
    element::Step step;
    int every = 1;  // increments 1, 1 + every, ... are written
};

// Reads on from the line behind the keyword. Throws BadInput; an unknown keyword is answered with the
// nearest known one.
ReadStep read_step(Lines& lines, const Keyword& keyword, const StepContext& context);

}  // namespace incremental_driver
