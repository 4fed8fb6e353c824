// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/momentum.hpp"

#include <array>

#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

void Momentum::add_body() {
    OfBody& body = bodies.emplace_back();
    body.internal.resize(model.fixed_nodes.size());
    body.sums.resize(static_cast<std::size_t>(model.strips()));
}

NodeCall Momentum::call(std::size_t body, int strip) {
    const Model::Rows rows = model.nodes_of(strip);
    const Settings& settings = model.settings;
    Part& part = model.parts[body];
    return {part.records.data(),
            part.motions.data(),
            bodies[body].internal.data(),
            model.fixed_nodes.data(),
            rows.begin,
            rows.end,
            part.least_mass,
            model.dt,
            model.dt_before,
            {settings.gravity_r, settings.gravity_z},
            settings.scheme == Scheme::musl,
            settings.scheme == Scheme::usf,
            settings.local_damping,
            nullptr,
            nullptr,
            bodies[body].damped.empty() ? nullptr : bodies[body].damped.data(),
            false,
            settings.fixed_point,
            model.exchange.counted()};
}

void Momentum::start_velocities() {
    model.for_strips([this](std::size_t body, int strip) {
        if (is_rigid(body)) return;
        NodeSums& sums = sums_of(body, strip);
        sums = {};
        start_nodes(call(body, strip), sums);
    });
}

void Momentum::keep_internal_forces() {
    model.for_strips([this](std::size_t body, int strip) {
        if (!is_rigid(body)) keep_internal(call(body, strip));
    });
}

void Momentum::advance() {
    model.for_strips([this](std::size_t body, int strip) {
        NodeSums& sums = sums_of(body, strip);
        if (model.settings.scheme != Scheme::usf) sums = {};
        const NodeCall nodes = call(body, strip);
        if (!is_rigid(body)) return advance_nodes(nodes, sums);
        Part& part = model.parts[body];
        const Vector2 v = part.body.prescribed_velocity(model.t + model.dt);
        for (std::ptrdiff_t i = nodes.begin; i < nodes.end; ++i)
            part.motions[static_cast<std::size_t>(i)] = NodeMotion{v[0], v[1], v[0], v[1]};
    });
}

void Momentum::damp(const Water& water, bool tied, bool meets) {
    if (!(model.settings.local_damping > 0.0)) return;
    for (std::size_t body = 0; body < bodies.size(); ++body)
        if (tied || meets || water.is_implicit(body))
            bodies[body].damped.resize(model.fixed_nodes.size());
    model.for_strips([&, this](std::size_t body, int strip) {
        if (is_rigid(body)) return;
        NodeCall nodes = call(body, strip);
        nodes.drag = water.drag_impulses(body);
        if (tied) nodes.tied = water.tied_nodes().data();
        nodes.meets = meets;
        damp_nodes(nodes, sums_of(body, strip));
    });
}

void Momentum::close() {
    model.for_strips([this](std::size_t body, int strip) {
        if (!is_rigid(body)) close_nodes(call(body, strip), sums_of(body, strip));
    });
}

void Momentum::forget() {
    model.for_strips([this](std::size_t body, int strip) {
        const Model::Rows rows = model.nodes_of(strip);
        for (std::ptrdiff_t i = rows.begin; i < rows.end; ++i) {
            NodeRecord& n = model.parts[body].records[static_cast<std::size_t>(i)];
            n[record::p_r] = n[record::p_z] = 0.0;
        }
    });
}

void Momentum::remap() {
    model.for_strips([this](std::size_t body, int strip) {
        if (!is_rigid(body)) remap_nodes(call(body, strip), sums_of(body, strip));
    });
}

double Momentum::damping_impulse(std::size_t body) const {
    if (!(model.settings.local_damping > 0.0)) return 0.0;
    std::array<Total, 1> sum;
    for (const NodeSums& of_strip : bodies[body].sums) sum[0] += of_strip.damping_z;
    model.exchange.sum(sum, model.settings.fixed_point);
    return sum[0].value();
}

}  // namespace grit::mpm
