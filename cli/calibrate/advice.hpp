// SPDX-License-Identifier: BSD-3-Clause
// What the tests do not determine, in words.
#pragma once

#include <string>
#include <vector>

#include "element/calibration/laplace.hpp"

namespace cli {

// A sentence per combination of parameters that is not determined, with the test that would; one that says so if all
// are.
std::vector<std::string> advice(const calibration::ParameterSpace& space,
                                const calibration::Laplace& laplace);

}  // namespace cli
