// SPDX-License-Identifier: BSD-3-Clause
// Sides of the grid that take up waves: dashpots of Lysmer & Kuhlemeyer (1969), doi 10.1061/JMCEA3.0001144,
// rho c_p v across and rho c_s v along the side, and what held the bodies there at the start.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/momentum.hpp"

namespace grit::mpm {

struct WaveSpeeds {
    double p = 0.0, s = 0.0;  // [m/s]
};

class AbsorbingSides {
  public:
    // A node at the end of a cell of this length; across: 0 for r, 1 for z.
    void add(std::size_t node, int across, double cell, const WaveSpeeds& speeds);
    void add_body() { bodies.push_back({std::vector<Force>(nodes.size())}); }
    bool any() const { return !nodes.empty(); }

    // Velocities, ahead without these forces, become those with them. The first call finds a body at rest:
    // what its nodal forces across the side want for balance is held from then on, as long as the node's mass
    // is there.
    void push(const Model& model, Momentum& momentum);
    // Work that the dashpots take and that the held forces do, on the velocities after contact [J].
    void find_work(const Model& model, Momentum& momentum);
    const Total& absorbed() const { return taken; }
    const Total& held_work() const { return held; }
    // On a body in the last step, at each of its nodes [N].
    template <class Take> void each_force(std::size_t body, const Take& take) const {
        for (std::size_t i = 0; i < bodies[body].forces.size(); ++i) {
            const Force& f = bodies[body].forces[i];
            take(nodes[i].node, Vector2{f.held[0] + f.dashpot[0], f.held[1] + f.dashpot[1]});
        }
    }

    // Three numbers of each node: which it is, and its rates.
    std::vector<double> rates() const;
    template <class Self, class Archive> static void visit(Self& sides, Archive& archive) {
        for (auto& body : sides.bodies) {
            archive.own(body.forces.data(), body.forces.size());
            archive.own(&body.balanced, 1);
        }
    }

  private:
    struct Node {
        std::size_t node;
        double rate[2];  // dashpot by mass, along r and z [1/s]
        bool across[2];
    };
    struct Force {
        double mass = 0.0;                                     // at the first call [kg]
        double first[2] = {0.0, 0.0};                          // what balance wants there [N]
        double held[2] = {0.0, 0.0}, dashpot[2] = {0.0, 0.0};  // in this step [N]
    };
    struct OfBody {
        std::vector<Force> forces;  // [nodes]
        bool balanced = false;      // once: held forces are known
    };
    Node& find(std::size_t node);
    void push(std::size_t body, const NodeCall& call);
    void add_work(std::size_t body, const NodeCall& call);
    std::vector<Node> nodes;
    std::vector<OfBody> bodies;
    Total taken, held;  // in this step [J]
};

}  // namespace grit::mpm
