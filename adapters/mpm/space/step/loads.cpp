// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/loads.hpp"

#include <utility>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/space/step/grid_point.hpp"

namespace grit::mpm::space {

void Loads::add(Traction traction) {
    nodes[traction.body].resize(model.nodes());
    tractions.push_back(std::move(traction));
    faces.resize(tractions.size());
}

Loads::FaceForces Loads::forces_of(const Traction& traction) {
    Part& part = model.parts[traction.body];
    const ParticleView q = part.body.particles.view();
    const std::ptrdiff_t p = part.by_id[static_cast<std::size_t>(traction.particle)];
    const auto place = baseline::place_of(model.grid(), q, p);
    const int d = traction.face.direction, a = (d + 1) % 3, b = (d + 2) % 3;
    const double side = traction.face.upper ? 1.0 : -1.0;
    Vector3 r[3];
    for (int k = 0; k < 3; ++k) {
        const double l = q[column::l_x + k][p];
        r[k] = {l * q.F(0, k, p), l * q.F(1, k, p), l * q.F(2, k, p)};
    }
    const double area = 4.0 * norm(baseline::cross(r[a], r[b]));
    FaceForces out;
    out.each = 0.25 * area * traction.stress(model.t);
    for (int k = 0; k < 4; ++k) {
        out.corner[k] = place.at;
        if (model.settings.shape != Shape::cpdi) continue;
        const Vector3* of = place.domain.r;
        out.corner[k] =
            place.at + side * of[d] + (k & 1 ? 1.0 : -1.0) * of[a] + (k & 2 ? 1.0 : -1.0) * of[b];
    }
    return out;
}

void Loads::find() {
    if (tractions.empty()) return;
    for (std::vector<Vector3>& of_body : nodes)
        std::fill(of_body.begin(), of_body.end(), Vector3{0.0, 0.0, 0.0});
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        faces[i] = forces_of(tractions[i]);
        Vector3* to = nodes[tractions[i].body].data();
        for (const Vector3& corner : faces[i].corner) {
            const GridPoint at = grid_point(model.grid(), corner);
            for (int n = 0; n < 8; ++n) to[at.node[n]] = to[at.node[n]] + at.N[n] * faces[i].each;
        }
    }
}

void Loads::find_work() {
    done = 0.0;
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        const NodeMotion* motions = model.parts[tractions[i].body].motions.data();
        for (const Vector3& corner : faces[i].corner) {
            const GridPoint at = grid_point(model.grid(), corner);
            for (int n = 0; n < 8; ++n)
                for (int k = 0; k < 3; ++k) {
                    const NodeMotion& v = motions[at.node[n]];
                    done += 0.5 * model.dt * at.N[n] * faces[i].each[k] *
                            (v[motion::v_x + k] + v[motion::other_x + k]);
                }
        }
    }
}

Vector3 Loads::force(std::size_t body) const {
    Vector3 sum{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < tractions.size(); ++i)
        if (tractions[i].body == body) sum = sum + 4.0 * faces[i].each;
    return sum;
}

}  // namespace grit::mpm::space
