// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

#include "adapters/lammps/words.hpp"
#include "adapters/mpm/case/time_function.hpp"

namespace grit::lammps {

struct Function {
    mpm::TimeFunction time = mpm::TimeTable{{0.0}, {0.0}};
    std::string variable;  // instead, if it is not empty
};

// A number; v_NAME; table COUNT (T VALUE)...; or pulses FORM PEAK DURATION PEAK_TIME INTERVAL START COUNT.
Function read_function(Words& words, const std::string& what);

}  // namespace grit::lammps
