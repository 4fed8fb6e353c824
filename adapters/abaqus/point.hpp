// SPDX-License-Identifier: BSD-3-Clause
// A material point as the library takes it, and the way there and back from what a host carries:
// 6, 4 or 3 components, STATEV in the layout of this library. Components not carried are zero.
#pragma once

#include <cstddef>

#include <grit/sand_water.h>

#include "adapters/abaqus/props.hpp"

namespace grit::abaqus {

struct Point {
    double strain_increment[6];
    double stress[6];  // effective
    double total[6];   // after an update
    double state[GRIT_SAND_STATE_SIZE];
    double substep;
    double pore_pressure;  // excess, compression positive [stress]
};

// STATEV of a point: side by side in a UMAT, a block apart in a VUMAT.
struct Statev {
    double* base;
    std::ptrdiff_t stride;
    int size;

    double& operator[](int place) const { return base[place * stride]; }
};

// The state, and the stress from total to effective: T = STRESS + p I.
void read_state(const Statev& statev, int shears, const Material& material, Point& point);

// A state for points that have none, see docs/umat.md; a complaint in error if there is none.
grit_status complete_state(const Material& material, Point& point, grit_error& error);

// With views on points that lie side by side.
grit_sand_water water_of(const Material& material, Point* points);

// Component c, total, of the stress at the end; given is what the host had, the same bits if nothing
// has changed: taking the pore pressure off and on again must not cost one.
inline double total_stress(const Point& start, const Point& end, int c, double given) {
    if (c >= 3) return end.stress[c];
    const bool same = end.pore_pressure == start.pore_pressure && end.stress[c] == start.stress[c];
    return same ? given : end.total[c];
}

// The state back, and what stands in STATEV for output only.
void write_state(const Statev& statev, const Material& material, const Point& end, int evaluations);

}  // namespace grit::abaqus
