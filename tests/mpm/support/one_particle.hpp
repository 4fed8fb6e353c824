// SPDX-License-Identifier: BSD-3-Clause
// One particle of unit density on a grid, and what it leaves at the nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <adapters/mpm/kernel/call.hpp>

namespace mpm_test {

using namespace grit::mpm;

struct OneParticle {
    Axis r{{0.0, 0.1, 0.22, 0.3, 0.41, 0.5, 0.6, 0.72, 0.8}};
    Axis z{{-0.4, -0.3, -0.18, -0.1, 0.0, 0.11, 0.2, 0.3, 0.4}};
    Particles particles;
    std::vector<NodeRecord> nodes;

    std::size_t node_count() const {
        return static_cast<std::size_t>(r.nodes()) * static_cast<std::size_t>(z.nodes());
    }
    GridView grid() const { return {r.view(), z.view()}; }
    double& operator[](int c) { return particles.view()[c][0]; }

    // Half-side vectors r1 = (F_rr, F_zr) l_r, r2 = (F_rz, F_zz) l_z.
    static OneParticle random(std::mt19937& generator, bool axisymmetric) {
        const auto in = [&](double a, double b) {
            return std::uniform_real_distribution<double>(a, b)(generator);
        };
        OneParticle q;
        q.particles.add({in(0.25, 0.5), in(-0.1, 0.1), in(0.01, 0.03), in(0.01, 0.03), 1.0},
                        axisymmetric);
        q[column::F_rr] = in(0.6, 1.4);
        q[column::F_zz] = in(0.6, 1.4);
        q[column::F_rz] = in(-0.5, 0.5);
        q[column::F_zr] = in(-0.5, 0.5);
        if (axisymmetric) q[column::F_tt] = in(0.8, 1.2);
        q[column::v_r] = in(-1.0, 1.0);
        q[column::v_z] = in(-1.0, 1.0);
        return q;
    }

    void scatter(Shape shape, bool axisymmetric) {
        nodes.assign(node_count(), NodeRecord{});
        kernels().scatter(shape, axisymmetric,
                          {grid(), particles.view(), 0, 1, nodes.data(), part::all});
    }
    // Force at each node by one unit component of stress, r or z, divided by -V.
    std::vector<double> force_weights(Shape shape, bool axisymmetric, int stress, int force) {
        for (int c = column::S_rr; c <= column::S_rz; ++c) (*this)[c] = c == stress ? 1.0 : 0.0;
        scatter(shape, axisymmetric);
        const double V = (*this)[column::V0] * particles.view().J(0);
        std::vector<double> out;
        for (const NodeRecord& n : nodes) out.push_back(-n[force] / V);
        return out;
    }
    // Linear shape function of node (i, j), the outermost cells going on beyond the grid.
    double hat(int i, int j, double x, double y) const { return line(r, i, x) * line(z, j, y); }
    static double line(const Axis& axis, int i, double x) {
        double value = 0.0;
        if (i > 0 && x <= axis[i]) value = (x - axis[i - 1]) / (axis[i] - axis[i - 1]);
        if (i + 1 < axis.nodes() && x > axis[i])
            value = (axis[i + 1] - x) / (axis[i + 1] - axis[i]);
        return std::max(value, 0.0);
    }
};

}  // namespace mpm_test
