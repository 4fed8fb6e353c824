// SPDX-License-Identifier: BSD-3-Clause
// Bodies of particles in space.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include <adapters/mpm/space/kernel/elastic.hpp>
#include <adapters/mpm/space/step/simulation.hpp>

namespace space_test {

using namespace grit::mpm::space;
using grit::Vector3;
using grit::mpm::Axis;
using grit::mpm::Shape;

inline std::array<Axis, 3> cube_of_cells(double side, int cells) {
    const Axis axis = Axis::uniform(0.0, side, cells);
    return {axis, axis, axis};
}

struct Brick {
    Vector3 from, to;           // [m]
    std::array<int, 3> number;  // of particles
    double density = 1000.0;    // [kg/m3]
};

inline void add_brick(Particles& to, const Brick& brick) {
    Vector3 l;
    for (int d = 0; d < 3; ++d)
        l[d] = 0.5 * (brick.to[d] - brick.from[d]) / brick.number[static_cast<std::size_t>(d)];
    for (int k = 0; k < brick.number[2]; ++k)
        for (int j = 0; j < brick.number[1]; ++j)
            for (int i = 0; i < brick.number[0]; ++i)
                to.add({brick.from +
                            Vector3{(2 * i + 1) * l[0], (2 * j + 1) * l[1], (2 * k + 1) * l[2]},
                        l, brick.density});
}

inline Body make_brick(const Brick& brick, std::unique_ptr<Material> material) {
    Body body;
    body.particles = Particles(material ? material->own_columns() : 0);
    add_brick(body.particles, brick);
    body.material = std::move(material);
    return body;
}

// At rest.
inline Body make_floor(const Brick& brick) {
    Body body = make_brick(brick, nullptr);
    body.make_rigid({});
    return body;
}

inline Vector3 centre_of_mass(const Particles& q) {
    Vector3 sum{0.0, 0.0, 0.0};
    double mass = 0.0;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
        const double m = q(column::mass, p);
        sum = sum + m * Vector3{q(column::x, p), q(column::y, p), q(column::z, p)};
        mass += m;
    }
    return sum / mass;
}

}  // namespace space_test
