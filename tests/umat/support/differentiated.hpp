// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_update_differentiated on one point, along a path.
#pragma once

#include "support/update.hpp"

namespace tests {

// Stress above state, as the host has them; derivatives: a column per direction.
using Numbers = Eigen::Matrix<double, 14, 1>;
using Slopes = Eigen::Matrix<double, 14, Eigen::Dynamic, Eigen::RowMajor>;
using StrainSlopes = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;

inline Numbers numbers_of(const Point& x) {
    Numbers y;
    for (int c = 0; c < 6; ++c) y[c] = x.stress[c];
    for (int c = 0; c < 8; ++c) y[6 + c] = x.state[c];
    return y;
}

struct Differentiated {
    Point point;
    Slopes slopes;

    Differentiated(const Point& start, int directions)
        : point(start), slopes(Slopes::Zero(14, directions)) {}
};

// The columns of the slopes are of these parameters, or of none.
inline Outcome update(const Sand& sand, Differentiated& x, const double strain[6],
                      const std::vector<int>& parameters, const StrainSlopes& strain_slopes,
                      const grit_sand_options& options) {
    Outcome out{};
    const auto count = static_cast<ptrdiff_t>(parameters.size());
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(strain, 6, 1);
    q.stress = grit_mutable_view_of(x.point.stress, 6, 1);
    q.state = grit_mutable_view_of(x.point.state, GRIT_SAND_STATE_SIZE, 1);
    grit_sand_derivatives d{};
    d.struct_size = sizeof d;
    d.count = static_cast<int>(count);
    d.parameters = parameters.data();
    if (strain_slopes.size() > 0)
        d.strain_increment = grit_matrix_view_of(strain_slopes.data(), 6 * count, count, 1);
    d.stress = grit_mutable_matrix_view_of(x.slopes.data(), 14 * count, count, 1);
    d.state = grit_mutable_matrix_view_of(x.slopes.data() + 6 * count, 14 * count, count, 1);
    out.status =
        grit_sand_update_differentiated(sand, &options, &d, 1, &q, &out.report, &out.error);
    return out;
}

// All parameters, the initial void ratio, and six entries of a strain.
inline const std::vector<int>& all_directions() {
    static const std::vector<int> all = [] {
        std::vector<int> r;
        for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) r.push_back(i);
        r.insert(r.end(), 7, GRIT_SAND_NO_PARAMETER);
        return r;
    }();
    return all;
}
constexpr int of_initial_void_ratio = GRIT_SAND_PARAMETER_COUNT;
constexpr int of_strain = of_initial_void_ratio + 1;

}  // namespace tests
