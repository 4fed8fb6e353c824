// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty/pass.hpp"

#include "contact/penalty/area.hpp"

namespace grit::penalty {
namespace {

double rotation_rate(const Body& body, std::ptrdiff_t j) {
    const Segment& segment = body.line.segment[j];
    const Vector2 dv = vector_of(body.surface->velocity, body.line.end_of(j)) -
                       vector_of(body.surface->velocity, j);
    return -dot(dv, segment.n) / segment.length;
}

// Of the segment that is hit; at a corner of both.
double rotation_rate(const Body& master, const Hit& hit) {
    const std::ptrdiff_t other = hit.xi == 0.0   ? master.line.before(hit.segment)
                                 : hit.xi == 1.0 ? master.line.after(hit.segment)
                                                 : -1;
    const double rate = rotation_rate(master, hit.segment);
    return other < 0 ? rate : 0.5 * (rate + rotation_rate(master, other));
}

struct Slip {
    double rate;      // along the master's travel, rigid motions of both taken out
    double fraction;  // of the step since the touch
};

Slip slip_of(const Pass& pass, const Body& slave, std::ptrdiff_t v, const Body& master,
             const Hit& hit) {
    const Vector2 v_0 = vector_of(master.surface->velocity, hit.segment);
    const Vector2 v_1 = vector_of(master.surface->velocity, master.line.end_of(hit.segment));
    const Vector2 at_point = (1.0 - hit.xi) * v_0 + hit.xi * v_1;
    const Vector2 w = vector_of(slave.surface->velocity, v) - at_point;
    Slip slip{dot(w, travel(hit.n)) - hit.gap * rotation_rate(master, hit), 1.0};
    const bool fresh = component(slave.surface->history, v, GRIT_PENALTY_NORMAL_TRACTION) == 0.0;
    const double closed_in_step = -dot(w, hit.n) * pass.time_step;
    if (fresh && closed_in_step > -hit.gap) slip.fraction = -hit.gap / closed_in_step;
    return slip;
}

void add_force(const Body& body, std::ptrdiff_t v, Vector2 F) {
    component(body.surface->force, v, 0) += F[0];
    component(body.surface->force, v, 1) += F[1];
}

void add_stiffness(const Body& body, std::ptrdiff_t v, double k) {
    if (body.surface->stiffness.base) component(body.surface->stiffness, v, 0) += k;
}

void store_history(const Body& slave, std::ptrdiff_t v, double t_n, double t_t) {
    if (!slave.surface->history.base) return;
    component(slave.surface->history, v, GRIT_PENALTY_TANGENTIAL_TRACTION) = t_t;
    component(slave.surface->history, v, GRIT_PENALTY_NORMAL_TRACTION) = t_n;
}

void store_report(const Body& slave, std::ptrdiff_t v, const Hit& hit, double area,
                  const Traction& now, double slip_rate) {
    if (!slave.surface->reports) return;
    grit_penalty_report report{};
    report.segment = -1;
    if (hit.gap < 0.0)
        report = {now.slips ? GRIT_PENALTY_SLIP : GRIT_PENALTY_STICK,
                  0,
                  hit.segment,
                  hit.xi,
                  hit.gap,
                  {hit.n[0], hit.n[1]},
                  area,
                  now.t_n,
                  now.t_t,
                  slip_rate};
    slave.surface->reports[v] = report;
}

double moment(Vector2 x, Vector2 F) { return x[0] * F[1] - x[1] * F[0]; }

// (S4): F on the slave's vertex, -F on the ends of the master's segment.
void spread(const Pass& pass, const Body& slave, std::ptrdiff_t v, const Body& master,
            const Hit& hit, Vector2 F, double k) {
    if (pass.validate_only) return;
    const std::ptrdiff_t end = master.line.end_of(hit.segment);
    const Vector2 on_end = -hit.xi * F;
    add_force(slave, v, F);
    add_force(master, end, on_end);
    add_force(master, hit.segment, Vector2{-F[0], -F[1]} - on_end);
    add_stiffness(slave, v, k);
    add_stiffness(master, end, hit.xi * k);
    add_stiffness(master, hit.segment, (1.0 - hit.xi) * k);
}

}  // namespace

PassSums run_pass(const Pass& pass, const Body& slave, const Body& master) {
    PassSums sums;
    const bool friction = pass.law.mu > 0.0;
    const double eps = std::max(pass.law.eps_n, friction ? pass.law.eps_t : 0.0);
    for (std::ptrdiff_t v = 0; v < slave.line.vertices; ++v) {
        const Hit& hit = slave.line.hit[v];
        Traction now{};
        Slip slip{0.0, 1.0};
        double area = 0.0;
        if (hit.gap < 0.0) {
            area = contact_area(slave.line, v, master.line, pass.axisymmetric);
            double t_t_old = 0.0;
            if (friction) {
                slip = slip_of(pass, slave, v, master, hit);
                t_t_old = component(slave.surface->history, v, GRIT_PENALTY_TANGENTIAL_TRACTION);
            }
            now = traction(pass.law, hit.gap, t_t_old, slip.rate * slip.fraction * pass.time_step);
            const Vector2 F = area * (now.t_n * hit.n - now.t_t * travel(hit.n));  // (S2), (S3)
            spread(pass, slave, v, master, hit, F, eps * area);

            const Vector2 x = slave.line.x[v];
            sums.force = sums.force + F;
            sums.moment_on_slave += moment(x, F);
            sums.moment_on_master -= moment(x - hit.gap * hit.n, F);
            sums.area += area;
            sums.normal_force += now.t_n * area;
            sums.energy_normal += now.energy_n * area;
            sums.energy_tangential += now.energy_t * area;
            sums.dissipation += now.dissipation * area;
            sums.depth = std::max(sums.depth, -hit.gap);
            sums.contacts += 1;
            sums.slips += now.slips;
        }
        if (!pass.validate_only) store_history(slave, v, now.t_n, now.t_t);
        store_report(slave, v, hit, area, now, slip.rate);
    }
    return sums;
}

}  // namespace grit::penalty
