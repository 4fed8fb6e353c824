// SPDX-License-Identifier: BSD-3-Clause
// Pore pressures of cells, and what of them changes its sign from cell to cell.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <adapters/mpm/step/simulation.hpp>

namespace mpm_test {

using namespace grit::mpm;

// What alternates from cell to cell: fourth differences, divided so that of (-1)^i a they give a, the smaller of two
// neighbours whose signs differ. A layer thinner than a cell has one of a single sign.
inline double alternating(const std::vector<double>& p) {
    double out = 0.0, before = 0.0;
    for (std::size_t i = 2; i + 2 < p.size(); ++i) {
        const double now =
            (p[i - 2] - 4.0 * p[i - 1] + 6.0 * p[i] - 4.0 * p[i + 1] + p[i + 2]) / 16.0;
        if (now * before < 0.0) out = std::max(out, std::min(std::fabs(now), std::fabs(before)));
        before = now;
    }
    return out;
}

// Means of those cells that have particles of a body of one row, along r.
inline std::vector<double> pressures_along_r(Simulation& simulation, std::size_t body) {
    struct Mean {
        double sum = 0.0, count = 0.0;
    };
    const Body& of = simulation.body(body);
    const ParticleView q = simulation.body(body).particles.view();
    const AxisView r = simulation.axis_r().view();
    std::map<int, Mean> cells;
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        Mean& cell = cells[r.cell_of(q[column::r][p])];
        cell.sum += of.water->pressure(q, p);
        cell.count += 1.0;
    }
    std::vector<double> out;
    for (const auto& [cell, mean] : cells) out.push_back(mean.sum / mean.count);
    return out;
}

}  // namespace mpm_test
