// SPDX-License-Identifier: BSD-3-Clause
// Why a reader did not take what a fuzzer gave it. replay.cpp asks: a seed that nobody takes leads nowhere.
#pragma once

#include <string>

namespace fuzz {

// Of the last input; empty: it was taken.
inline std::string refusal;

}  // namespace fuzz
