// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/absorbing.hpp"

#include <algorithm>

namespace grit::mpm {

AbsorbingSides::Node& AbsorbingSides::find(std::size_t node) {
    const auto at = std::find_if(nodes.begin(), nodes.end(),
                                 [node](const Node& other) { return other.node == node; });
    if (at != nodes.end()) return *at;
    for (OfBody& body : bodies) body.forces.emplace_back();
    return nodes.emplace_back(Node{node, {0.0, 0.0}, {false, false}});
}

// The node's mass is that of half a cell behind it: area by mass is 2 / (rho cell).
void AbsorbingSides::add(std::size_t node, int across, double cell, const WaveSpeeds& speeds) {
    Node& found = find(node);
    found.rate[across] += 2.0 * speeds.p / cell;
    found.rate[1 - across] += 2.0 * speeds.s / cell;
    found.across[across] = true;
}

// Few nodes: one after the other.
void AbsorbingSides::push(const Model& model, Momentum& momentum) {
    if (nodes.empty()) return;
    for (std::size_t i = 0; i < model.parts.size(); ++i)
        if (!model.parts[i].body.rigid()) push(i, momentum.call(i, 0));
}

void AbsorbingSides::find_work(const Model& model, Momentum& momentum) {
    taken = held = Total();
    if (nodes.empty()) return;
    for (std::size_t i = 0; i < model.parts.size(); ++i) add_work(i, momentum.call(i, 0));
}

std::vector<double> AbsorbingSides::rates() const {
    std::vector<double> out;
    for (const Node& node : nodes)
        out.insert(out.end(), {static_cast<double>(node.node), node.rate[0], node.rate[1]});
    return out;
}

void AbsorbingSides::push(std::size_t body, const NodeCall& call) {
    std::vector<Force>& forces = bodies[body].forces;
    const bool first = !bodies[body].balanced;
    bodies[body].balanced = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node& n = nodes[i];
        const NodeRecord& record = call.records[n.node];
        NodeMotion& v = call.motions[n.node];
        const double m = record[record::m], g[] = {call.gravity[0], call.gravity[1]};
        Force& force = forces[i];
        if (first) force.mass = m;
        for (const int k : {0, 1}) {
            force.held[k] = force.dashpot[k] = 0.0;
            const bool is_fixed = call.fixed[n.node] & (k == 0 ? fixed::r : fixed::z);
            if (is_fixed || !(m > call.least_mass)) continue;
            if (first && n.across[k]) force.first[k] = -(record[record::f_r + k] + m * g[k]);
            if (force.mass > 0.0) force.held[k] = force.first[k] * std::min(1.0, m / force.mass);
            double& v_k = v[motion::v_r + k];
            v_k = (v_k + call.dt * force.held[k] / m) / (1.0 + call.dt * n.rate[k]);
            force.dashpot[k] = -m * n.rate[k] * v_k;
        }
    }
}

void AbsorbingSides::add_work(std::size_t body, const NodeCall& call) {
    for (std::size_t i = 0; i < bodies[body].forces.size(); ++i) {
        const Force& force = bodies[body].forces[i];
        const auto node = static_cast<std::ptrdiff_t>(nodes[i].node);
        const NodeMotion& v = call.motions[node];
        for (const int k : {0, 1}) {
            const double way = 0.5 * call.dt * (v[motion::v_r + k] + v[motion::other_r + k]);
            call.add(taken, node, -force.dashpot[k] * way);
            call.add(held, node, force.held[k] * way);
        }
    }
}

}  // namespace grit::mpm
