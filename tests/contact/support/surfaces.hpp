// SPDX-License-Identifier: BSD-3-Clause
// Nodes, particle domains and the distances between them, as a host would keep them.
#pragma once

#include <limits>

#include <grit/contact_distance.h>

#include "support/clouds.hpp"

namespace tests {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Minima of nodes at given places with given normals.
struct Surfaces {
    int components;
    std::vector<Vec3> position, normal;
    std::vector<double> surface, centre;

    Surfaces(int c, std::vector<Vec3> x, std::vector<Vec3> n)
        : components(c), position(std::move(x)), normal(std::move(n)) {
        surface.assign(2 * position.size(), -3.0);
        centre.assign(2 * position.size(), -3.0);
        const grit_contact_surfaces s = views();
        EXPECT_EQ(grit_contact_surfaces_reset(&s, nullptr), GRIT_OK);
    }
    grit_contact_surfaces views() {
        grit_contact_surfaces s{};
        s.struct_size = sizeof s;
        s.components = components;
        s.nodes = static_cast<std::ptrdiff_t>(position.size());
        s.position = grit_view_of(position[0].data(), 3, 1);
        s.normal = grit_view_of(normal[0].data(), 3, 1);
        s.surface = grit_mutable_view_of(surface.data(), 2, 1);
        s.centre = grit_mutable_view_of(centre.data(), 2, 1);
        return s;
    }
};

using Sides = std::array<Vec3, 3>;
inline const Sides no_sides = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

struct Domain {
    Vec3 x;
    Sides r;
    std::vector<std::ptrdiff_t> nodes;
};

struct Domains {
    int sides;
    std::vector<Domain> particles;
    std::vector<std::ptrdiff_t> offset{0}, node;

    Domains(int s, std::vector<Domain> p) : sides(s), particles(std::move(p)) {
        for (const Domain& each : particles) {
            node.insert(node.end(), each.nodes.begin(), each.nodes.end());
            offset.push_back(static_cast<std::ptrdiff_t>(node.size()));
        }
    }
    std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(particles.size()); }
    grit_contact_domains views(int body) {
        constexpr std::ptrdiff_t stride = sizeof(Domain) / sizeof(double);
        grit_contact_domains d{};
        d.struct_size = sizeof d;
        d.body = body;
        d.sides = sides;
        d.offset = offset.data();
        d.node = node.data();
        d.position = grit_view_of(particles[0].x.data(), stride, 1);
        d.side = grit_matrix_view_of(particles[0].r[0].data(), stride, 3, 1);
        return d;
    }
};

inline grit_status add(Surfaces& s, Domains& d, int body, grit_error* error = nullptr) {
    const grit_contact_surfaces surfaces = s.views();
    const grit_contact_domains domains = d.views(body);
    return grit_contact_surfaces_add(&surfaces, d.count(), &domains, error);
}

struct Distances {
    std::vector<double> distance, gap;
};

inline Distances finish(Surfaces& s, int stiffer, int measure = GRIT_CONTACT_SUPPORT) {
    const std::size_t n = s.position.size();
    Distances found{std::vector<double>(n, -7.0), std::vector<double>(n, -7.0)};
    const grit_contact_surfaces surfaces = s.views();
    grit_contact_distances q{};
    q.struct_size = sizeof q;
    q.stiffer = stiffer;
    q.measure = measure;
    q.distance = grit_mutable_view_of(found.distance.data(), 1, 1);
    q.gap = grit_mutable_view_of(found.gap.data(), 1, 1);
    grit_error error{};
    EXPECT_EQ(grit_contact_surfaces_finish(&surfaces, static_cast<std::ptrdiff_t>(n), &q, &error),
              GRIT_OK)
        << error.message;
    return found;
}

inline Domains random_domains(int components, int count, std::ptrdiff_t nodes, Dice& dice) {
    std::vector<Domain> particles;
    for (int p = 0; p < count; ++p) {
        Domain d{dice.inside_ball(components), no_sides, {}};
        for (int j = 0; j < components; ++j)
            d.r[static_cast<std::size_t>(j)] = 0.3 * dice.inside_ball(components);
        for (std::ptrdiff_t i = 0; i < nodes; ++i)
            if (dice.uniform(0.0, 1.0) < 0.6) d.nodes.push_back(i);
        particles.push_back(d);
    }
    return {components, particles};
}

inline Surfaces random_surfaces(int components, std::size_t nodes, Dice& dice) {
    std::vector<Vec3> x, n;
    for (std::size_t i = 0; i < nodes; ++i) {
        x.push_back(dice.inside_ball(components));
        n.push_back(dice.direction(components));
    }
    return {components, x, n};
}

}  // namespace tests
