// SPDX-License-Identifier: BSD-3-Clause
// Two bodies as blocks of grid nodes with surfaces that are cut through their cells, for the surface contact.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <grit/contact_surface.h>
#include <gtest/gtest.h>

namespace tests {

// A body in two or three dimensions: nodes of a grid with spacing 1, vertices anywhere in it.
struct GridBody {
    int components = 2, size = 8;  // nodes along each direction
    bool rigid = false;
    std::vector<double> position, mass, v, v_old, weight, vertex_velocity, spacing;
    std::vector<std::ptrdiff_t> facet, node;
    std::vector<int> fixed;

    std::ptrdiff_t nodes() const {
        std::ptrdiff_t n = 1;
        for (int c = 0; c < components; ++c) n *= size;
        return n;
    }
    int corners() const { return 1 << components; }
    void fill(std::mt19937_64& random, double speed, double mass_spread) {
        const auto dice = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        for (std::ptrdiff_t i = 0; i < nodes(); ++i) {
            mass.push_back(std::pow(10.0, dice(-mass_spread, mass_spread)));
            for (int c = 0; c < components; ++c) v.push_back(speed * dice(-1.0, 1.0));
        }
        v_old = v;
        fixed.assign(mass.size(), 0);
    }
    // Mass 1 per length or area over [low, high] along all directions but the last.
    void weigh(double low, double high) {
        const auto below = [](double x) {  // of the hat at 0 over (-infinity, x]
            const double at = std::min(std::max(x, -1.0), 1.0);
            return at < 0.0 ? 0.5 * (1.0 + at) * (1.0 + at) : 1.0 - 0.5 * (1.0 - at) * (1.0 - at);
        };
        mass.assign(static_cast<std::size_t>(nodes()), 1.0);
        for (std::size_t i = 0; i < mass.size(); ++i) {
            int place = static_cast<int>(i);
            for (int c = 0; c + 1 < components; ++c, place /= size)
                mass[i] *= below(high - place % size) - below(low - place % size) + 1e-12;
        }
    }
    // Along the last direction.
    double velocity_of_vertex(std::size_t vertex) const {
        double sum = 0.0;
        const auto n = static_cast<std::size_t>(corners());
        for (std::size_t k = vertex * n; k < (vertex + 1) * n; ++k)
            sum += weight[k] * v[static_cast<std::size_t>(node[k] * components + components - 1)];
        return sum;
    }
    std::size_t vertices() const { return position.size() / static_cast<std::size_t>(components); }
    void add_vertex(const std::array<double, 3>& x) {
        position.insert(position.end(), x.begin(), x.begin() + components);
        for (int corner = 0; corner < corners(); ++corner) {
            std::ptrdiff_t id = 0, stride = 1;
            double N = 1.0;
            for (int c = 0; c < components; ++c, stride *= size) {
                const int cell =
                    std::min(std::max(static_cast<int>(std::floor(x[c])), 0), size - 2);
                const bool upper = corner >> c & 1;
                id += stride * (cell + upper);
                N *= upper ? x[c] - cell : 1.0 - (x[c] - cell);
            }
            node.push_back(id);
            weight.push_back(N);
        }
        for (int c = 0; c < components; ++c) vertex_velocity.push_back(0.0);
    }
    grit_surface surface() {
        grit_surface s{};
        s.struct_size = sizeof s;
        s.rigid = rigid;
        s.nodes_each = corners();
        s.vertices = static_cast<std::ptrdiff_t>(position.size()) / components;
        s.facets = static_cast<std::ptrdiff_t>(facet.size()) / components;
        s.position = grit_view_of(position.data(), components, 1);
        s.facet = facet.data();
        s.node = node.data();
        s.weight = weight.data();
        s.nodes = nodes();
        s.mass = grit_view_of(mass.data(), 1, 1);
        s.fixed = fixed.data();
        s.velocity = grit_mutable_view_of(v.data(), components, 1);
        s.previous_velocity = grit_view_of(v_old.data(), components, 1);
        s.vertex_velocity = grit_view_of(vertex_velocity.data(), components, 1);
        s.spacing = spacing.empty() ? nullptr : spacing.data();
        return s;
    }
    double kinetic() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < v.size(); ++i)
            sum += 0.5 * mass[i / static_cast<std::size_t>(components)] * v[i] * v[i];
        return rigid ? 0.0 : sum;
    }
    std::array<double, 3> momentum() const {
        std::array<double, 3> sum{};
        for (std::size_t i = 0; i < v.size(); ++i)
            sum[i % static_cast<std::size_t>(components)] +=
                mass[i / static_cast<std::size_t>(components)] * v[i];
        return sum;
    }
};

// The top of a block at z = height(x, y), or the bottom of the one above (upper), over [low, high] in n parts; the last
// coordinate is the height.
template <class Height>
void add_face(GridBody& body, bool upper, double low, double high, int n, const Height& height) {
    const auto first = static_cast<std::ptrdiff_t>(body.position.size()) / body.components;
    const auto at = [&](int i) { return low + (high - low) * i / n; };
    if (body.components == 2) {
        for (int i = 0; i <= n; ++i) body.add_vertex({at(i), height(at(i), 0.0), 0.0});
        for (int i = 0; i < n; ++i) {
            const std::ptrdiff_t a = first + i, b = a + 1;
            if (upper) body.facet.insert(body.facet.end(), {a, b});
            else body.facet.insert(body.facet.end(), {b, a});
        }
        return;
    }
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) body.add_vertex({at(i), at(j), height(at(i), at(j))});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const std::ptrdiff_t a = first + j * (n + 1) + i, b = a + 1, c = b + n + 1,
                                 d = a + n + 1;
            if (upper) body.facet.insert(body.facet.end(), {a, c, b, a, d, c});
            else body.facet.insert(body.facet.end(), {a, b, c, a, c, d});
        }
}

struct SurfaceCall {
    grit_surface_options options{};
    grit_surface_totals totals{};
    std::vector<grit_surface_report> reports;
    std::vector<double> workspace;
    grit_error error{};

    explicit SurfaceCall(int components = 2, double mu = 0.0) {
        grit_surface_options_init(&options, sizeof options);
        options.components = components;
        options.friction_coefficient = mu;
        options.time_step = 1e-2;
        options.spacing = 2.0;
        options.reach = 1.0;
        options.sweep_tolerance = 1e-13;
        options.sweep_limit = 20000;
        totals.struct_size = sizeof totals;
    }
    template <class Body> grit_status operator()(Body& body_a, Body& body_b) {
        const grit_surface a = body_a.surface(), b = body_b.surface();
        reports.resize(static_cast<std::size_t>(a.facets));
        std::size_t needed = grit_surface_workspace_size(&a, &b);
        grit_status status = GRIT_OK;
        do {
            workspace.resize(needed / sizeof(double) + 1);
            status = grit_surface_correct(&options, &a, &b, workspace.data(),
                                          workspace.size() * sizeof(double), &needed,
                                          reports.data(), &totals, &error);
        } while (needed > 0);
        return status;
    }
};

// A wavy interface through the cells, closed or nearly so, its sides of unlike facets.
struct Meeting {
    GridBody a, b;
    Meeting(int components, std::uint64_t seed, double mass_spread = 3.0) {
        std::mt19937_64 random(seed);
        const auto dice = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        const double level = dice(3.0, 4.0), high = dice(0.0, 0.2), phase = dice(0.0, 6.0);
        const double gap = seed % 2 == 0 ? 0.0 : dice(-0.1, 0.02);
        const auto wave = [=](double x, double y) {
            return level + high * std::sin(0.9 * x + 0.7 * y + phase);
        };
        a.components = b.components = components;
        const int n_a = components == 2 ? 11 : 4, n_b = components == 2 ? 7 : 5;
        add_face(a, false, 0.5, 6.4, n_a, wave);
        add_face(b, true, 0.2, 6.1, n_b, [&](double x, double y) { return wave(x, y) + gap; });
        a.fill(random, 1.0, mass_spread);
        b.fill(random, 1.0, mass_spread);
        for (GridBody* body : {&a, &b})  // some nodes are held in a direction
            for (int& mask : body->fixed)
                if (random() % 20 == 0) mask = 1 << random() % static_cast<unsigned>(components);
    }
};

struct BlockAndFloor {
    GridBody floor, block;
};

// A rigid floor seven cells long in so many facets, and a block at a gap above it that comes down.
inline BlockAndFloor block_above_floor(int facets, double gap, double speed) {
    BlockAndFloor out;
    add_face(out.floor, false, 0.0, 7.0, facets, [](double, double) { return 3.0; });
    add_face(out.block, true, 0.0, 7.0, facets, [gap](double, double) { return 3.0 + gap; });
    out.floor.rigid = true;
    std::mt19937_64 random(1);
    out.block.fill(random, 0.0, 0.0);
    out.block.weigh(0.0, 7.0);
    for (std::size_t i = 1; i < out.block.v.size(); i += 2) out.block.v[i] = -speed;
    return out;
}

}  // namespace tests
