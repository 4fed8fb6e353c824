// SPDX-License-Identifier: BSD-3-Clause
// Small cases of material points at random, as files that repeat them.
#pragma once

#include <string>

#include "support/trials/split_mix.hpp"

namespace robustness {

struct MpmCase {
    std::string text;  // of a case of grit mpm
    bool in_space = false;
    bool floating = false;  // no side, load or prescribed motion has a hold of any body
    double fastest = 0.0, slowest_wave = 1e300;  // of what deforms at the start [m/s]
};

// Two to four bodies on top of each other: of every material, contact, shape function, scheme and kind of water, in the plane,
// axisymmetry and space. Most are possible; others must be refused.
MpmCase random_mpm_case(grit::SplitMix& random);

}  // namespace robustness
