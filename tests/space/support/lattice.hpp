// SPDX-License-Identifier: BSD-3-Clause
// Skewed particles that fill space without gaps, on a graded grid.
#pragma once

#include <vector>

#include "support/bricks.hpp"

namespace space_test {

struct Lattice {
    // Cells of 0.1 m to 0.13 m.
    static Axis graded(double ratio) {
        std::vector<double> nodes{0.0};
        for (double length = 0.1; nodes.size() < 13; length *= ratio)
            nodes.push_back(nodes.back() + length);
        return Axis(nodes);
    }
    Axis axis[3] = {graded(1.0), graded(1.01), graded(1.02)};
    Particles particles;

    // Parallelepipeds of a constant F, whose rows lie along its columns.
    Lattice() {
        constexpr double F[3][3] = {{1.02, 0.25, -0.1}, {0.15, 0.95, 0.2}, {-0.2, 0.1, 1.05}};
        constexpr int n = 10;
        const Vector3 l{0.031, 0.027, 0.034}, middle{0.6, 0.63, 0.67};
        for (int k = -n; k <= n; ++k)
            for (int j = -n; j <= n; ++j)
                for (int i = -n; i <= n; ++i) {
                    Vector3 at = middle;
                    const double steps[3] = {2.0 * i * l[0], 2.0 * j * l[1], 2.0 * k * l[2]};
                    for (int a = 0; a < 3; ++a)
                        for (int b = 0; b < 3; ++b) at[a] += F[a][b] * steps[b];
                    if (!grid().has(at)) continue;
                    particles.add({at, l, 2000.0});
                    const std::ptrdiff_t p = particles.size() - 1;
                    for (int a = 0; a < 3; ++a)
                        for (int b = 0; b < 3; ++b)
                            particles.view()[column::F_xx + 3 * a + b][p] = F[a][b];
                }
    }
    GridView grid() const { return {{axis[0].view(), axis[1].view(), axis[2].view()}}; }
    std::size_t cells() const {
        std::size_t n = 1;
        for (const auto& one : axis) n *= static_cast<std::size_t>(one.cells());
        return n;
    }
    std::size_t nodes() const {
        std::size_t n = 1;
        for (const auto& one : axis) n *= static_cast<std::size_t>(one.nodes());
        return n;
    }
    Vector3 node(std::size_t i) const {
        Vector3 at;
        for (int d = 0; d < 3; ++d) {
            const auto n = static_cast<std::size_t>(axis[d].nodes());
            at[d] = axis[d][static_cast<int>(i % n)];
            i /= n;
        }
        return at;
    }
    // Of the velocity field L x / dt, each particle's gather, in ranges.
    void gather(const Kernels& by, Shape shape, const double (&L)[3][3],
                std::vector<Increments>& out, const PoreStrains& pores = {}) {
        std::vector<NodeMotion> motions(nodes());
        for (std::size_t i = 0; i < motions.size(); ++i)
            for (int a = 0; a < 3; ++a) {
                double v = 0.0;
                for (int b = 0; b < 3; ++b) v += L[a][b] * node(i)[b];
                motions[i][motion::v_x + a] = motions[i][motion::other_x + a] = v;
            }
        GatherSums sums;
        for (std::ptrdiff_t begin = 0; begin < particles.size(); begin += Increments::capacity) {
            const auto end =
                std::min<std::ptrdiff_t>(begin + Increments::capacity, particles.size());
            out.emplace_back();
            GatherCall call{grid(), particles.view(), begin, end, motions.data(), 1.0, 0.0};
            call.pores = pores;
            by.gather(shape, call, out.back(), sums);
        }
    }
};

}  // namespace space_test
