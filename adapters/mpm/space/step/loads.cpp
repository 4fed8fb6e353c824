// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/space/step/grid_point.hpp"

namespace grit::mpm::space {

void Loads::add(Traction traction) {
    expect(traction.body);
    tractions.push_back(std::move(traction));
    faces.resize(tractions.size());
}

void Loads::set(std::vector<Traction> of_this_process) {
    tractions = std::move(of_this_process);
    faces.assign(tractions.size(), {});
}

std::vector<double> Loads::words() const {
    std::vector<double> out;
    for (const Traction& t : tractions)
        out.insert(out.end(),
                   {static_cast<double>(t.body), static_cast<double>(t.particle),
                    static_cast<double>(t.face.direction), t.face.upper ? 1.0 : 0.0, t.share});
    return out;
}

Loads::FaceForces Loads::forces_of(const Traction& traction) {
    Part& part = model.parts[traction.body];
    const ParticleView q = part.body.particles.view();
    const std::ptrdiff_t p = part.find(traction.particle);
    if (p < 0) return {};
    const auto place = baseline::place_of(model.grid(), q, p);
    const int d = traction.face.direction, a = (d + 1) % 3, b = (d + 2) % 3;
    const double side = traction.face.upper ? 1.0 : -1.0;
    Vector3 r[3];
    for (int k = 0; k < 3; ++k) {
        const double l = q[column::l_x + k][p];
        r[k] = {l * q.F(0, k, p), l * q.F(1, k, p), l * q.F(2, k, p)};
    }
    const double area = 4.0 * traction.share * norm(baseline::cross(r[a], r[b]));
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
    const auto has_none = [](const std::vector<Vector3>& of_body) { return of_body.empty(); };
    if (std::all_of(nodes.begin(), nodes.end(), has_none)) return;
    for (std::vector<Vector3>& of_body : nodes)
        std::fill(of_body.begin(), of_body.end(), Vector3{0.0, 0.0, 0.0});
    for (std::size_t i = 0; i < tractions.size(); ++i) faces[i] = forces_of(tractions[i]);
    const double quantum = model.settings.fixed_point ? find_quantum() : 0.0;
    const auto rounded = [quantum](double x) {
        return quantum > 0.0 ? std::nearbyint(x / quantum) * quantum : x;
    };
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        if (!is_here(tractions[i])) continue;
        Vector3* to = nodes[tractions[i].body].data();
        for (const Vector3& corner : faces[i].corner) {
            const GridPoint at = grid_point(model.grid(), corner);
            for (int n = 0; n < 8; ++n)
                for (int k = 0; k < 3; ++k)
                    to[at.node[n]][k] += rounded(at.N[n] * faces[i].each[k]);
        }
    }
    for (std::vector<Vector3>& of_body : nodes)
        if (!of_body.empty())
            model.exchange.sum_nodes(of_body.data()->c, static_cast<std::ptrdiff_t>(of_body.size()),
                                     3);
}

// Of the bits of a double, 40 are left to the largest force, twelve to sums of many, four for each particle of a cell's face:
// no order changes them.
double Loads::find_quantum() const {
    double largest = 0.0;
    for (const FaceForces& face : faces)
        for (int k = 0; k < 3; ++k) largest = std::max(largest, std::fabs(face.each[k]));
    model.exchange.max(&largest, 1);
    return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest) - 40) : 0.0;
}

void Loads::find_work() {
    done = {};
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        if (!is_here(tractions[i])) continue;
        const NodeMotion* motions = model.parts[tractions[i].body].motions.data();
        for (const Vector3& corner : faces[i].corner) {
            const GridPoint at = grid_point(model.grid(), corner);
            for (int n = 0; n < 8; ++n)
                for (int k = 0; k < 3; ++k) {
                    const NodeMotion& v = motions[at.node[n]];
                    done.add(0.5 * model.dt * at.N[n] * faces[i].each[k] *
                                 (v[motion::v_x + k] + v[motion::other_x + k]),
                             model.settings.fixed_point);
                }
        }
    }
}

Vector3 Loads::force(std::size_t body) const {
    const bool fixed_point = model.settings.fixed_point;
    std::array<Total, 3> sum;
    for (std::size_t i = 0; i < tractions.size(); ++i)
        for (std::size_t k = 0; k < 3 && tractions[i].body == body; ++k)
            sum[k].add(4.0 * faces[i].each[static_cast<int>(k)], fixed_point);
    model.exchange.sum(sum, fixed_point);
    return {sum[0].value(), sum[1].value(), sum[2].value()};
}

}  // namespace grit::mpm::space
