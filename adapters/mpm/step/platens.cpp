// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/platens.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace grit::mpm {

void Platens::add(int direction, double cell, std::vector<std::size_t> nodes) {
    if (!model.is_alone())
        throw std::invalid_argument("platens: processes that share a grid know none yet");
    platens.push_back({cell});
    water.tie({direction, std::move(nodes)});
}

std::vector<double> Platens::words() const {
    std::vector<double> out;
    for (const TiedNodes& tied : water.tied()) {
        out.push_back(tied.direction);
        out.insert(out.end(), tied.nodes.begin(), tied.nodes.end());
    }
    return out;
}

void Platens::tie(Energy& sums) {
    for (const TiedNodes& tied : water.tied()) {
        const int now = motion::v_r + tied.direction, before = motion::other_r + tied.direction;
        double mass = 0.0, momentum = 0.0;
        water.each_mass(tied, [&](double m, const NodeMotion& v) {
            mass += m;
            momentum += m * v[now];
        });
        water.each_mass(tied, [&](double m, NodeMotion& v) {
            const double speed = momentum / mass;
            sums.contact -= 0.5 * m * (speed - v[now]) * (speed + v[before]);
            v[now] = speed;
        });
    }
}

void Platens::move() {
    for (std::size_t i = 0; i < platens.size(); ++i) {
        Platen& platen = platens[i];
        const TiedNodes& tied = water.tied()[i];
        double speed = 0.0;
        water.each_mass(
            tied, [&](double, const NodeMotion& v) { speed = v[motion::v_r + tied.direction]; });
        platen.way += model.dt * speed;
        if (!(std::abs(platen.way) <= 0.25 * platen.cell))
            throw std::runtime_error(
                "a platen has moved by " + std::to_string(platen.way) +
                " m, more than a quarter of the cells of " + std::to_string(platen.cell) +
                " m that it presses on: its nodes are no longer at the surface of the bodies");
    }
}

}  // namespace grit::mpm
