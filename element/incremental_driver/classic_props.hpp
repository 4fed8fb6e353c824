// SPDX-License-Identifier: BSD-3-Clause
// PROPS of parameters.inp in the classic layout, for Grit's own sand.
#pragma once

#include <filesystem>
#include <memory>

#include <grit/classic_layout.h>

#include "element/grit_law.hpp"
#include "element/incremental_driver/parameters.hpp"

namespace incremental_driver {

struct ClassicSand {
    std::shared_ptr<const element::GritLaw> law;  // IGS off if m_R <= 0.5; with water if K_w > 0
    bool has_water = false;
    double e_0 = 0.0;  // initial void ratio, see void_ratio_at
};

// Throws BadInput naming the file, the line and the place in PROPS. More than 19 are not read.
ClassicSand read_classic_props(const Parameters& parameters, const std::filesystem::path& path);

// grit_classic_void_ratio; throws element::BadCase where it refuses.
double void_ratio_at(const ClassicSand& sand, double p);

}  // namespace incremental_driver
