// SPDX-License-Identifier: BSD-3-Clause
// Pore water of bodies in space, which moves with the grains (W1). Its pressure is explicit, and acts as the mean of a cell, as
// its strain is that of the cell: particles of one cannot lock.
#pragma once

#include <vector>

#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/space/step/model.hpp"

namespace grit::mpm::space {

class Water {
  public:
    explicit Water(Model& of) : model(of) {}
    void add_body();
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);

    bool is_anywhere() const;
    bool has(std::size_t body) const { return model.parts[body].body.water.has_value(); }
    // For a scatter: the means of cells, of all processes, until update.
    void find_pressures();
    PorePressures pressures(std::size_t body) const {
        if (!has(body)) return {};
        return {bodies[body].cells.data(), model.parts[body].body.water->bulk_modulus};
    }
    // For a gather; and after it.
    PoreStrains strains(std::size_t body);
    void update();
    // Speeds of particles as they are, before the first step.
    void measure();

    struct alignas(128) OfPencil {
        Total work, half;  // as WaterSums, of this step [J]
        double speed2 =
            0.0;  // what it adds to the square of the speed of waves, at the most [m2/s2]
    };
    const std::vector<OfPencil>& pencils(std::size_t body) const { return bodies[body].pencils; }
    double speed2(std::size_t body) const;

  private:
    struct OfBody {
        std::vector<CellIntegers> cells = {};
        std::vector<PorePlace> places = {};
        std::vector<OfPencil> pencils = {};
    };
    // The means of cells of what value(body, particle) gives.
    template <class Value> void find_means(const Value& value);
    void update(std::size_t body, int pencil);

    Model& model;
    std::vector<OfBody> bodies;
};

}  // namespace grit::mpm::space
