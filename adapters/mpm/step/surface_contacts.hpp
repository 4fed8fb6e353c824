// SPDX-License-Identifier: BSD-3-Clause
// All contacts at surfaces, one after the other.
#pragma once

#include <vector>

#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/surface_pair.hpp"

namespace grit::mpm {

class SurfaceContacts {
  public:
    explicit SurfaceContacts(Model& of) : model(of) {}
    void add(const SurfaceLaw& law);
    // Velocities after the momentum update become those after contact; adds what it took and what rigid bodies did.
    void correct(Energy& sums);
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
    void correct(SurfacePair& pair, bool again, Energy& sums);

    Model& model;
    std::vector<SurfacePair> pairs;
    std::vector<double> are_near;  // 1: of any process
};

}  // namespace grit::mpm
