// SPDX-License-Identifier: BSD-3-Clause
// Loads on the faces of particles in space: their forces at the nodes, and their work.
#pragma once

#include <functional>
#include <vector>

#include "adapters/mpm/space/step/model.hpp"

namespace grit::mpm::space {

// A face by its place in the undeformed particle: across a direction, on its upper side or on its lower one.
struct Face {
    int direction;
    bool upper;
};

struct Traction {
    std::size_t body;
    int particle;  // id
    Face face;
    std::function<Vector3(double)> stress;  // force per deformed area [Pa] over time [s]
    double share = 1.0;                     // of the face's area that is loaded
};

class Loads {
  public:
    explicit Loads(Model& of) : model(of) {}
    void add_body() { nodes.emplace_back(); }
    void add(Traction traction);
    // Between steps: those of this process in the place of all that were. Each body of one that any process has must have
    // been added once, or told.
    void set(std::vector<Traction> of_this_process);
    void expect(std::size_t body) { nodes[body].resize(model.nodes()); }

    // The forces of now; where they act.
    void find();
    // [nodes] of a body, of all processes [N]; null: there are none.
    const Vector3* forces(std::size_t body) const {
        return nodes[body].empty() ? nullptr : nodes[body].data();
    }
    // Work in this step, of this process, on velocities after contact.
    void find_work();
    const Total& work() const { return done; }
    // Of all tractions on a body in the last step, on all processes [N].
    Vector3 force(std::size_t body) const;
    std::size_t count() const { return tractions.size(); }
    // Where they act, but for the stress over time.
    std::vector<double> words() const;

    template <class Self, class Archive> static void visit(Self& loads, Archive& archive) {
        archive.own(loads.faces.data(), loads.faces.size());
    }

  private:
    // A uniform stress has a quarter of its force at each corner of the face, as the particle's weights see these, so
    // that they meet mass; with shape functions that know no corners, at its centre.
    struct FaceForces {
        Vector3 corner[4];  // [m]
        Vector3 each;       // [N]
    };
    bool is_here(const Traction& traction) const {
        return model.parts[traction.body].find(traction.particle) >= 0;
    }
    FaceForces forces_of(const Traction& traction);
    double find_quantum() const;

    Model& model;
    std::vector<Traction> tractions;
    std::vector<FaceForces> faces;            // of each
    std::vector<std::vector<Vector3>> nodes;  // of each body that has any [N]
    Total done;                               // [J]
};

}  // namespace grit::mpm::space
