// SPDX-License-Identifier: BSD-3-Clause
// From nodes back to particles in space: velocity, position, deformation, stress.
#pragma once

#include <vector>

#include "adapters/mpm/space/step/cell_means.hpp"
#include "adapters/mpm/space/step/water.hpp"

namespace grit::mpm::space {

class Gather {
  public:
    Gather(Model& of, CellMeans& of_cells, Water& in_pores)
        : model(of), means(of_cells), water(in_pores) {}
    void add_body();

    void operator()();
    // Wave speeds and velocities of particles as they are, before the first step.
    void measure();

    // What a pencil of a body has left: a thread writes it for each particle, so that no two share a cache line, nor the
    // pair of them that processors fetch.
    struct alignas(128) OfPencil {
        GatherSums sums = {};
        double speed = 0.0;             // largest wave speed, viscosity included [m/s]
        Total viscous_loss;             // in this step [J]
        Total half;                     // half of the stresses' work, where there is pore water [J]
        double material_seconds = 0.0;  // since it was built
    };
    const std::vector<OfPencil>& pencils(std::size_t body) const { return bodies[body]; }

  private:
    void gather(std::size_t body, int pencil);
    void carry(Part& part, int pencil, GatherSums& sums) const;
    void deform(std::size_t body, int pencil);
    double update(std::size_t body, OfPencil& sums, const Range& range, const Increments& d);
    double update_viscosity(OfPencil& sums, const Increments& d, const Range& range,
                            const double* moduli) const;
    void add_half(OfPencil& sums, const Increments& d, const Range& range) const;

    Model& model;
    CellMeans& means;
    Water& water;
    std::vector<std::vector<OfPencil>> bodies;
};

}  // namespace grit::mpm::space
