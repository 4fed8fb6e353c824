// SPDX-License-Identifier: BSD-3-Clause
// Nodes where several bodies meet.
#pragma once

#include <algorithm>

#include "support/nodes.hpp"

namespace tests {

// A node of m bodies, pairs in the order 01, 02, ..., 12, ...
struct BodiesAtNodes {
    static constexpr std::size_t most = GRIT_CONTACT_MOST_BODIES;
    struct One {
        double m[most];
        Vec v[most], a[most], old[most];
        Vec n[28];
        double s[28], gap[28];
    };
    int count;
    int components = 3;
    std::vector<One> node;
    std::vector<std::pair<int, int>> who;
    std::vector<grit_contact_options> options;
    std::vector<grit_contact_report> reports;
    std::vector<grit_contact_sums> sums;
    grit_contact_bodies call{};
    grit_view gap{}, area{};  // of all pairs; none
    grit_error error{};

    BodiesAtNodes(int bodies, std::size_t nodes, std::uint64_t seed, int dimensions = 3)
        : count(bodies), components(dimensions) {
        Random random(seed);
        for (int a = 0; a < count; ++a)
            for (int b = a + 1; b < count; ++b) who.emplace_back(a, b);
        options.assign(who.size(), options_with(components));
        sums.resize(who.size());
        for (auto& o : options) o.friction_coefficient = 0.3;
        for (std::size_t i = 0; i < nodes; ++i) {
            One x{};
            for (std::size_t b = 0; b < most; ++b) {
                x.m[b] = random.log_uniform(0.1, 10.0);
                x.v[b] = random_vector(random, components);
            }
            for (std::size_t p = 0; p < who.size(); ++p) {
                x.n[p] = random_unit(random, components);
                x.s[p] = random.uniform(-0.5, 1.2);
            }
            node.push_back(x);
        }
    }
    grit_status correct() {
        constexpr std::ptrdiff_t stride = sizeof(One) / sizeof(double);
        std::vector<grit_view> mass;
        std::vector<grit_mutable_view> velocity;
        One& x = node[0];
        for (int b = 0; b < std::min<int>(count, most); ++b) {
            mass.push_back(grit_view_of(&x.m[b], stride, 1));
            velocity.push_back(grit_mutable_view_of(x.v[b].data(), stride, 1));
        }
        static const double d = 1.0;
        std::vector<grit_contact_pair> pairs(who.size());
        for (std::size_t p = 0; p < who.size(); ++p) {
            pairs[p].struct_size = sizeof pairs[p];
            pairs[p].a = who[p].first;
            pairs[p].b = who[p].second;
            pairs[p].options = &options[p];
            pairs[p].normal = grit_view_of(x.n[p].data(), stride, 1);
            pairs[p].distance = grit_view_of(&x.s[p], stride, 1);
            pairs[p].cell_size = grit_view_of(&d, 0, 1);
            pairs[p].gap = gap;
            pairs[p].contact_area = area;
        }
        call.struct_size = sizeof call;
        call.components = components;
        call.count = count;
        call.mass = mass.data();
        call.velocity = velocity.data();
        reports.assign(node.size() * who.size(), {});
        return grit_contact_correct_many(&call, static_cast<int>(pairs.size()), pairs.data(),
                                         static_cast<std::ptrdiff_t>(node.size()), reports.data(),
                                         sums.data(), &error);
    }
};

}  // namespace tests
