// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace element {

// The case cannot be run as it is written: the message names value, limit and unit.
struct BadCase : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace element
