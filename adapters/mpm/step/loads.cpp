// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace grit::mpm {

void Loads::add(Traction traction) {
    expect(traction.body, traction.on_mixture);
    tractions.push_back(std::move(traction));
    edges.resize(tractions.size());
}

void Loads::set(std::vector<Traction> of_this_process) {
    tractions = std::move(of_this_process);
    edges.assign(tractions.size(), {});
}

// Of the bits of a double, 46 are left to the largest force, six to sums of many.
double Loads::quantum() const {
    double largest = 0.0;
    for (const EdgeForces& f : edges)
        for (const int k : {0, 1})
            largest = std::max({largest, std::abs(f.f_r[k]), std::abs(f.f_z[k])});
    model.exchange.max(&largest, 1);
    return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest) - 46) : 0.0;
}

void Loads::push() {
    const auto has_none = [](const std::vector<Vector2>& of_body) { return of_body.empty(); };
    if (std::all_of(nodes.begin(), nodes.end(), has_none) &&
        std::all_of(on_mixture.begin(), on_mixture.end(), has_none))
        return;
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        const Traction& traction = tractions[i];
        Part& part = model.parts[traction.body];
        const std::ptrdiff_t p = part.find(traction.particle);
        edges[i] = {};
        if (p >= 0)
            edges[i] = edge_forces(model.grid(), part.body.particles.view(), p, traction.edge,
                                   traction.stress(model.t), model.settings);
    }
    const double rounded_to = model.settings.fixed_point ? quantum() : 0.0;
    for (Forces* all : {&nodes, &on_mixture})
        for (std::vector<Vector2>& of_body : *all)
            std::fill(of_body.begin(), of_body.end(), Vector2{0.0, 0.0});
    for (std::size_t i = 0; i < tractions.size(); ++i)
        if (is_here(tractions[i]))
            add_edge_forces(model.grid(), edges[i], rounded_to,
                            forces_of(tractions[i])[tractions[i].body].data());
    share(nodes, [this](std::size_t body, std::size_t node, const Vector2& force) {
        NodeRecord& grains = model.parts[body].records[node];
        grains[record::f_r] += force[0];
        grains[record::f_z] += force[1];
    });
    share(on_mixture, [this](std::size_t body, std::size_t node, const Vector2& force) {
        if (force[0] != 0.0 || force[1] != 0.0) water.load(body, node, force);
    });
}

std::vector<double> Loads::words() const {
    std::vector<double> out;
    for (const Traction& t : tractions)
        out.insert(out.end(), {static_cast<double>(t.body), static_cast<double>(t.particle),
                               static_cast<double>(t.edge), t.on_mixture ? 1.0 : 0.0});
    return out;
}

void Loads::find_work() {
    done = Total();
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        const Traction& traction = tractions[i];
        if (!is_here(traction)) continue;
        const auto twice = [&](std::size_t node, int k) {
            const NodeMotion& v = model.parts[traction.body].motions[node];
            return traction.on_mixture ? water.loaded_velocity(traction.body, node, k)
                                       : v[motion::v_r + k] + v[motion::other_r + k];
        };
        done.add(edge_work(model.grid(), edges[i], model.dt, twice), model.settings.fixed_point);
    }
}

Vector2 Loads::force(std::size_t body) const {
    const bool fixed_point = model.settings.fixed_point;
    std::array<Total, 2> sum;
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        if (tractions[i].body != body) continue;
        sum[0].add(edges[i].f_r[0] + edges[i].f_r[1], fixed_point);
        sum[1].add(edges[i].f_z[0] + edges[i].f_z[1], fixed_point);
    }
    model.exchange.sum(sum, fixed_point);
    return {sum[0].value(), sum[1].value()};
}

}  // namespace grit::mpm
