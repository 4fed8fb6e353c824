// SPDX-License-Identifier: BSD-3-Clause
// From particles to nodes.
#pragma once

#include <functional>
#include <vector>

#include "adapters/mpm/step/cell_means.hpp"
#include "adapters/mpm/step/integer_records.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

// Fills the columns b_r, b_z, an acceleration besides gravity, for time t.
using BodyForce =
    std::function<void(ParticleView, std::ptrdiff_t begin, std::ptrdiff_t end, double t)>;

// Nodes of a body that a scatter adds to, instead of its records, and strips that have to.
struct ScatterTarget {
    std::vector<NodeRecord> records = {};  // empty: nothing of this body is wanted
    std::vector<char> strips = {};         // 1: wanted
};

class Scatter {
  public:
    Scatter(Model& of, CellMeans& of_cells, Water& in_pores)
        : model(of), means(of_cells), water(in_pores) {}
    void add_body();
    void set_body_force(BodyForce force) { body_force = std::move(force); }

    void clear();
    // Adds parts (part::mass ...) to the records of all bodies, all of them to those of water too. Throws std::runtime_error where a contribution
    // is infinite or no number, in fixed point.
    void operator()(unsigned parts);
    // ... to other nodes, of this process alone.
    void into(std::vector<ScatterTarget>& targets, unsigned parts);

    template <class Self, class Archive> static void visit(Self& scatter, Archive& archive) {
        for (auto& body : scatter.integers) IntegerRecords::visit(body, archive);
    }

  private:
    std::vector<NodeRecord>& nodes(std::size_t body, std::vector<ScatterTarget>* targets) const;
    void add(unsigned parts, std::vector<ScatterTarget>* targets);
    void add_fixed(unsigned parts, std::vector<ScatterTarget>* targets);
    bool check(unsigned parts, const std::vector<ScatterTarget>* targets);

    Model& model;
    CellMeans& means;
    Water& water;
    BodyForce body_force;
    std::vector<IntegerRecords> integers;  // of bodies, in fixed point
};

}  // namespace grit::mpm
