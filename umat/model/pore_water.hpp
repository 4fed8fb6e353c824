// SPDX-License-Identifier: BSD-3-Clause
// Water that fills the pores and cannot leave them, while grains keep their volume: (W1) with n = e/(1 + e) and (H9)
// is d p_w = -K_w d ln e, so that p_w is a function of e alone, whatever the increments are.
#pragma once

#include <cmath>

namespace grit {

struct PoreWater {
    double K_w;              // bulk modulus [stress]
    double n;                // constant porosity [-]; 0: that of the void ratio
    double largest_tension;  // [stress]

    // p_w after a volumetric strain from the void ratio e.
    double pressure_after(double p_w, double e, double volumetric) const {
        const double closing =
            n > 0.0 ? -volumetric / n : -std::log1p((1.0 + e) / e * std::expm1(volumetric));
        return p_w + K_w * closing;  // (W1)
    }
    bool cavitates(double p_w) const { return !(p_w > -largest_tension); }
    // What bears.
    double borne(double p_w) const { return cavitates(p_w) ? -largest_tension : p_w; }
    // -d p/d tr at the void ratio e.
    double stiffness(double p_w, double e) const {
        return cavitates(p_w) ? 0.0 : n > 0.0 ? K_w / n : K_w * ((1.0 + e) / e);
    }
};

}  // namespace grit
