// SPDX-License-Identifier: BSD-3-Clause
// A surface of triangles that rides on a body: each vertex keeps its place between the sides of the particle that was
// nearest to it at the start.
#pragma once

#include <vector>

#include "adapters/mpm/space/kernel/particles.hpp"
#include "adapters/mpm/space/step/free_faces.hpp"
#include "adapters/mpm/step/nearest_particles.hpp"

namespace grit::mpm::space {

// Where a vertex of it is.
struct NearVertex {
    std::ptrdiff_t number = 0;
    Vector3 at;
};

class RiddenMesh {
  public:
    RiddenMesh() = default;
    // Its triangles are divided until no edge is longer.
    RiddenMesh(const TriangleMesh& mesh, double longest);
    bool empty() const { return facet.empty(); }
    // A body without particles carries none.
    bool has_riders() const { return !empty() && riders[0].id != Seat::none; }
    // Particles of this process, at the start; all processes that share the grid call it. Does nothing where there are some.
    void find_riders(const ParticleView& q, std::ptrdiff_t count, const int* ids,
                     Exchange& exchange);
    // take(vertex) of those whose particle is near, in order: place_of(id) is here, -1 where it is not.
    template <class PlaceOf, class Take>
    void each_near(const ParticleView& q, const PlaceOf& place_of, const Take& take) const {
        for (std::size_t v = 0; v < riders.size(); ++v) {
            const std::ptrdiff_t p = place_of(static_cast<int>(riders[v].id));
            if (p >= 0) take(NearVertex{static_cast<std::ptrdiff_t>(v), now(riders[v], q, p)});
        }
    }
    // Triangles all of whose vertices are near, in the order of the mesh.
    void place(const std::vector<NearVertex>& near, TriangleMesh& out);

    // The same on all processes.
    template <class Self, class Archive> static void visit(Self& mesh, Archive& archive) {
        for (auto& rider : mesh.riders) archive.value(rider);
    }

  private:
    using Seat = Rider<3>;  // from the centre of its particle, at the start [m]
    static Vector3 now(const Seat& seat, const ParticleView& q, std::ptrdiff_t p) {
        Vector3 x = q.position(p);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) x[i] += q.F(i, j, p) * seat.from[j];
        return x;
    }

    std::vector<double> start;                       // three coordinates of each vertex [m]
    std::vector<Seat> riders;                        // of each vertex
    std::vector<std::size_t> facet;                  // three vertices each
    std::vector<std::ptrdiff_t> near_of, vertex_of;  // of place: by vertex, by near one; -1: none
};

}  // namespace grit::mpm::space
