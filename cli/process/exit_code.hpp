// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace cli {

enum ExitCode { ok = 0, failed_computation = 1, bad_input = 2 };

// What the user gave cannot be used: the message names file, line, key, value and limit.
struct BadInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace cli
