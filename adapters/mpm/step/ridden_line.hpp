// SPDX-License-Identifier: BSD-3-Clause
// A line that rides on particles: each vertex keeps its place in the domain of the one that was nearest at the start.
// For bodies that deform little, whose domains are coarser than their surface; moves with no state of its own.
#pragma once

#include <span>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/particles.hpp"
#include "adapters/mpm/step/boundary_line.hpp"

namespace grit::mpm {

class RiddenLine {
  public:
    // At the start; segments are divided until none is longer than this [m].
    RiddenLine(const BoundaryLine& line, double longest, const Particles& particles);

    bool empty() const { return riders.empty(); }
    // Where it is, by the domains of particles by ids (near_domain): vertices, two coordinates each, and facets,
    // two vertices each, with the domain that one of these rides on; without those whose particles are not among them.
    void place(std::span<const KeyedNumbers> domains, std::vector<double>& position,
               std::vector<std::ptrdiff_t>& facet, std::vector<std::ptrdiff_t>& owner) const;

  private:
    struct Rider {
        int id;
        double along_1, along_2;  // of the half-side vectors [-]
    };
    std::vector<Rider> riders;
    bool closed = false;
};

}  // namespace grit::mpm
