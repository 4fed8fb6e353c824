// SPDX-License-Identifier: BSD-3-Clause
// The passes of a step over particles and over nodes. Tasks are (body, strip), whatever the threads.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "adapters/mpm/step/for_strips.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

Simulation::Rows Simulation::nodes_of(int strip) const {
    const int first = strip * Strips::rows;
    const bool last = first + Strips::rows >= z_axis.cells();
    const int end = last ? z_axis.nodes() : first + Strips::rows;
    return {static_cast<std::ptrdiff_t>(first) * r_axis.nodes(),
            static_cast<std::ptrdiff_t>(end) * r_axis.nodes()};
}

NodeCall Simulation::node_call(Part& part, int strip) const {
    const Rows rows = nodes_of(strip);
    return {part.records.data(),
            part.motions.data(),
            part.internal.data(),
            fixed_nodes.data(),
            rows.begin,
            rows.end,
            part.least_mass,
            dt,
            dt_before,
            {settings.gravity_r, settings.gravity_z},
            settings.scheme == Scheme::musl,
            settings.scheme == Scheme::usf,
            settings.local_damping,
            settings.fixed_point,
            exchange.counted()};
}

void Simulation::sort() {
    for (Part& part : parts) {
        part.strips.sort(grid(), part.body.particles);
        find_places(part);
    }
    drift = 0.0;
}

void Simulation::find_places(Part& part) {
    const int* ids = part.body.particles.ids();
    std::iota(part.by_id.begin(), part.by_id.end(), 0);
    std::sort(part.by_id.begin(), part.by_id.end(),
              [ids](std::ptrdiff_t a, std::ptrdiff_t b) { return ids[a] < ids[b]; });
}

void Simulation::clear() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        const Rows rows = nodes_of(strip);
        std::fill(part.records.begin() + rows.begin, part.records.begin() + rows.end, NodeRecord{});
    });
}

// Of the cells, where their mean strains are used. The largest of a body gives the integers their scale.
void Simulation::find_mean_stresses() {
    const auto go = [this](Part& part, int strip, const CellMean& mean) {
        if (part.cells.empty()) return;
        part.most_stress[static_cast<std::size_t>(strip)] = kernels().add_mean_stresses(
            settings.axisymmetric, {grid(), part.body.particles.view(), part.strips.begin(strip),
                                    part.strips.begin(strip + 1), mean, part.separation});
    };
    for_strips(pool, parts, [&](Part& part, int strip) { go(part, strip, {}); });
    for (Part& part : parts) {
        std::fill(part.cells.begin(), part.cells.end(), CellIntegers{});
        double largest = *std::max_element(part.most_stress.begin(), part.most_stress.end());
        exchange.max(&largest, 1);
        part.mean.cells = part.cells.empty() ? nullptr : part.cells.data();
        part.mean.per_stress = largest > 0.0 ? 1.0 / largest : 1.0;
    }
    for (const int colour : {0, 1})  // neighbours may add to the same cell
        for_strips(pool, parts, [&](Part& part, int strip) {
            if (strip % 2 == colour) go(part, strip, part.mean);
        });
    for (Part& part : parts)
        if (!part.cells.empty())
            exchange.sum_cells(part.cells.data(), static_cast<std::ptrdiff_t>(part.cells.size()));
}

void Simulation::scatter_strips(unsigned parts_wanted, Into into) {
    const bool means = settings.cell_mean && (parts_wanted & part::force);
    for (const int colour : {0, 1})
        for_strips(pool, parts, [&, this](Part& part, int strip) {
            if (strip % 2 != colour) return;
            if (into == Into::ahead &&
                (part.ahead.empty() || !part.pressed[static_cast<std::size_t>(strip)]))
                return;
            const ScatterCall call{grid(),
                                   part.body.particles.view(),
                                   part.strips.begin(strip),
                                   part.strips.begin(strip + 1),
                                   into == Into::ahead ? part.ahead.data() : part.records.data(),
                                   parts_wanted,
                                   settings.fixed_point
                                       ? &part.fixed_points[static_cast<std::size_t>(strip)]
                                       : nullptr,
                                   means ? part.mean : CellMean{},
                                   part.separation};
            if (body_force && (parts_wanted & part::force))
                body_force(call.particles, call.begin, call.end, t);
            kernels().scatter(settings.shape, settings.axisymmetric, call);
        });
}

void Simulation::scatter(unsigned parts_wanted, Into into) {
    if (settings.cell_mean && (parts_wanted & part::force)) find_mean_stresses();
    if (settings.fixed_point) return scatter_fixed(parts_wanted, into);
    scatter_strips(parts_wanted, into);
    if (into == Into::ahead) return;  // penalty contact is for one process
    for (Part& part : parts)
        exchange.sum_nodes(part.records.data(), static_cast<std::ptrdiff_t>(part.records.size()));
}

// Of the bits of a double, 46 are left to the largest force, six to sums of many.
double Simulation::load_quantum() const {
    double largest = 0.0;
    for (const EdgeForces& f : edge_loads)
        for (const int k : {0, 1})
            largest = std::max({largest, std::abs(f.f_r[k]), std::abs(f.f_z[k])});
    exchange.max(&largest, 1);
    return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest) - 46) : 0.0;
}

void Simulation::load() {
    if (tractions.empty()) return;
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        const Traction& traction = tractions[i];
        const std::ptrdiff_t p = find(traction.body, traction.particle);
        edge_loads[i] = {};
        if (p >= 0)
            edge_loads[i] = edge_forces(grid(), parts[traction.body].body.particles.view(), p,
                                        traction.edge, traction.stress(t), settings);
    }
    const double quantum = settings.fixed_point ? load_quantum() : 0.0;
    for (Part& part : parts) std::fill(part.loads.begin(), part.loads.end(), Vector{0.0, 0.0});
    for (std::size_t i = 0; i < tractions.size(); ++i)
        if (find(tractions[i].body, tractions[i].particle) >= 0)
            add_edge_forces(grid(), edge_loads[i], quantum, parts[tractions[i].body].loads.data());
    for (Part& part : parts) {
        if (part.loads.empty()) continue;
        exchange.sum_nodes(part.loads.data(), static_cast<std::ptrdiff_t>(part.loads.size()));
        for (std::size_t i = 0; i < part.loads.size(); ++i) {
            part.records[i][record::f_r] += part.loads[i].r;
            part.records[i][record::f_z] += part.loads[i].z;
        }
    }
}

void Simulation::start_velocities() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        if (part.body.rigid()) return;
        NodeSums& node_sums = part.node_sums[static_cast<std::size_t>(strip)];
        node_sums = {};
        start_nodes(node_call(part, strip), node_sums);
    });
}

void Simulation::keep_internal_forces() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        if (!part.body.rigid()) keep_internal(node_call(part, strip));
    });
}

void Simulation::advance() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        NodeSums& node_sums = part.node_sums[static_cast<std::size_t>(strip)];
        if (settings.scheme != Scheme::usf) node_sums = {};
        const NodeCall call = node_call(part, strip);
        if (!part.body.rigid()) return advance_nodes(call, node_sums);
        const Vector v = part.body.prescribed_velocity(t + dt);
        for (std::ptrdiff_t i = call.begin; i < call.end; ++i)
            part.motions[static_cast<std::size_t>(i)] = NodeMotion{v.r, v.z, v.r, v.z};
    });
}

// Few nodes: one after the other.
void Simulation::push_absorbing() {
    if (!absorbing_sides.any()) return;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].body.rigid()) absorbing_sides.push(i, node_call(parts[i], 0));
}

void Simulation::close() {
    load_work = absorbed = held_work = Total();
    for (std::size_t i = 0; i < parts.size() && absorbing_sides.any(); ++i)
        absorbing_sides.add_work(i, node_call(parts[i], 0), absorbed, held_work);
    for_strips(pool, parts, [this](Part& part, int strip) {
        if (!part.body.rigid())
            close_nodes(node_call(part, strip), part.node_sums[static_cast<std::size_t>(strip)]);
    });
    for (std::size_t i = 0; i < tractions.size(); ++i)
        if (find(tractions[i].body, tractions[i].particle) >= 0)
            load_work.add(
                edge_work(grid(), edge_loads[i], parts[tractions[i].body].motions.data(), dt),
                settings.fixed_point);
}

void Simulation::remap() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        const Rows rows = nodes_of(strip);
        for (std::ptrdiff_t i = rows.begin; i < rows.end; ++i) {
            NodeRecord& n = part.records[static_cast<std::size_t>(i)];
            n[record::p_r] = n[record::p_z] = 0.0;
        }
    });
    scatter(part::momentum);
    for_strips(pool, parts, [this](Part& part, int strip) {
        if (!part.body.rigid())
            remap_nodes(node_call(part, strip), part.node_sums[static_cast<std::size_t>(strip)]);
    });
}

}  // namespace grit::mpm
