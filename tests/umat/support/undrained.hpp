// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_update_undrained on one point.
#pragma once

#include "support/update.hpp"

namespace tests {

struct WetPoint {
    Point sand;
    double p_w = 0.0;
    double total[6] = {};
};

struct Water {
    double bulk_modulus, porosity = 0.0;
    double largest_tension = std::numeric_limits<double>::infinity();
};

inline grit_sand_water water_of(const Water& given, double* p_w, double* total = nullptr,
                                std::ptrdiff_t stride = 0) {
    grit_sand_water w;
    grit_sand_water_init(&w, sizeof w);
    w.bulk_modulus = given.bulk_modulus;
    w.porosity = given.porosity;
    w.largest_tension = given.largest_tension;
    w.pore_pressure = grit_mutable_view_of(p_w, stride, 1);
    w.total_stress = grit_mutable_view_of(total, stride, 1);
    return w;
}

inline Outcome update_undrained(const Sand& sand, const Water& given, WetPoint& point,
                                const double strain[6],
                                const grit_sand_options& options = options_with()) {
    Outcome out{};
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(strain, 6, 1);
    q.stress = grit_mutable_view_of(point.sand.stress, 6, 1);
    q.state = grit_mutable_view_of(point.sand.state, GRIT_SAND_STATE_SIZE, 1);
    q.tangent = grit_mutable_matrix_view_of(out.tangent, 36, 6, 1);
    const grit_sand_water water = water_of(given, &point.p_w, point.total);
    out.status = grit_sand_update_undrained(sand, &options, &water, 1, &q, &out.report, &out.error);
    return out;
}

// What bears of p_w.
inline double borne(const Water& water, double p_w) {
    return std::fmax(p_w, -water.largest_tension);
}

}  // namespace tests
