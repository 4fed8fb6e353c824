// SPDX-License-Identifier: BSD-3-Clause
// A surface of triangles that rides on a body: each vertex keeps its place between the sides of the particle that was
// nearest to it at the start.
#pragma once

#include <vector>

#include "adapters/mpm/space/kernel/particles.hpp"
#include "adapters/mpm/space/step/free_faces.hpp"

namespace grit::mpm::space {

class RiddenMesh {
  public:
    RiddenMesh() = default;
    // Its triangles are divided until no edge is longer. Particles: at the start.
    RiddenMesh(const TriangleMesh& mesh, double longest, const ParticleView& particles,
               std::ptrdiff_t count, const int* ids);
    bool empty() const { return facet.empty(); }
    // Triangles whose vertices all have a particle that is near: place_of(id), -1 where it is not.
    template <class PlaceOf>
    void place(const ParticleView& q, const PlaceOf& place_of, TriangleMesh& out) const {
        out.clear();
        std::vector<std::ptrdiff_t> vertex(riders.size(), -1);
        for (std::size_t f = 0; f + 2 < facet.size(); f += 3) {
            std::ptrdiff_t on[3];
            bool all = true;
            for (std::size_t k = 0; k < 3; ++k) {
                on[k] = place_of(riders[facet[f + k]].id);
                all = all && on[k] >= 0;
            }
            for (std::size_t k = 0; all && k < 3; ++k) {
                std::ptrdiff_t& v = vertex[facet[f + k]];
                if (v < 0) {
                    v = out.vertices();
                    const Vector3 x = now(riders[facet[f + k]], q, on[k]);
                    out.position.insert(out.position.end(), x.c, x.c + 3);
                }
                out.facet.push_back(v);
            }
        }
    }

  private:
    struct Rider {
        int id;
        Vector3 from;  // the centre of its particle, at the start [m]
    };
    static Vector3 now(const Rider& rider, const ParticleView& q, std::ptrdiff_t p) {
        Vector3 x = q.position(p);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) x[i] += q.F(i, j, p) * rider.from[j];
        return x;
    }

    std::vector<Rider> riders;
    std::vector<std::size_t> facet;  // three riders each
};

}  // namespace grit::mpm::space
