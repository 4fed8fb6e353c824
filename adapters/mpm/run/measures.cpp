// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/run/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace c = column;
double level_of(Simulation& simulation, std::size_t body, DepthOf what) {
    const Particles& particles = simulation.body(body).particles;
    const ParticleView q = simulation.body(body).particles.view();
    const bool fixed_point = simulation.current_settings().fixed_point;
    double highest = -unlimited;  // of what is below zero, that is the lowest
    std::array<Total, 2> sums;    // mass, moment
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double reach =
            std::abs(q[c::F_zr][p]) * q[c::l_r][p] + std::abs(q[c::F_zz][p]) * q[c::l_z][p];
        highest = std::max(highest, reach - q[c::z][p]);
        sums[0].add(q[c::mass][p], fixed_point);
        sums[1].add(q[c::mass][p] * q[c::z][p], fixed_point);
    }
    simulation.shared().max(&highest, 1);
    simulation.shared().sum(sums, fixed_point);
    return what == DepthOf::lowest_point ? -highest : sums[1].value() / sums[0].value();
}

Vector2 mean_velocity(Simulation& simulation, std::size_t body) {
    const Particles& particles = simulation.body(body).particles;
    const ParticleView q = simulation.body(body).particles.view();
    const bool fixed_point = simulation.current_settings().fixed_point;
    std::array<Total, 3> sums;  // mass, momentum
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        sums[0].add(q[c::mass][p], fixed_point);
        sums[1].add(q[c::mass][p] * q[c::v_r][p], fixed_point);
        sums[2].add(q[c::mass][p] * q[c::v_z][p], fixed_point);
    }
    simulation.shared().sum(sums, fixed_point);
    return {sums[1].value() / sums[0].value(), sums[2].value() / sums[0].value()};
}

double stored_energy(Simulation& simulation, std::size_t body) {
    Body& of = simulation.body(body);
    const bool fixed_point = simulation.current_settings().fixed_point;
    std::array<Total, 1> sum;
    for (std::ptrdiff_t p = 0; p < of.particles.size() && !of.rigid(); ++p)
        sum[0].add(of.material->energy(of.particles.view(), p), fixed_point);
    simulation.shared().sum(sum, fixed_point);
    return sum[0].value();
}

double base_reaction(const Simulation& simulation) {
    const Settings& settings = simulation.current_settings();
    const std::uint8_t* mine = simulation.shared().counted();
    std::array<Total, 1> sum;
    for (std::size_t body = 0; body < simulation.bodies(); ++body) {
        if (simulation.rigid(body)) continue;
        const std::vector<NodeRecord>& nodes = simulation.records(body);
        const auto count = static_cast<std::size_t>(simulation.axis_r().nodes());
        for (std::size_t i = 0; i < count; ++i)
            if ((simulation.constraints()[i] & fixed::z) && (!mine || mine[i]))
                sum[0].add(-(nodes[i][record::f_z] + settings.gravity_z * nodes[i][record::m] +
                             simulation.pore_water().force_z(body, i)),
                           settings.fixed_point);
        simulation.absorbing().each_force(body, [&](std::size_t node, const Vector2& force) {
            if (node < count && (!mine || mine[node])) sum[0].add(force[1], settings.fixed_point);
        });
    }
    simulation.shared().sum(sum, settings.fixed_point);
    return sum[0].value();
}

double unbalanced_share(const Simulation& simulation, double dt) {
    const Settings& settings = simulation.current_settings();
    double share = 0.0;
    for (std::size_t body = 0; body < simulation.bodies(); ++body) {
        if (simulation.rigid(body)) continue;
        double largest[] = {0.0, 0.0};  // resultant, force
        const std::vector<NodeRecord>& nodes = simulation.records(body);
        const std::vector<NodeMotion>& motions = simulation.motions(body);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const NodeRecord& n = nodes[i];
            const NodeMotion& v = motions[i];
            if (!(n[record::m] > simulation.least_mass(body))) continue;
            const double a_r = (v[motion::v_r] - v[motion::other_r]) / dt;
            const double a_z = (v[motion::v_z] - v[motion::other_z]) / dt;
            largest[0] = std::max(largest[0], n[record::m] * std::hypot(a_r, a_z));
            largest[1] = std::max({largest[1], std::hypot(n[record::f_r], n[record::f_z]),
                                   n[record::m] * std::abs(settings.gravity_z)});
        }
        simulation.shared().max(largest, 2);
        if (largest[1] > 0.0) share = std::max(share, largest[0] / largest[1]);
    }
    return share;
}

ContactForces contact_forces(const Simulation& simulation, std::size_t body) {
    ContactForces out;
    out.largest_gap = NAN;
    const auto add = [&out](double sign, const auto& faces) {
        out.tip = out.tip + sign * faces.along_z;
        out.shaft = out.shaft + sign * faces.along_r;
    };
    for (std::size_t i = 0; i < simulation.contact_count(); ++i) {
        const ContactPair& pair = simulation.contact(i);
        if (pair.law().a != body && pair.law().b != body) continue;
        const ContactPair::Measured& faces = pair.faces();
        add(pair.law().b == body ? 1.0 : -1.0, faces);
        add(pair.law().b == body ? 1.0 : -1.0, simulation.pore_faces(i));
        out.largest_gap = std::fmax(out.largest_gap, faces.largest_gap);
    }
    for (std::size_t i = 0; i < simulation.penalty_contact_count(); ++i) {
        const PenaltyPair& pair = simulation.penalty_contact(i);
        if (pair.law().a != body && pair.law().b != body) continue;
        add(1.0, pair.faces(pair.law().b == body ? 1 : 0));
    }
    for (std::size_t i = 0; i < simulation.surface_contact_count(); ++i) {
        const SurfacePair& pair = simulation.surface_contact(i);
        if (pair.law().a != body && pair.law().b != body) continue;
        add(pair.law().b == body ? 1.0 : -1.0, pair.faces());
    }
    return out;
}

double water_mass(Simulation& simulation) {
    bool any = false;
    std::array<Total, 1> sum;
    const bool fixed_point = simulation.current_settings().fixed_point;
    for (std::size_t i = 0; i < simulation.bodies(); ++i) {
        Body& body = simulation.body(i);
        if (!body.water || !body.water->flows) continue;
        any = true;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
            sum[0].add(body.particles(body.water->content_column(), p), fixed_point);
    }
    if (!any) return NAN;
    simulation.shared().sum(sum, fixed_point);
    return sum[0].value();
}

Energy times(const Energy& e, double factor) {
    return {factor * e.kinetic,    factor * e.stored,        factor * e.kinetic_0,
            factor * e.stored_0,   factor * e.external_work, factor * e.traction_work,
            factor * e.rigid_work, factor * e.contact,       factor * e.damping,
            factor * e.viscosity,  factor * e.absorbed,      factor * e.transfer,
            factor * e.pic,        factor * e.pore_water,    factor * e.half,
            factor * e.drag,       factor * e.implicit,      factor * e.carried};
}

double turned_over(const Energy& e, double least) {
    return std::max({least, e.kinetic, e.kinetic_0, std::abs(e.stored - e.stored_0),
                     std::abs(e.external_work), std::abs(e.rigid_work), std::abs(e.contact),
                     std::abs(e.damping), std::abs(e.viscosity), std::abs(e.absorbed),
                     std::abs(e.transfer), std::abs(e.pore_water), std::abs(e.drag),
                     std::abs(e.implicit), std::abs(e.carried)});
}

// Positive conditions, so that NaN fails them.
std::string imbalance(const Energy& e, double least, double limit) {
    const std::string end = ", the limit is " + text(100.0 * limit) + " %";
    const double turned = turned_over(e, least), residual = e.residual();
    if (!(std::abs(residual) <= limit * turned))
        return "its residual is " + text(100.0 * residual / turned) + " % of the " + text(turned) +
               " J turned over" + end;
    const double supplied = std::max(least, std::abs(e.external_work) + std::abs(e.rigid_work) +
                                                e.kinetic_0 + std::abs(e.stored_0));
    const struct {
        const char* name;
        double loss;
    } losses[] = {{"contact loss", e.contact},      {"damping loss", e.damping},
                  {"viscosity loss", e.viscosity},  {"energy absorbed by sides", e.absorbed},
                  {"loss to the PIC share", e.pic}, {"loss to drag of pore water", e.drag}};
    for (const auto& term : losses)
        if (!(term.loss >= -limit * supplied))
            return std::string("its ") + term.name + " is " + text(term.loss) + " J, a gain of " +
                   text(-100.0 * term.loss / supplied) + " % of the " + text(supplied) +
                   " J that were there or came in" + end;
    return {};
}

}  // namespace grit::mpm
