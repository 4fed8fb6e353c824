// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/ridden_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm::space {
namespace {

// Far more than a body of particles has cells at its surface; a file in another unit asks for millions.
constexpr std::size_t most_triangles = 1u << 18;

[[noreturn]] void refuse_size(const TriangleMesh& mesh, double longest) {
    Vector3 low = mesh.vertex(0), high = low;
    for (std::ptrdiff_t v = 1; v < mesh.vertices(); ++v)
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], mesh.vertex(v)[k]);
            high[k] = std::max(high[k], mesh.vertex(v)[k]);
        }
    std::string extent;
    for (int k = 0; k < 3; ++k) extent += (k ? " by " : "") + text(high[k] - low[k]);
    throw std::invalid_argument("the surface of a contact is " + extent +
                                " m large: without edges beyond " + text(longest) +
                                " m, the shortest cell, it has more than " +
                                std::to_string(most_triangles) + " triangles; is its unit right?");
}

// Edges that are too long are halved, for both of their triangles, until there is none.
void divide(TriangleMesh& mesh, double longest) {
    for (bool again = true; again;) {
        std::map<std::pair<std::ptrdiff_t, std::ptrdiff_t>, std::ptrdiff_t> middle;
        const auto middle_of = [&](std::ptrdiff_t a, std::ptrdiff_t b) -> std::ptrdiff_t {
            const Vector3 x = mesh.vertex(a), y = mesh.vertex(b);
            if (!(norm(y - x) > longest * (1.0 + 1e-9))) return -1;
            const auto [place, is_new] =
                middle.insert({{std::min(a, b), std::max(a, b)}, mesh.vertices()});
            if (is_new)
                for (int k = 0; k < 3; ++k) mesh.position.push_back(0.5 * (x[k] + y[k]));
            return place->second;
        };
        std::vector<std::ptrdiff_t> finer;
        const auto add = [&finer](std::ptrdiff_t a, std::ptrdiff_t b, std::ptrdiff_t c) {
            finer.insert(finer.end(), {a, b, c});
        };
        for (std::size_t f = 0; f < mesh.facet.size(); f += 3) {
            if (finer.size() > 3 * most_triangles) refuse_size(mesh, longest);
            std::ptrdiff_t v[3] = {mesh.facet[f], mesh.facet[f + 1], mesh.facet[f + 2]}, m[3];
            int count = 0;
            for (int k = 0; k < 3; ++k) {
                m[k] = middle_of(v[k], v[(k + 1) % 3]);
                count += m[k] >= 0;
            }
            // Turned until the first edge is halved, and the last one is not unless all are.
            for (int turn = 0; turn < 2 && count > 0 && count < 3 && (m[0] < 0 || m[2] >= 0);
                 ++turn) {
                std::rotate(v, v + 1, v + 3);
                std::rotate(m, m + 1, m + 3);
            }
            if (count == 0) {
                add(v[0], v[1], v[2]);
            } else if (count == 1) {
                add(v[0], m[0], v[2]);
                add(m[0], v[1], v[2]);
            } else if (count == 2) {
                // What is left has four corners: parted along its shorter diagonal, as its mirror image is.
                add(m[0], v[1], m[1]);
                const double from_first = norm(mesh.vertex(m[1]) - mesh.vertex(v[0]));
                const double from_last = norm(mesh.vertex(m[0]) - mesh.vertex(v[2]));
                if (std::fabs(from_first - from_last) < 1e-9 * longest) {
                    const Vector3 x = mesh.vertex(m[0]), y = mesh.vertex(m[1]);
                    const Vector3 p = mesh.vertex(v[0]), q = mesh.vertex(v[2]);
                    const std::ptrdiff_t centre = mesh.vertices();
                    for (int k = 0; k < 3; ++k)
                        mesh.position.push_back(0.25 * (x[k] + y[k] + p[k] + q[k]));
                    add(v[0], m[0], centre);
                    add(m[0], m[1], centre);
                    add(m[1], v[2], centre);
                    add(v[2], v[0], centre);
                } else if (from_first < from_last) {
                    add(v[0], m[0], m[1]);
                    add(v[0], m[1], v[2]);
                } else {
                    add(v[0], m[0], v[2]);
                    add(m[0], m[1], v[2]);
                }
            } else {
                add(v[0], m[0], m[2]);
                add(m[0], v[1], m[1]);
                add(m[2], m[1], v[2]);
                add(m[0], m[1], m[2]);
            }
        }
        again = !middle.empty();
        mesh.facet = std::move(finer);
    }
}

}  // namespace

RiddenMesh::RiddenMesh(const TriangleMesh& mesh, double longest) {
    TriangleMesh divided = mesh;
    divide(divided, longest);
    start = divided.position;
    riders.resize(start.size() / 3);
    for (const std::ptrdiff_t v : divided.facet) facet.push_back(static_cast<std::size_t>(v));
}

void RiddenMesh::find_riders(const ParticleView& q, std::ptrdiff_t count, const int* ids,
                             Exchange& exchange) {
    if (empty() || has_riders()) return;
    const auto way = [&](std::size_t v, std::ptrdiff_t p) {
        return Vector3{start[3 * v], start[3 * v + 1], start[3 * v + 2]} - q.position(p);
    };
    find_nearest(
        riders, count, ids, exchange, [&](std::ptrdiff_t p) { return q.position(p)[0]; }, way,
        [&](std::size_t v, std::ptrdiff_t p, double* from) { std::copy_n(way(v, p).c, 3, from); });
}

void RiddenMesh::place(const std::vector<NearVertex>& near, TriangleMesh& out) {
    constexpr std::ptrdiff_t none = -1;
    near_of.assign(riders.size(), none);
    vertex_of.assign(near.size(), none);
    for (std::size_t i = 0; i < near.size(); ++i)
        near_of[static_cast<std::size_t>(near[i].number)] = static_cast<std::ptrdiff_t>(i);
    out.clear();
    for (std::size_t f = 0; f + 2 < facet.size(); f += 3) {
        const std::size_t* of = &facet[f];
        if (std::any_of(of, of + 3, [&](std::size_t v) { return near_of[v] == none; })) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(near_of[of[k]]);
            if (vertex_of[i] == none) {
                vertex_of[i] = out.vertices();
                out.position.insert(out.position.end(), near[i].at.c, near[i].at.c + 3);
            }
            out.facet.push_back(vertex_of[i]);
        }
    }
}

}  // namespace grit::mpm::space
