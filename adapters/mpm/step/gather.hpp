// SPDX-License-Identifier: BSD-3-Clause
// From nodes back to particles: velocity, position, deformation, stress.
#pragma once

#include <vector>

#include "adapters/mpm/step/cell_means.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class Gather {
  public:
    Gather(Model& of, CellMeans& of_cells, Water& in_pores)
        : model(of), means(of_cells), water(in_pores) {}
    void add_body();

    // tasks: task::velocity ..., over dt.
    void operator()(unsigned tasks);
    // Wave speeds and velocities of particles as they are, before the first step.
    void measure();

    // What a strip of a body has left: a thread writes it for each particle, so that no two share a cache line, nor the
    // pair of them that processors fetch.
    struct alignas(128) OfStrip {
        GatherSums sums = {};
        double speed = 0.0;             // largest wave speed, viscosity included [m/s]
        Total viscous_loss = {};        // in this step [J]
        Total half = {};                // where any body has pore water, see WaterSums [J]
        double material_seconds = 0.0;  // since it was built
    };
    const std::vector<OfStrip>& strips(std::size_t body) const { return bodies[body].strips; }

  private:
    struct OfBody {
        std::vector<OfStrip> strips = {};
        std::vector<Increments> increments = {};  // of each strip
    };
    void gather(std::size_t body, int strip, unsigned tasks);
    void deform(std::size_t body, int strip);
    double update(std::size_t body, int strip, const Range& range);
    void add_half(OfStrip& sums, const Increments& increments, const Range& range) const;
    double update_viscosity(OfStrip& sums, const Increments& increments, const Range& range,
                            const double* moduli) const;
    void update_stress(std::size_t body, const Range& range, const Increments& increments) const;

    Model& model;
    CellMeans& means;
    Water& water;
    std::vector<OfBody> bodies;
    bool with_half = false;
};

}  // namespace grit::mpm
