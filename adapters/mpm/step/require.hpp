// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include <grit/status.h>

namespace grit::mpm {

// Throws std::runtime_error with the library's message if a call of it failed.
inline void require(grit_status status, const grit_error& error, const char* part) {
    if (status != GRIT_OK) throw std::runtime_error(std::string(part) + ": " + error.message);
}

}  // namespace grit::mpm
