// SPDX-License-Identifier: BSD-3-Clause
// The passes of a step over particles and over nodes. Tasks are (body, strip), whatever the threads.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/kernel/material_failure.hpp"
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
            fixed_nodes.data(),
            rows.begin,
            rows.end,
            part.least_mass,
            dt,
            dt_before,
            {settings.gravity_r, settings.gravity_z},
            settings.scheme == Scheme::musl,
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

namespace {

// work(part, strip) for all bodies and strips.
template <class Parts, class Work>
void for_strips(ThreadPool& pool, Parts& parts, const Work& work) {
    if (parts.empty()) return;
    const int strips = parts[0].strips.count();
    pool.run(strips * static_cast<int>(parts.size()),
             [&](int i) { work(parts[static_cast<std::size_t>(i / strips)], i % strips); });
}

}  // namespace

void Simulation::clear() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        const Rows rows = nodes_of(strip);
        std::fill(part.records.begin() + rows.begin, part.records.begin() + rows.end, NodeRecord{});
    });
}

void Simulation::scatter_strips(unsigned parts_wanted) {
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
                                       : nullptr};
            if (body_force && (parts_wanted & part::force))
                body_force(call.particles, call.begin, call.end, t);
            kernels().scatter(settings.shape, settings.axisymmetric, call);
        });
}

void Simulation::scatter(unsigned parts_wanted) {
    if (settings.fixed_point) return scatter_fixed(parts_wanted);
    scatter_strips(parts_wanted);
    for (Part& part : parts)
        exchange.sum_nodes(part.records.data(), static_cast<std::ptrdiff_t>(part.records.size()));
}

void Simulation::load() {
    for (std::size_t i = 0; i < tractions.size(); ++i) {
        const Traction& traction = tractions[i];
        Part& part = parts[traction.body];
        loads[i] = edge_forces(part.body.particles.view(), find(traction.body, traction.particle),
                               traction.edge, traction.stress(t), settings.axisymmetric);
        add_edge_forces(grid(), loads[i], part.records.data());
    }
}

void Simulation::advance() {
    for_strips(pool, parts, [this](Part& part, int strip) {
        NodeSums& node_sums = part.node_sums[static_cast<std::size_t>(strip)];
        node_sums = {};
        const NodeCall call = node_call(part, strip);
        if (!part.body.rigid()) return advance_nodes(call, node_sums);
        const Vector v = part.body.prescribed_velocity(t + dt);
        for (std::ptrdiff_t i = call.begin; i < call.end; ++i)
            part.motions[static_cast<std::size_t>(i)] = NodeMotion{v.r, v.z, v.r, v.z};
    });
}

void Simulation::correct_contacts() {
    const auto side = [this](std::size_t i) {
        Part& part = parts[i];
        return ContactBody{part.records.data(), part.motions.data(), part.body.particles.view(),
                           part.body.particles.size(), part.body.rigid()};
    };
    for (ContactPair& pair : contacts) {
        const ContactLaw& law = pair.law();
        pair.correct(grid(), side(law.a), side(law.b), dt, exchange);
        const grit_contact_totals& totals = pair.totals();
        sums.contact += totals.dissipation_normal + totals.dissipation_tangential;
        for (const std::size_t i : {law.a, law.b}) {
            if (!parts[i].body.rigid()) continue;
            // What moves a rigid body works against the force that the body feels.
            const double* J = i == law.a ? totals.impulse_on_a : totals.impulse_on_b;
            const Vector v = parts[i].body.prescribed_velocity(t + dt);
            sums.rigid_work -= J[0] * v.r + J[1] * v.z;
        }
    }
}

void Simulation::close() {
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

void Simulation::gather(unsigned tasks, double by) {
    if (tasks & (task::velocity | task::position))
        for (Part& part : parts)
            if (!(tasks == (task::position | task::deform_by_other)))
                std::fill(part.gather_sums.begin(), part.gather_sums.end(), GatherSums{});
    for_strips(pool, parts,
               [&, this](Part& part, int strip) { gather_strip(part, strip, tasks, by); });
}

void Simulation::update(const Part& part, const Range& range, const Increments& increments) const {
    try {
        part.body.material->update(range, increments);
    } catch (const MaterialFailure& failure) {
        throw failure.of(static_cast<std::size_t>(&part - parts.data()), part.body.name,
                         part.body.particles.ids()[failure.place()], t);
    }
}

void Simulation::gather_strip(Part& part, int strip, unsigned tasks, double by) {
    const auto s = static_cast<std::size_t>(strip);
    GatherSums& strip_sums = part.gather_sums[s];
    Increments& increments = part.increments[s];
    Material* material = part.body.material.get();
    const ParticleView q = part.body.particles.view();
    const std::ptrdiff_t end = part.strips.begin(strip + 1);
    const bool deforms =
        (tasks & (task::deformation | task::deform_by_other)) && !part.body.rigid();
    if (part.body.rigid()) tasks &= task::position;
    if (tasks == 0) return;
    double fastest = 0.0;
    for (std::ptrdiff_t begin = part.strips.begin(strip); begin < end;) {
        const std::ptrdiff_t stop = std::min<std::ptrdiff_t>(begin + Increments::capacity, end);
        const int reflected = strip_sums.reflected;
        const GatherCall call{
            grid(), q, begin, stop, part.motions.data(), by, settings.pic_rate * by, tasks};
        kernels().gather(settings.shape, settings.axisymmetric, call, increments, strip_sums);
        const Range range{q, begin, stop};
        if (deforms) {
            update(part, range, increments);
            double moduli[Increments::capacity];
            material->wave_moduli(range, moduli);
            for (std::ptrdiff_t p = begin; p < stop; ++p) {
                const double per_density = q[column::V0][p] * q.J(p) / q[column::mass][p];
                fastest = std::max(fastest, moduli[p - begin] * per_density);
            }
        }
        if (strip_sums.reflected > reflected)
            for (std::ptrdiff_t p = begin; p < stop; ++p)
                if (q[column::r][p] < 0.0) reflect(*material, q, p);
        begin = stop;
    }
    if (deforms) part.speed[s] = std::sqrt(fastest);
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

// Sums of all strips in their order, and the next step.
void Simulation::account() {
    double largest[2] = {0.0, 0.0};  // v + c, way along z
    enum { lost, external_work, damping, pic, transfer, count };
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
            step[pic] += g.pic_loss;
            step[transfer] += n.change - g.kept + g.pic_loss + n.mapped_away;
        }
    exchange.max(largest, 2);
    exchange.sum(step, count);
    sums.external_work += step[external_work];
    sums.damping += step[damping];
    sums.pic += step[pic];
    sums.transfer += step[transfer];
    if (step[lost] > 0.0)
        throw std::runtime_error(std::to_string(static_cast<long>(step[lost])) +
                                 " particles left the grid at t = " + std::to_string(t) + " s");
    drift += largest[1];
    dt_before = dt;
    const double shortest = std::min(r_axis.shortest(), z_axis.shortest());
    dt = std::min(settings.cfl * shortest / largest[0], settings.largest_step);
    if (!(dt > 0.0)) throw std::runtime_error("no positive time step: is anything able to move?");
}

}  // namespace grit::mpm
