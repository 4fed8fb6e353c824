// SPDX-License-Identifier: BSD-3-Clause
// Rigid plates without friction on sides of the grid: nodes that move as one across. They have no mass; what presses on
// them is a traction of the bodies, whose sum they hand on. No water passes.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class Platens {
  public:
    Platens(Model& of, Water& in_pores) : model(of), water(in_pores) {}
    // These move as one along a direction (0 r, 1 z); cell: the length of the cells that the bodies end in. Throws
    // std::invalid_argument if processes share the grid.
    void add(int direction, double cell, std::vector<std::size_t> nodes);
    // Of each its direction and its nodes.
    std::vector<double> words() const;

    bool any() const { return !platens.empty(); }
    // How far each has moved [m]. Throws std::runtime_error once that is more than a quarter of a cell: the surface of
    // the bodies is no longer at its nodes.
    void move();
    // Velocities after contact get the mean of the masses that meet the platen: no momentum is lost. Adds to the
    // contact what that takes.
    void tie(Energy& sums);

    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        for (auto& platen : of.platens) archive.value(platen.way);
    }

  private:
    struct Platen {
        double cell, way = 0.0;  // [m], since the start [m]
    };
    Model& model;
    Water& water;
    std::vector<Platen> platens;  // as the water has their nodes
};

}  // namespace grit::mpm
