// SPDX-License-Identifier: BSD-3-Clause
// All contacts at surfaces, one after the other.
#pragma once

#include <vector>

#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/surface_pair.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class SurfaceContacts {
  public:
    SurfaceContacts(Model& of, Water& in_pores) : model(of), water(in_pores) {}
    void add(const SurfaceLaw& law);
    // Velocities after the momentum update become those after contact; adds what it took and what rigid bodies did.
    void correct(Energy& sums);
    // Of a body with implicit pressure, between correct and take_changes.
    std::vector<SurfaceRows*> rows_of(std::size_t body);
    // Before implicit pressures change what bears, and after: what contact takes and rigid bodies do besides.
    void keep_damped();
    void take_changes(Energy& sums);
    // The same for those of them that act on what local damping leaves.
    void correct_damped(Energy& sums);
    bool any_after_damping() const;

    const SurfacePair& operator[](std::size_t i) const { return pairs[i]; }
    std::size_t count() const { return pairs.size(); }
    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        for (auto& pair : of.pairs) SurfacePair::visit(pair, archive);
    }

  private:
    SurfaceBody body(std::size_t i);
    bool is_implicit() const;
    // Of those that are near, together. damped: of those that act after damping.
    void correct(bool damped, Energy& sums);

    Model& model;
    Water& water;
    std::vector<SurfacePair> pairs;
    SurfaceCalls calls;
    std::vector<SurfacePair*> called;  // in the last of them
    std::vector<double> are_near;      // 1: of any process
};

}  // namespace grit::mpm
