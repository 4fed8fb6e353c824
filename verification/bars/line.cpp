// SPDX-License-Identifier: BSD-3-Clause
#include "bars/line.hpp"

#include <cmath>
#include <stdexcept>

namespace bars {
namespace {

constexpr double normal[2] = {1.0, 0.0};  // from a to b

void require(grit_status status, const grit_error& error) {
    if (status != GRIT_OK) throw std::runtime_error(error.message);
}

template <class T> ptrdiff_t count_of(const T& list) { return static_cast<ptrdiff_t>(list.size()); }

}  // namespace

Contact frictional_contact(bool gated) {
    Contact contact;
    grit_contact_options_init(&contact.options, sizeof contact.options);
    contact.options.components = 2;
    contact.options.law = GRIT_CONTACT_FRICTIONAL;
    contact.gated = gated;
    return contact;
}

Contact geo_contact(double k, bool gated) {
    Contact contact = frictional_contact(gated);
    contact.options.law = GRIT_CONTACT_GEO;
    contact.options.penalty_power = k;
    return contact;
}

Contact penalty_contact(double stiffness) {
    Contact contact;
    contact.method = Method::penalty;
    contact.stiffness = stiffness;
    return contact;
}

Contact surface_contact(double friction, double stiffness) {
    Contact contact;
    contact.method = Method::surface;
    contact.friction = friction;
    contact.stiffness = stiffness;
    return contact;
}

Line::Line(double from, double cell, int nodes)
    : x0(from), h(cell), count(static_cast<std::size_t>(nodes)), surface(count), centre(count),
      distance(count), gap(count) {
    for (std::size_t i = 0; i < count; ++i)
        position.push_back({x0 + static_cast<double>(i) * h, 0.0});
}

// Linear shape functions averaged over the particle's ends: S = (N(l) + N(r))/2, G = (N(r) - N(l))/L.
Line::Weights Line::weights(double x, double length) const {
    Weights w{};
    const double ends[2] = {(x - 0.5 * length - x0) / h, (x + 0.5 * length - x0) / h};
    w.first = static_cast<std::ptrdiff_t>(std::floor(ends[0]));
    if (w.first < 0 || static_cast<std::size_t>(w.first) + 4 > count)
        throw std::runtime_error("a particle has left the grid");
    for (std::size_t i = 0; i < 4; ++i) {
        const double node = static_cast<double>(w.first) + static_cast<double>(i);
        const double left = std::fmax(0.0, 1.0 - std::fabs(ends[0] - node));
        const double right = std::fmax(0.0, 1.0 - std::fabs(ends[1] - node));
        w.N[i] = 0.5 * (left + right);
        w.dN[i] = length > 0.0 ? (right - left) / length : 0.0;
    }
    return w;
}

void Line::gather(const Bar& bar, Nodes& nodes) const {
    for (auto* list :
         {&nodes.mass, &nodes.momentum, &nodes.slip_momentum, &nodes.force, &nodes.slip_force})
        list->assign(count, 0.0);
    for (const Particle& p : bar.particles) {
        const Weights w = weights(p.x, p.length);
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t i = static_cast<std::size_t>(w.first) + k;
            nodes.mass[i] += w.N[k] * p.mass;
            nodes.momentum[i] += w.N[k] * p.mass * p.v;
            nodes.slip_momentum[i] += w.N[k] * p.mass * p.slip_v;
            nodes.force[i] += w.N[k] * p.mass * bar.weight - w.dN[k] * p.length * p.sigma;
            nodes.slip_force[i] += w.N[k] * p.mass * bar.slip_weight - w.dN[k] * p.length * p.tau;
        }
    }
}

void Line::advance(const Bar& bar, Nodes& nodes, double dt) const {
    nodes.v.assign(count, {0.0, 0.0});
    nodes.old_v = nodes.v;
    for (std::size_t i = 0; i < count; ++i) {
        const double m = nodes.mass[i];
        if (m <= 0.0) continue;
        nodes.old_v[i] = {nodes.momentum[i] / m, nodes.slip_momentum[i] / m};
        nodes.v[i] = nodes.old_v[i];
        if (bar.rigid) continue;
        nodes.v[i][0] += dt * nodes.force[i] / m;
        nodes.v[i][1] += dt * nodes.slip_force[i] / m;
    }
}

// Surfaces and distances as the particles' domains say.
void Line::measure(const Bar& a, const Bar& b) {
    grit_error error;
    grit_contact_surfaces s{};
    s.struct_size = sizeof s;
    s.components = 2;
    s.nodes = static_cast<ptrdiff_t>(count);
    s.position = grit_view_of(position[0].data(), 2, 1);
    s.normal = grit_view_of(normal, 0, 1);
    s.surface = grit_mutable_view_of(surface[0].data(), 2, 1);
    s.centre = grit_mutable_view_of(centre[0].data(), 2, 1);
    require(grit_contact_surfaces_reset(&s, &error), error);
    for (const Bar* bar : {&a, &b})
        for (const Particle& p : bar->particles) {
            const Weights w = weights(p.x, p.length);
            ptrdiff_t nodes[4];
            for (std::size_t k = 0; k < 4; ++k)
                nodes[k] = w.N[k] > 0.0 ? w.first + static_cast<ptrdiff_t>(k) : -1;
            const double x[2] = {p.x, 0.0}, side[2] = {0.5 * p.length, 0.0};
            grit_contact_domains d{};
            d.struct_size = sizeof d;
            d.body = bar == &a ? 0 : 1;
            d.sides = 1;
            d.nodes_each = 4;
            d.node = nodes;
            d.position = grit_view_of(x, 2, 1);
            d.side = grit_matrix_view_of(side, 2, 2, 1);
            require(grit_contact_surfaces_add(&s, 1, &d, &error), error);
        }
}

StepReport Line::correct(const Bar& a, const Bar& b, const Contact& contact, double dt) {
    measure(a, b);
    grit_error error;
    grit_contact_surfaces s{};
    s.struct_size = sizeof s;
    s.components = 2;
    s.nodes = static_cast<ptrdiff_t>(count);
    s.surface = grit_mutable_view_of(surface[0].data(), 2, 1);
    s.centre = grit_mutable_view_of(centre[0].data(), 2, 1);
    grit_contact_distances wanted{};
    wanted.struct_size = sizeof wanted;
    wanted.measure = contact.measure;
    wanted.distance = grit_mutable_view_of(distance.data(), 1, 1);
    wanted.gap = grit_mutable_view_of(gap.data(), 1, 1);
    require(grit_contact_surfaces_finish(&s, s.nodes, &wanted, &error), error);

    grit_contact_options options = contact.options;
    options.time_step = dt;
    options.rigid = a.rigid   ? GRIT_CONTACT_A_RIGID
                    : b.rigid ? GRIT_CONTACT_B_RIGID
                              : GRIT_CONTACT_NONE_RIGID;
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    q.mass_a = grit_view_of(nodes_a.mass.data(), 1, 1);
    q.mass_b = grit_view_of(nodes_b.mass.data(), 1, 1);
    q.normal = grit_view_of(normal, 0, 1);
    q.distance = grit_view_of(distance.data(), 1, 1);
    q.cell_size = grit_view_of(&h, 0, 1);
    if (contact.gated) q.gap = grit_view_of(gap.data(), 1, 1);
    q.velocity_a = grit_mutable_view_of(nodes_a.v[0].data(), 2, 1);
    q.velocity_b = grit_mutable_view_of(nodes_b.v[0].data(), 2, 1);
    q.previous_velocity_a = grit_view_of(nodes_a.old_v[0].data(), 2, 1);
    q.previous_velocity_b = grit_view_of(nodes_b.old_v[0].data(), 2, 1);
    grit_contact_sums sums{};
    require(
        grit_contact_correct(&options, static_cast<ptrdiff_t>(count), &q, nullptr, &sums, &error),
        error);
    grit_contact_totals totals{};
    totals.struct_size = sizeof totals;
    grit_contact_sums_read(&sums, &totals);
    StepReport report;
    report.force = totals.force_on_b[0];
    report.slip_force = totals.force_on_b[1];
    report.dissipation = totals.dissipation_normal + totals.dissipation_tangential;
    report.slipping = static_cast<int>(totals.slip);
    report.sticking = static_cast<int>(totals.stick);
    return report;
}

// Penalty contact of the two end faces, each one segment of unit height: forces before the update.
StepReport Line::push(const Bar& a, const Bar& b, const Contact& contact, double dt) {
    const double x_a = a.right(), x_b = b.left();
    const double end_a[4] = {x_a, 0.0, x_a, 1.0}, end_b[4] = {x_b, 1.0, x_b, 0.0};
    double force_a[4] = {}, force_b[4] = {};
    grit_penalty_options options;
    grit_penalty_options_init(&options, sizeof options);
    options.normal_stiffness = contact.stiffness;
    options.depth_max = h;
    options.time_step = dt;
    const auto line = [](const double* x, double* force) {
        grit_penalty_surface face{};
        face.struct_size = sizeof face;
        face.count = 2;
        face.position = grit_view_of(x, 2, 1);
        face.force = grit_mutable_view_of(force, 2, 1);
        return face;
    };
    const grit_penalty_surface face_a = line(end_a, force_a), face_b = line(end_b, force_b);
    std::vector<double> workspace(grit_penalty_workspace_size(2, 2) / sizeof(double) + 1);
    grit_penalty_totals totals{};
    totals.struct_size = sizeof totals;
    grit_error error;
    require(grit_penalty_forces(&options, &face_a, &face_b, workspace.data(),
                                workspace.size() * sizeof(double), &totals, &error),
            error);
    const auto add = [this](double x, double force, Nodes& nodes) {
        const Weights w = weights(x, 0.0);
        for (std::size_t k = 0; k < 4; ++k)
            nodes.force[static_cast<std::size_t>(w.first) + k] += w.N[k] * force;
    };
    add(x_a, totals.force_on_a[0], nodes_a);
    add(x_b, totals.force_on_b[0], nodes_b);
    StepReport report;
    report.force = totals.force_on_b[0];
    return report;
}

// Surface contact of the two end faces, each one facet of unit height, both ends of which move with the line.
StepReport Line::meet(const Bar& a, const Bar& b, const Contact& contact, double dt) {
    struct Face {
        double position[4], weight[8], velocity[4];
        ptrdiff_t node[8];
    };
    static constexpr ptrdiff_t facet[2] = {0, 1};
    Face faces[2];
    const auto surface_of = [&](const Bar& bar, double x, bool up, Nodes& nodes, Face& face) {
        const Weights w = weights(x, 0.0);
        for (std::size_t end = 0; end < 2; ++end) {
            face.position[2 * end] = x;
            face.position[2 * end + 1] = (end == 1) == up ? 1.0 : 0.0;
            face.velocity[2 * end] = bar.particles.front().v;
            face.velocity[2 * end + 1] = bar.particles.front().slip_v;
            for (std::size_t k = 0; k < 4; ++k) {
                face.weight[4 * end + k] = w.N[k];
                face.node[4 * end + k] = w.first + static_cast<ptrdiff_t>(k);
            }
        }
        grit_surface s{};
        s.struct_size = sizeof s;
        s.rigid = bar.rigid;
        s.nodes_each = 4;
        s.vertices = 2;
        s.facets = 1;
        s.position = grit_view_of(face.position, 2, 1);
        s.facet = facet;
        s.node = face.node;
        s.weight = face.weight;
        s.nodes = static_cast<ptrdiff_t>(count);
        s.mass = grit_view_of(nodes.mass.data(), 1, 1);
        s.velocity = grit_mutable_view_of(nodes.v[0].data(), 2, 1);
        s.previous_velocity = grit_view_of(nodes.old_v[0].data(), 2, 1);
        s.vertex_velocity = grit_view_of(face.velocity, 2, 1);
        return s;
    };
    const grit_surface face_a = surface_of(a, a.right(), true, nodes_a, faces[0]);
    const grit_surface face_b = surface_of(b, b.left(), false, nodes_b, faces[1]);
    grit_surface_options options;
    grit_surface_options_init(&options, sizeof options);
    options.friction_coefficient = contact.friction;
    options.contact_stiffness = contact.stiffness;
    options.time_step = dt;
    options.spacing = 2.0;  // one pressure on the face
    options.reach = h;
    std::vector<double> workspace(grit_surface_workspace_size(&face_a, &face_b) / sizeof(double) +
                                  1);
    grit_surface_totals totals{};
    totals.struct_size = sizeof totals;
    grit_error error;
    require(grit_surface_correct(&options, &face_a, &face_b, workspace.data(),
                                 workspace.size() * sizeof(double), nullptr, nullptr, &totals,
                                 &error),
            error);
    StepReport report;
    report.force = totals.impulse_on_b[0] / dt;
    report.slip_force = totals.impulse_on_b[1] / dt;
    report.dissipation = totals.dissipation_normal + totals.dissipation_tangential;
    return report;
}

// Returns the kinetic energy that the change of velocity has on the nodes and not on the particles.
double Line::scatter(Bar& bar, const Nodes& nodes, double dt) const {
    double lost = 0.0;
    for (std::size_t i = 0; i < count && !bar.rigid; ++i)
        for (std::size_t c = 0; c < 2; ++c) {
            const double change = nodes.v[i][c] - nodes.old_v[i][c];
            lost += 0.5 * nodes.mass[i] * change * change;
        }
    for (Particle& p : bar.particles) {
        const Weights w = weights(p.x, p.length);
        double v = 0.0, slip_v = 0.0, rate = 0.0, shear_rate = 0.0, change = 0.0, slip_change = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t i = static_cast<std::size_t>(w.first) + k;
            v += w.N[k] * nodes.v[i][0];
            slip_v += w.N[k] * nodes.v[i][1];
            rate += w.dN[k] * nodes.v[i][0];
            shear_rate += w.dN[k] * nodes.v[i][1];
            change += w.N[k] * (nodes.v[i][0] - nodes.old_v[i][0]);
            slip_change += w.N[k] * (nodes.v[i][1] - nodes.old_v[i][1]);
        }
        p.x += dt * v;
        p.slip += dt * slip_v;
        if (bar.rigid) continue;
        p.v += change;
        p.slip_v += slip_change;
        lost -= 0.5 * p.mass * (change * change + slip_change * slip_change);
        p.sigma += dt * bar.modulus * rate * p.stretch;  // of the nominal strain
        p.tau += dt * bar.shear_modulus * shear_rate * p.stretch;
        p.stretch *= 1.0 + dt * rate;
        p.length = p.stretch * p.volume;
    }
    return lost;
}

StepReport Line::step(Bar& a, Bar& b, const Contact& contact, double dt) {
    gather(a, nodes_a);
    gather(b, nodes_b);
    StepReport report;
    if (contact.method == Method::penalty) report = push(a, b, contact, dt);
    advance(a, nodes_a, dt);
    advance(b, nodes_b, dt);
    if (contact.method == Method::nodal) report = correct(a, b, contact, dt);
    if (contact.method == Method::surface) report = meet(a, b, contact, dt);
    report.transfer = scatter(a, nodes_a, dt) + scatter(b, nodes_b, dt);
    return report;
}

}  // namespace bars
