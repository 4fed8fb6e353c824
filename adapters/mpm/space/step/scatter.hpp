// SPDX-License-Identifier: BSD-3-Clause
// From particles to nodes in space.
#pragma once

#include <functional>
#include <vector>

#include "adapters/mpm/space/step/cell_means.hpp"
#include "adapters/mpm/space/step/water.hpp"
#include "adapters/mpm/step/integer_sums.hpp"

namespace grit::mpm::space {

// Fills the columns b_x, b_y, b_z, an acceleration besides gravity, for time t.
using BodyForce =
    std::function<void(ParticleView, std::ptrdiff_t begin, std::ptrdiff_t end, double t)>;

class Scatter {
  public:
    Scatter(Model& of, CellMeans& of_cells, Water& in_pores)
        : model(of), means(of_cells), water(in_pores) {}
    void add_body();
    // The body meets another one at nodes: gradients for normals are wanted, and forces of its pore pressure.
    void add_slopes(std::size_t body);
    void set_body_force(BodyForce force) { body_force = std::move(force); }

    // Records and slopes of all bodies. Throws std::runtime_error where a contribution is infinite or no number, in
    // fixed point.
    void operator()();

    template <class Self, class Archive> static void visit(Self& scatter, Archive& archive) {
        for (std::size_t i = 0; i < scatter.integers.size(); ++i) {
            auto& body = scatter.integers[i];
            IntegerSums<record::size>::visit(body.records, archive);
            IntegerSums<slope::size>::visit(body.slopes, archive);
            if (scatter.water.has(i)) IntegerSums<slope::size>::visit(body.pore_forces, archive);
        }
    }

  private:
    struct OfBody {
        IntegerSums<record::size> records = {};
        IntegerSums<slope::size> slopes = {}, pore_forces = {};
    };
    void add();
    void begin_fixed();
    bool must_be_done_again();
    void take_fixed();
    void share();

    Model& model;
    CellMeans& means;
    Water& water;
    BodyForce body_force;
    std::vector<OfBody> integers;  // of bodies, in fixed point
};

}  // namespace grit::mpm::space
