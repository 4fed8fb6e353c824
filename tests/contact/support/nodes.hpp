// SPDX-License-Identifier: BSD-3-Clause
// Nodes of a host that keeps one structure per node, and calls of the correction on them.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <grit/contact.h>
#include <gtest/gtest.h>

#include "support/trials/split_mix.hpp"

namespace tests {

using Random = grit::SplitMix;
using Vec = std::array<double, 3>;

inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double norm(const Vec& a) { return std::sqrt(dot(a, a)); }

struct Node {
    double m_a = 1.0, m_b = 1.0;
    Vec n = {1.0, 0.0, 0.0};
    double s = 0.0, d = 1.0, gap = 0.0, area = 1.0, pore_impulse = 0.0;
    Vec v_a = {}, v_b = {}, a_a = {}, a_b = {}, old_a = {}, old_b = {}, x = {};
    Vec w() const { return v_a - v_b; }
    Vec momentum() const { return m_a * v_a + m_b * v_b; }
    double m_r() const { return m_a / (m_a + m_b) * m_b; }
};

inline grit_contact_options options_with(int components = 3) {
    grit_contact_options options;
    grit_contact_options_init(&options, sizeof options);
    options.components = components;
    options.mass_tolerance = 0.0;
    return options;
}

struct Nodes {
    std::vector<Node> node;
    std::vector<grit_contact_report> reports;
    grit_contact_sums sums{};
    grit_error error{};
    bool gated = false, accelerated = false, remembered = false, saturated = false;

    Nodes() = default;
    explicit Nodes(std::vector<Node> nodes) : node(std::move(nodes)) {}

    static grit_view in(const double* first) {
        return grit_view_of(first, sizeof(Node) / sizeof(double), 1);
    }
    static grit_mutable_view out(double* first) {
        return grit_mutable_view_of(first, sizeof(Node) / sizeof(double), 1);
    }
    grit_contact_nodes views() {
        Node& x = node[0];
        grit_contact_nodes q{};
        q.struct_size = sizeof q;
        q.mass_a = in(&x.m_a);
        q.mass_b = in(&x.m_b);
        q.normal = in(x.n.data());
        q.distance = in(&x.s);
        q.cell_size = in(&x.d);
        q.contact_area = in(&x.area);
        q.position = in(x.x.data());
        q.velocity_a = out(x.v_a.data());
        q.velocity_b = out(x.v_b.data());
        if (gated) q.gap = in(&x.gap);
        if (saturated) q.pore_impulse = in(&x.pore_impulse);
        if (accelerated) {
            q.acceleration_a = out(x.a_a.data());
            q.acceleration_b = out(x.a_b.data());
        }
        if (remembered) {
            q.previous_velocity_a = in(x.old_a.data());
            q.previous_velocity_b = in(x.old_b.data());
        }
        return q;
    }
    std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(node.size()); }
    grit_status correct(const grit_contact_options& options) {
        return correct(options, views(), size());
    }
    grit_status correct(const grit_contact_options& options, const grit_contact_nodes& q,
                        std::ptrdiff_t n) {
        reports.assign(node.size(), {});
        return grit_contact_correct(&options, n, &q, reports.data(), &sums, &error);
    }
};

inline bool same_bits(const std::vector<Node>& a, const std::vector<Node>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}
inline bool same_bits(const Vec& a, const Vec& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

inline Vec random_vector(Random& random, int components) {
    Vec v = {random.normal(), random.normal(), components == 3 ? random.normal() : 0.0};
    return v;
}
inline Vec random_unit(Random& random, int components) {
    const Vec v = random_vector(random, components);
    return (1.0 / norm(v)) * v;
}

// Two bodies with masses of 1e-6 ... 1e6 that come closer or part, surfaces near the node.
inline Node random_node(Random& random, int components) {
    Node x;
    x.m_a = random.log_uniform(1e-6, 1e6);
    x.m_b = random.log_uniform(1e-6, 1e6);
    x.n = random_unit(random, components);
    x.d = random.log_uniform(0.1, 10.0);
    x.s = random.uniform(-0.5, 1.5) * x.d;
    x.gap = random.uniform(-1.0, 1.0);
    x.area = random.log_uniform(0.01, 1.0);
    for (Vec* v : {&x.v_a, &x.v_b, &x.a_a, &x.a_b, &x.old_a, &x.old_b, &x.x})
        *v = random_vector(random, components);
    return x;
}

inline Nodes random_nodes(std::size_t n, int components, std::uint64_t seed) {
    Random random(seed);
    Nodes nodes;
    for (std::size_t i = 0; i < n; ++i) nodes.node.push_back(random_node(random, components));
    return nodes;
}

}  // namespace tests
