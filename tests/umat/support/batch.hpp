// SPDX-License-Identifier: BSD-3-Clause
// Arrays of random points, as a host would keep them: array of structures.
#pragma once

#include "support/states.hpp"
#include "support/update.hpp"

namespace tests {

struct Batch {
    std::vector<Voigt> strain;
    std::vector<Point> points;
    std::vector<grit_sand_report> reports;
    std::vector<std::array<double, 36>> tangents;
    std::vector<double> substeps;
    grit_error error{};

    std::size_t size() const { return points.size(); }

    grit_sand_points views() {
        grit_sand_points q{};
        q.struct_size = sizeof q;
        q.strain_increment = grit_view_of(strain[0].data(), 6, 1);
        q.stress = grit_mutable_view_of(points[0].stress, sizeof(Point) / sizeof(double), 1);
        q.state = grit_mutable_view_of(points[0].state, sizeof(Point) / sizeof(double), 1);
        q.tangent = grit_mutable_matrix_view_of(tangents[0].data(), 36, 6, 1);
        q.substep = grit_mutable_view_of(substeps.data(), 1, 1);
        return q;
    }
    grit_status update(const Sand& sand, const grit_sand_options& options) {
        const grit_sand_points q = views();
        return update(sand, options, q);
    }
    grit_status update(const Sand& sand, const grit_sand_options& options,
                       const grit_sand_points& q) {
        return grit_sand_update(sand, &options, static_cast<std::ptrdiff_t>(size()), &q,
                                reports.data(), &error);
    }
};

inline bool same_bits(const Batch& a, const Batch& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
    };
    return same(a.points, b.points) && same(a.tangents, b.tangents) && same(a.substeps, b.substeps);
}

// Points of one sand with increments of 1e-6 ... 3e-3; in_plane: without 13 and 23 components.
inline Batch random_batch(const Sand& sand, std::size_t n, std::uint64_t seed,
                          bool in_plane = false) {
    Batch batch;
    Random random(seed);
    for (std::size_t i = 0; i < n; ++i) {
        State x = random_state(sand, random, 100.0, 500.0);
        Vec dE = random.direction();  // first, for every compiler
        dE *= random.log_uniform(1e-6, 3e-3);
        for (const int c : {4, 5})
            if (in_plane) x.T[c] = x.h[c] = dE[c] = 0.0;
        batch.points.push_back(point_of(x));
        batch.strain.push_back(voigt_strain(dE));
    }
    batch.reports.resize(n);
    batch.tangents.resize(n);
    for (auto& t : batch.tangents) t.fill(1.25);
    batch.substeps.assign(n, 0.0);
    return batch;
}

}  // namespace tests
