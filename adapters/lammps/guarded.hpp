// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

#include "adapters/lammps/fix_grit_mpm.hpp"

namespace grit::lammps {

// What is wrong with a command is wrong on all processes; what fails in a step may fail on one.
template <class Work> void FixGritMpm::guarded(const Work& work) {
    try {
        work();
    } catch (const std::invalid_argument& wrong) {
        error->all(FLERR, std::string("Illegal fix grit/mpm command: ") + wrong.what());
    } catch (const std::exception& failure) {
        fail(failure.what());
    }
}

template <class Work> void FixGritMpm::guarded_here(const Work& work) {
    try {
        work();
    } catch (const std::exception& failure) {
        fail(failure.what());
    }
}

}  // namespace grit::lammps
