// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace cli {

// Viridis (Smith & van der Walt 2015): even steps look even, in grey and to colour-blind readers too.
inline constexpr std::array<const char*, 9> viridis = {"#440154", "#472d7b", "#3b528b",
                                                       "#2c728e", "#21918c", "#28ae80",
                                                       "#5ec962", "#addc30", "#fde725"};

}  // namespace cli
