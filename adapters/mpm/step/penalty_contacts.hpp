// SPDX-License-Identifier: BSD-3-Clause
// All penalty contacts: their forces are found at the end of a step and pushed in the next one, whose size
// they limit.
#pragma once

#include <vector>

#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/penalty_pair.hpp"
#include "adapters/mpm/step/scatter.hpp"

namespace grit::mpm {

class PenaltyContacts {
  public:
    PenaltyContacts(Model& of, Scatter& masses) : model(of), scatter(masses) {}
    // Throws std::invalid_argument where processes share the grid.
    void add(const PenaltyLaw& law);

    // Forces of the lines where they are now, and how stiff what they have just touched is.
    void find_forces();
    // Adds them to those of the nodes, and the work of rigid bodies.
    void push(Energy& sums);
    // Vertices move with their bodies; adds what the forces took.
    void move(Energy& sums);

    const PenaltyPair& operator[](std::size_t i) const { return pairs[i]; }
    std::size_t count() const { return pairs.size(); }
    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        for (auto& pair : of.pairs) PenaltyPair::visit(pair, archive);
    }

  private:
    PenaltyBody body(std::size_t i);
    PenaltyBody body_ahead(std::size_t i);
    bool find_pressed_strips();

    Model& model;
    Scatter& scatter;
    std::vector<PenaltyPair> pairs;
    std::vector<ScatterTarget> ahead;  // masses at the end of the step
};

}  // namespace grit::mpm
