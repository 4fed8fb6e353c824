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
    // These move as one along a direction (0 r, 1 z). Throws std::invalid_argument if processes share the grid.
    void add(int direction, std::vector<std::size_t> nodes);
    // Of each its direction and its nodes.
    std::vector<double> words() const;

    // Velocities after contact get the mean of the masses that meet the platen: no momentum is lost. Adds to the
    // contact what that takes.
    void tie(Energy& sums);

  private:
    Model& model;
    Water& water;
    std::vector<TiedNodes> platens;
};

}  // namespace grit::mpm
