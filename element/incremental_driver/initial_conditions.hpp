// SPDX-License-Identifier: BSD-3-Clause
// initialconditions.inp: ntens, as many stresses, optionally "temperature = value", nstatv, state
// variables; state variables that are missing at the end are zero.
#pragma once

#include <filesystem>
#include <vector>

#include "element/vectors.hpp"

namespace incremental_driver {

struct InitialConditions {
    element::Vector6 stress = element::Vector6::Zero();  // tension positive; not given: 0
    double temperature = 0.0;
    std::vector<double> statev;  // STATEV, NSTATV long
    int nstatv_line = 0;
};

// Throws BadInput.
InitialConditions read_initial_conditions(const std::filesystem::path& path);

}  // namespace incremental_driver
