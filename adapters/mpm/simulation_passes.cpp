// SPDX-License-Identifier: BSD-3-Clause
// The passes of a step over particles and over nodes. Tasks are (body, strip), whatever the threads.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/for_strips.hpp"
#include "adapters/mpm/simulation.hpp"

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
            settings.local_damping};
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
    for (std::size_t p = 0; p < part.slot.size(); ++p)
        part.slot[static_cast<std::size_t>(ids[p])] = static_cast<std::ptrdiff_t>(p);
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
        exchange.sum_cells(part.cells.data(), static_cast<std::ptrdiff_t>(part.cells.size()));
}

void Simulation::scatter_strips(unsigned parts_wanted) {
    const bool means = settings.cell_mean && (parts_wanted & part::force);
    for (const int colour : {0, 1})
        for_strips(pool, parts, [&, this](Part& part, int strip) {
            if (strip % 2 != colour) return;
            const ScatterCall call{grid(),
                                   part.body.particles.view(),
                                   part.strips.begin(strip),
                                   part.strips.begin(strip + 1),
                                   part.records.data(),
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

void Simulation::scatter(unsigned parts_wanted) {
    if (settings.cell_mean && (parts_wanted & part::force)) find_mean_stresses();
    if (settings.fixed_point) return scatter_fixed(parts_wanted);
    scatter_strips(parts_wanted);
    for (Part& part : parts)
        exchange.sum_nodes(part.records.data(), static_cast<std::ptrdiff_t>(part.records.size()));
}

void Simulation::load() {
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        const Traction& traction = tractions[i];
        Part& part = parts[traction.body];
        loads[i] =
            edge_forces(grid(), part.body.particles.view(), find(traction.body, traction.particle),
                        traction.edge, traction.stress(t), settings);
        add_edge_forces(grid(), loads[i], part.records.data());
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
    for (std::size_t i = 0; i < parts.size() && absorbing_sides.any(); ++i) {
        const AbsorbingSides::Work work = absorbing_sides.work(i, node_call(parts[i], 0));
        sums.absorbed += work.taken;
        sums.external_work += work.held;
    }
    for_strips(pool, parts, [this](Part& part, int strip) {
        if (!part.body.rigid())
            close_nodes(node_call(part, strip), part.node_sums[static_cast<std::size_t>(strip)]);
    });
    for (std::size_t i = 0; i < tractions.size(); ++i)
        sums.external_work +=
            edge_work(grid(), loads[i], parts[tractions[i].body].motions.data(), dt);
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

void Simulation::measure_speed() {
    for_strips(pool, parts, [](Part& part, int strip) {
        const auto s = static_cast<std::size_t>(strip);
        const ParticleView q = part.body.particles.view();
        const std::ptrdiff_t end = part.strips.begin(strip + 1);
        double fastest = 0.0, most_v2 = 0.0;
        for (std::ptrdiff_t p = part.strips.begin(strip); p < end; ++p) {
            double modulus = 0.0;
            if (!part.body.rigid()) part.body.material->wave_moduli({q, p, p + 1}, &modulus);
            fastest = std::max(fastest, modulus * q[column::V0][p] * q.J(p) / q[column::mass][p]);
            const double v_r = q[column::v_r][p], v_z = q[column::v_z][p];
            most_v2 = std::max(most_v2, v_r * v_r + v_z * v_z);
        }
        part.speed[s] = std::sqrt(fastest);
        part.gather_sums[s].most_v2 = most_v2;
    });
}

// The first that is found; another process may have it.
void Simulation::report_lost(long count) const {
    std::string which;
    for (const Part& part : parts) {
        const Particles& q = part.body.particles;
        for (std::ptrdiff_t p = 0; p < q.size() && which.empty(); ++p) {
            const double r = q(column::r, p), z = q(column::z, p);
            const bool is_inside = r >= r_axis[0] && r <= r_axis[r_axis.nodes() - 1] &&
                                   z >= z_axis[0] && z <= z_axis[z_axis.nodes() - 1];
            if (is_inside) continue;
            which = ", among them particle " + std::to_string(q.ids()[p]) + " of body " +
                    part.body.name + " at r = " + std::to_string(r) +
                    " m, z = " + std::to_string(z) + " m";
        }
    }
    throw std::runtime_error(std::to_string(count) +
                             " particles left the grid at t = " + std::to_string(t) + " s" + which);
}

// Sums of all strips in their order, and the next step.
void Simulation::account() {
    double largest[2] = {0.0, 0.0};  // v + c, way along z
    enum { lost, external_work, damping, viscosity, pic, transfer, count };
    double step[count] = {};
    for (Part& part : parts)
        for (std::size_t s = 0; s < part.speed.size(); ++s) {
            const GatherSums& g = part.gather_sums[s];
            const NodeSums& n = part.node_sums[s];
            largest[0] = std::max(largest[0], part.speed[s] + std::sqrt(g.most_v2));
            largest[1] = std::max(largest[1], g.most_dz);
            step[lost] += g.outside;
            step[external_work] += g.body_work + n.gravity_work;
            step[damping] += n.damping_work;
            step[viscosity] += part.viscous_loss[s];
            step[pic] += g.pic_loss;
            step[transfer] += n.change - g.kept + g.pic_loss + n.mapped_away;
        }
    exchange.max(largest, 2);
    exchange.sum(step, count);
    sums.external_work += step[external_work];
    sums.damping += step[damping];
    sums.viscosity += step[viscosity];
    sums.pic += step[pic];
    sums.transfer += step[transfer];
    if (step[lost] > 0.0) report_lost(static_cast<long>(step[lost]));
    drift += largest[1];
    dt_before = dt;
    largest_speed = largest[0];
    dt = stable_step();
    if (!(dt > 0.0) || !std::isfinite(dt))
        throw std::runtime_error("no finite time step: is anything able to move?");
}

double Simulation::stable_step() const {
    const double shortest = std::min(r_axis.shortest(), z_axis.shortest());
    double inverse2 = largest_speed * largest_speed / (shortest * shortest);
    for (const PenaltyPair& pair : penalties)
        inverse2 += 1.0 / (pair.stable_step() * pair.stable_step());
    return std::min(settings.cfl / std::sqrt(inverse2), settings.largest_step);
}

}  // namespace grit::mpm
