// SPDX-License-Identifier: BSD-3-Clause
// Volumetric strains and mean stresses as those of cells, against locking, where the settings want them.
#pragma once

#include <vector>

#include "adapters/mpm/space/step/model.hpp"

namespace grit::mpm::space {

class CellMeans {
  public:
    explicit CellMeans(Model& of) : model(of) {}
    void add_body();
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);

    bool wanted() const { return model.settings.cell_mean; }
    // Rigid bodies have none.
    bool has(std::size_t body) const { return !bodies[body].cells.empty(); }
    // What the kernels take.
    const CellMean& of(std::size_t body) const { return bodies[body].mean; }
    // The mean stresses of all cells, for a scatter of forces.
    void find_stresses();
    // For strains that a gather adds.
    void begin_strains();
    // Of all processes, once each has its own.
    void sum();

  private:
    struct OfBody {
        CellMean mean = {};  // of the vectors that follow
        std::vector<CellIntegers> cells = {};
        std::vector<Deferred> deferred = {};
        std::vector<double> most_stress = {};  // largest mean stress of each pencil [Pa]
    };
    void add_stresses(std::size_t body, int pencil, const CellMean& mean);
    void clear(std::size_t body);

    Model& model;
    std::vector<OfBody> bodies;
};

}  // namespace grit::mpm::space
