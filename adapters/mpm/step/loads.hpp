// SPDX-License-Identifier: BSD-3-Clause
// All tractions: their forces at the nodes, and their work.
#pragma once

#include <vector>

#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/traction.hpp"

namespace grit::mpm {

class Loads {
  public:
    explicit Loads(Model& of) : model(of) {}
    void add_body() { nodes.emplace_back(); }
    void add(Traction traction);

    // Adds the forces of now to those of the nodes.
    void push();
    // Work in this step, on velocities after contact.
    void find_work();
    const Total& work() const { return done; }
    // Of all tractions on a body in the last step, on all processes [N].
    Vector2 force(std::size_t body) const;
    std::size_t count() const { return tractions.size(); }

    template <class Self, class Archive> static void visit(Self& loads, Archive& archive) {
        archive.own(loads.edges.data(), loads.edges.size());
    }

  private:
    bool is_here(const Traction& traction) const {
        return model.parts[traction.body].find(traction.particle) >= 0;
    }
    double quantum() const;

    Model& model;
    std::vector<Traction> tractions;
    std::vector<EdgeForces> edges;            // of each traction
    std::vector<std::vector<Vector2>> nodes;  // of each body, if it has any [N]
    Total done;                               // [J]
};

}  // namespace grit::mpm
