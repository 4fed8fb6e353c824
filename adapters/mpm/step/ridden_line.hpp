// SPDX-License-Identifier: BSD-3-Clause
// A line that rides on particles: each vertex keeps its place in the domain of the one that was nearest at the start.
// For bodies that deform little, whose domains are coarser than their surface.
#pragma once

#include <span>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/particles.hpp"
#include "adapters/mpm/step/boundary_line.hpp"
#include "adapters/mpm/step/nearest_particles.hpp"

namespace grit::mpm {

class RiddenLine {
  public:
    // Segments are divided until none is longer than this [m].
    RiddenLine(const BoundaryLine& line, double longest);

    bool empty() const { return riders.empty(); }
    // A body without particles carries none.
    bool has_riders() const { return !empty() && riders[0].id != Seat::none; }
    // Particles of this process, at the start; all processes that share the grid call it. Does nothing where there are some.
    void find_riders(const ParticleView& q, std::ptrdiff_t count, const int* ids,
                     Exchange& exchange);
    // Where it is, by the domains of particles by ids (near_domain): vertices, two coordinates each, and facets,
    // two vertices each, with the domain that one of these rides on; without those whose particles are not among them.
    void place(std::span<const KeyedNumbers> domains, std::vector<double>& position,
               std::vector<std::ptrdiff_t>& facet, std::vector<std::ptrdiff_t>& owner) const;

    // The same on all processes.
    template <class Self, class Archive> static void visit(Self& line, Archive& archive) {
        for (auto& rider : line.riders) archive.value(rider);
    }

  private:
    using Seat = Rider<2>;       // from its particle's centre along the half-side vectors [-]
    std::vector<Vector2> start;  // of each vertex [m]
    std::vector<Seat> riders;
    bool closed = false;
};

}  // namespace grit::mpm
