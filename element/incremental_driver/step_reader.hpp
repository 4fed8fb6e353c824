// SPDX-License-Identifier: BSD-3-Clause
// One step of test.inp, of any kind but *Repetition and *End.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "element/incremental_driver/step_commons.hpp"
#include "element/step.hpp"

namespace incremental_driver {

struct StepContext {
    std::filesystem::path folder;               // where *ImportFile looks
    element::Vocabulary vocabulary;             // of exit conditions
    std::vector<std::filesystem::path> inputs;  // that *ImportFile has read
};

// Reads on from the line behind the keyword. Throws BadInput; an unknown keyword is answered with the
// nearest known one.
element::Step read_step(Lines& lines, const Keyword& keyword, StepContext& context);

}  // namespace incremental_driver
