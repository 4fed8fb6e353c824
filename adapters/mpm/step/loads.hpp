// SPDX-License-Identifier: BSD-3-Clause
// All tractions: their forces at the nodes, and their work.
#pragma once

#include <vector>

#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/traction.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class Loads {
  public:
    Loads(Model& of, Water& in_pores) : model(of), water(in_pores) {}
    void add_body() { nodes.emplace_back(), on_mixture.emplace_back(); }
    void add(Traction traction);
    // Between steps: those of this process in the place of all that were. The body of each that any process has must have
    // been told.
    void set(std::vector<Traction> of_this_process);
    void expect(std::size_t body, bool mixture) {
        (mixture ? on_mixture : nodes)[body].resize(model.fixed_nodes.size());
    }

    // Adds the forces of now to those of the nodes.
    void push();
    // Work in this step, on velocities after contact.
    void find_work();
    const Total& work() const { return done; }
    // Of all tractions on a body in the last step, on all processes [N].
    Vector2 force(std::size_t body) const;
    std::size_t count() const { return tractions.size(); }
    // Of each traction body, particle, edge and whether it is on the mixture.
    std::vector<double> words() const;

    template <class Self, class Archive> static void visit(Self& loads, Archive& archive) {
        archive.own(loads.edges.data(), loads.edges.size());
    }

  private:
    bool is_here(const Traction& traction) const {
        return model.parts[traction.body].find(traction.particle) >= 0;
    }
    double quantum() const;
    using Forces = std::vector<std::vector<Vector2>>;  // at nodes of each body that has any [N]
    // take(body, node, force) of what all processes have there.
    template <class Take> void share(Forces& forces, const Take& take) {
        for (std::size_t b = 0; b < forces.size(); ++b) {
            if (forces[b].empty()) continue;
            model.exchange.sum_nodes(forces[b].data(),
                                     static_cast<std::ptrdiff_t>(forces[b].size()));
            for (std::size_t i = 0; i < forces[b].size(); ++i) take(b, i, forces[b][i]);
        }
    }
    Forces& forces_of(const Traction& t) { return t.on_mixture ? on_mixture : nodes; }

    Model& model;
    Water& water;
    std::vector<Traction> tractions;
    std::vector<EdgeForces> edges;  // of each traction
    Forces nodes, on_mixture;       // of those on grains alone, and the others
    Total done;                     // [J]
};

}  // namespace grit::mpm
