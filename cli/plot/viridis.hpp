// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace cli {

// Viridis (Smith & van der Walt 2015): even steps look even, in grey and to colour-blind readers too.
inline constexpr std::array<const char*, 9> viridis = {"#440154", "#472d7b", "#3b528b",
                                                       "#2c728e", "#21918c", "#28ae80",
                                                       "#5ec962", "#addc30", "#fde725"};

// Share 0 to 1 of the way through it.
inline std::string viridis_at(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (viridis.size() - 1);
    const std::size_t below = std::min(viridis.size() - 2, static_cast<std::size_t>(place));
    const auto part = [&](const std::string& colour, std::size_t i) {
        return static_cast<double>(std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16));
    };
    std::string out = "#";
    for (std::size_t i = 0; i < 3; ++i)
        out += fmt::format(
            "{:02x}", std::lround(std::lerp(part(viridis[below], i), part(viridis[below + 1], i),
                                            place - static_cast<double>(below))));
    return out;
}

}  // namespace cli
