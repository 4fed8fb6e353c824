// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/platens.hpp"

#include <stdexcept>
#include <utility>

namespace grit::mpm {

void Platens::add(int direction, std::vector<std::size_t> nodes) {
    if (!model.is_alone())
        throw std::invalid_argument("platens: processes that share a grid know none yet");
    platens.push_back({direction, std::move(nodes)});
    water.tie(platens.back());
}

std::vector<double> Platens::words() const {
    std::vector<double> out;
    for (const TiedNodes& platen : platens) {
        out.push_back(platen.direction);
        out.insert(out.end(), platen.nodes.begin(), platen.nodes.end());
    }
    return out;
}

void Platens::tie(Energy& sums) {
    for (const TiedNodes& platen : platens) {
        const int now = motion::v_r + platen.direction, before = motion::other_r + platen.direction;
        double mass = 0.0, momentum = 0.0;
        water.each_mass(platen, [&](double m, const NodeMotion& v) {
            mass += m;
            momentum += m * v[now];
        });
        water.each_mass(platen, [&](double m, NodeMotion& v) {
            const double tied = momentum / mass;
            sums.contact -= 0.5 * m * (tied - v[now]) * (tied + v[before]);
            v[now] = tied;
        });
    }
}

}  // namespace grit::mpm
