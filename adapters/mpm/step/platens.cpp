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
    platens.push_back({{direction, std::move(nodes)}, cell});
    water.tie(platens.back().tied);
}

std::vector<double> Platens::words() const {
    std::vector<double> out;
    for (const Platen& platen : platens) {
        out.push_back(platen.tied.direction);
        out.insert(out.end(), platen.tied.nodes.begin(), platen.tied.nodes.end());
    }
    return out;
}

void Platens::tie(Energy& sums) {
    for (Platen& platen : platens) {
        const int now = motion::v_r + platen.tied.direction,
                  before = motion::other_r + platen.tied.direction;
        double mass = 0.0, momentum = 0.0;
        water.each_mass(platen.tied, [&](double m, const NodeMotion& v) {
            mass += m;
            momentum += m * v[now];
        });
        platen.speed = mass > 0.0 ? momentum / mass : 0.0;
        water.each_mass(platen.tied, [&](double m, NodeMotion& v) {
            sums.contact -= 0.5 * m * (platen.speed - v[now]) * (platen.speed + v[before]);
            v[now] = platen.speed;
        });
    }
}

void Platens::move() {
    for (Platen& platen : platens) {
        const int now = motion::v_r + platen.tied.direction;
        water.each_mass(platen.tied, [&](double, const NodeMotion& v) { platen.speed = v[now]; });
        platen.way += model.dt * platen.speed;
        if (!(std::abs(platen.way) <= 0.25 * platen.cell))
            throw std::runtime_error(
                "a platen has moved by " + std::to_string(platen.way) +
                " m, more than a quarter of the cells of " + std::to_string(platen.cell) +
                " m that it presses on: its nodes are no longer at the surface of the bodies");
    }
}

}  // namespace grit::mpm
