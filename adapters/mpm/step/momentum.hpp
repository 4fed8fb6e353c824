// SPDX-License-Identifier: BSD-3-Clause
// Nodes of all bodies: from their sums to velocities, and what these do.
#pragma once

#include <vector>

#include "adapters/mpm/step/model.hpp"

namespace grit::mpm {

class Water;

class Momentum {
  public:
    explicit Momentum(Model& of) : model(of) {}
    void add_body();

    // With stress first: v = v_old = p/m.
    void start_velocities();
    // Forces as they are now are those of stresses and penalties.
    void keep_internal_forces();
    // v = v_old + dt (f/m + g); rigid bodies have the velocity of the end of the step.
    void advance();
    // After contact: local damping, if there is any. tied: velocities change once more; meets: by contact.
    void damp(const Water& water, bool tied, bool meets);
    // Once velocities are what the step leaves.
    void close();
    // Before and after momenta are scattered again (MUSL).
    void forget();
    void remap();

    // What kernels and absorbing sides see of the nodes of a strip.
    NodeCall call(std::size_t body, int strip);
    const std::vector<NodeSums>& sums(std::size_t body) const { return bodies[body].sums; }
    // Along z, of local damping on a body in the last step, on all processes [N s].
    double damping_impulse(std::size_t body) const;

    template <class Self, class Archive> static void visit(Self& momentum, Archive& archive) {
        for (auto& body : momentum.bodies) archive.nodes(body.internal);
    }

  private:
    struct OfBody {
        std::vector<Vector2> internal = {};  // nodal forces of stresses and penalties [N]
        std::vector<NodeSums> sums = {};     // of each strip's rows
        std::vector<NodeMotion> damped =
            {};  // of nodes, see NodeCall; empty: nothing comes after damping
    };
    NodeSums& sums_of(std::size_t body, int strip) {
        return bodies[body].sums[static_cast<std::size_t>(strip)];
    }
    bool is_rigid(std::size_t body) const { return model.parts[body].body.rigid(); }

    Model& model;
    std::vector<OfBody> bodies;
};

}  // namespace grit::mpm
