// SPDX-License-Identifier: BSD-3-Clause
// The tests a laboratory does, and the ways in which each may be driven.
#pragma once

#include <string>
#include <vector>

#include "element/laboratory.hpp"

namespace cli {

struct Way {
    std::string key;                // "axial_strain", "axial_stress_kPa", ...
    element::Step (*step)(double);  // for a change by so much
    // Stress: the key gives the value to be reached, and these rows of the step are to reach it.
    std::vector<int> reached = {};
    double sign = 1.0;  // of the rows' stress for the key's: a pressure is compression positive
    bool strain() const { return reached.empty(); }
    // "axial_strain_amplitude", "axial_stress_amplitude_kPa"
    std::string amplitude_key() const;
};

struct LaboratoryTest {
    std::string name;
    std::vector<Way> ways;
    bool shear = false;  // loaded by gamma_12
};

const std::vector<LaboratoryTest>& laboratory_tests();

}  // namespace cli
