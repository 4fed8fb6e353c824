// SPDX-License-Identifier: BSD-3-Clause
// The impulses of all pairs of bodies at one node, (C7). The impulse of a pair is replaced, not added to,
// so that at the end it is that of (C5) for the velocities which the other pairs leave.
#pragma once

#include "contact/nodal/normal_impulses.hpp"
#include "contact/nodal/pair_law.hpp"

GRIT_KERNEL_BEGIN

template <int C> struct NodePair {
    int a, b;  // bodies
    Law law{grit_contact_options{}};
    Shares<double> shares;
    Vector<double, C> n;  // as it was given
    Approach<double, C> x;
    Response<double, C> r;
    Vector<double, C> u_t;      // tangential part of r.u
    bool silent;                // an allowed zero normal
    Resistance<double> left{};  // (1 + yield) u_n = w_n + push, of (C5) too
};

// The bodies at one node, and the pairs between them.
template <int C> struct BodiesAtNode {
    using Velocity = Vector<double, C>;

    // Corrects the velocities. False if no impulses keep the bodies apart.
    bool settle(double tolerance, int sweep_limit) {
        if (active > 1) return sweep(tolerance, sweep_limit);
        if (active == 1) alone();
        return true;
    }

    int bodies = 0, pair_count = 0, active = 0;
    double mass[most_bodies];
    bool rigid[most_bodies] = {};
    Velocity velocity[most_bodies];
    NodePair<C> pairs[most_pairs];

  private:
    void alone() {
        for (int p = 0; p < pair_count; ++p) {
            NodePair<C>& pair = pairs[p];
            if (!pair.shares.active || pair.silent) continue;
            pair.x.w = velocity[pair.a] - velocity[pair.b];
            pair.r = respond<double, C>(pair.law, pair.shares, pair.x);
            if (pair.r.touches) push(pair, pair.r.u, 1.0);
        }
    }

    // False if no normal impulses keep the bodies apart. Around a ring of bodies whose normals are nearly one impulses may be so
    // large that their roundoff is none of an answer: then normals are one that differ a little more.
    bool sweep(double tolerance, int sweep_limit) {
        for (int body = 0; body < bodies; ++body) trial[body] = velocity[body];
        for (int p = 0; p < pair_count; ++p) pairs[p].n = pairs[p].x.n;
        for (const double share : {1e-6, 1e-5, most_alike}) {
            alike = share;
            if (sweep_with(tolerance, sweep_limit)) return true;
            for (int body = 0; body < bodies; ++body) velocity[body] = trial[body];
        }
        return false;
    }
    // Then roundoff may leave what friction may.
    bool is_last() const { return alike == most_alike; }
    bool sweep_with(double tolerance, int sweep_limit) {
        const double approach = assemble();
        if (!(approach > 0.0)) return true;
        bool fits = true;
        double given = 0.0;  // by springs
        for (int s = 0; s < sweep_limit; ++s) {
            const double pressed = press(approach, tolerance);
            fits = pressed >= 0.0;
            if (!fits && (s == 0 || !is_last())) return false;
            if (!fits) break;
            if (s == 0 && has_springs) given = max(-loss().work, 0.0);
            if (max(pressed, rub()) <= tolerance * approach || !rubs) break;
        }
        if (fits && loses(given) && consistent(approach)) return true;
        // Coulomb's law at several normals may have no solution, or one that gains energy: then friction
        // is left out.
        if (rubs) {
            for (int row = 0; row < system.count(); ++row) {
                NodePair<C>& pair = pairs[pair_of[row]];
                pair.u_t = {};
                pair.r.u_t = 0.0;
                pair.r.slips = true;
            }
            if (press(approach, tolerance) < 0.0) return false;
        }
        return consistent(approach) && (is_last() || has_springs || loses(0.0));
    }
    // But for what springs have given.
    bool loses(double given) const {
        const Loss lost = loss();
        return lost.work + given >= -1e-15 * lost.size;
    }

    // Does every pair leave no more approach than it may, where the sweeps ended?
    bool consistent(double approach) const { return leave_no_more_than(0.1 * approach); }
    bool leave_no_more_than(double most) const {
        for (int row = 0; row < system.count(); ++row)
            if (!(remaining(pairs[pair_of[row]]) <= most + 10.0 * system.allowed(row, 0.0)))
                return false;
        return true;
    }

    // Twice the work that the pairs take, sum J . (w before + w after), and the size of its terms. Without rigid bodies
    // it is twice the kinetic energy lost; rigid ones that move differently may do work of their own. Told body by body, in the
    // frame of the heaviest, as impulses around a ring may be larger than what they do together.
    struct Loss {
        double work, size;
    };
    Loss loss() const {
        Velocity gained[most_bodies] = {},
                 size[most_bodies] = {};  // momentum, the size of its terms
        for (int row = 0; row < system.count(); ++row) {
            const NodePair<C>& pair = pairs[pair_of[row]];
            for (int c = 0; c < C; ++c) {
                const double J = pair.shares.m_r * pair.r.u[c];
                gained[pair.a][c] -= J;
                gained[pair.b][c] += J;
                size[pair.a][c] += fabs(J);
                size[pair.b][c] += fabs(J);
            }
        }
        Loss sum{0.0, 0.0};
        const Velocity frame = velocity[heaviest];
        for (int t = 0; t < touching; ++t) {
            const int body = toucher[t];
            for (int c = 0; c < C; ++c) {
                const double before = trial[body][c], after = velocity[body][c];
                // By velocities, where these have more digits than impulses that cancel.
                const double own = mass[body] * (fabs(before) + fabs(after));
                if (!rigid[body] && own < size[body][c]) {
                    gained[body][c] = mass[body] * (after - before);
                    size[body][c] = own;
                }
                sum.work -= gained[body][c] * ((before - frame[c]) + (after - frame[c]));
                sum.size += size[body][c] * (fabs(before - frame[c]) + fabs(after - frame[c])) +
                            fabs(gained[body][c]) * (fabs(before) + fabs(after));
            }
        }
        return sum;
    }

    // The pairs that can touch and what their normal impulses do; the largest approach of these.
    double assemble() {
        for (int body = 0; body < bodies; ++body) first[body] = -1;
        touching = 0;
        system.begin();
        has_springs = rubs = false;
        relative_speed = 0.0;
        double largest = 0.0;
        for (int p = 0; p < pair_count; ++p) {
            NodePair<C>& pair = pairs[p];
            if (!pair.shares.active || pair.silent) continue;
            Approach<double, C> closing = pair.x;
            closing.w = pair.x.n;  // would it touch if it approached?
            pair.r = respond<double, C>(pair.law, pair.shares, closing);
            const bool near = pair.r.touches;
            pair.r.touches = false;
            pair.r.u_n = 0.0;
            pair.u_t = {};
            if (!near) continue;
            rubs = rubs || !pair.law.frictionless;
            has_springs = has_springs || pair.law.springs;
            pair.left = pair.law.springs ? resistance(pair.law, pair.shares, pair.x, pair.r.f_p)
                                         : Resistance<double>{(1.0 - pair.r.f_p) / pair.r.f_p, 0.0};
            if (pair.left.yield > 0.0) pair.left.yield = max(pair.left.yield, least_yield);
            pair_of[system.count()] = p;
            pair.x.n = normal_of(system.count());
            pair.x.w = velocity[pair.a] - velocity[pair.b];
            relative_speed = max(relative_speed, sqrt(fused_dot(pair.x.w, pair.x.w)));
            const double approach = fused_dot(pair.x.w, pair.x.n);
            largest = max(largest, pair.law.springs
                                       ? (approach + pair.left.push) / (1.0 + pair.left.yield)
                                       : approach);
            double roundoff = 1e-300;  // below, numbers have fewer digits
            for (const int body : {pair.a, pair.b})
                for (int c = 0; c < C; ++c)
                    roundoff = max(roundoff, 1e-15 * fabs(velocity[body][c]));
            for (const int body : {pair.a, pair.b})
                if (first[body] < 0) {
                    first[body] = system.add_body();
                    toucher[touching++] = body;
                }
            const int of_bodies[] = {first[pair.a], first[pair.b]};
            const double shares[] = {pair.shares.a, pair.shares.b};
            system.add(of_bodies, shares, pair.x.n, pair.shares.m_r, pair.left.yield, roundoff);
        }
        look_for_rigid_ones();
        return largest;
    }

    // Do two of those that can touch move differently? What is free, in all, and the heaviest.
    void look_for_rigid_ones() {
        may_squeeze = false;
        free_mass = 0.0;
        heaviest = touching > 0 ? toucher[0] : 0;
        for (int t = 0; t < touching; ++t) {
            const int body = toucher[t];
            if (!rigid[body]) {
                free_mass += mass[body];
                if (!rigid[heaviest] && mass[body] > mass[heaviest]) heaviest = body;
            } else if (!rigid[heaviest]) {
                heaviest = body;
            } else {
                for (int c = 0; c < C; ++c)
                    may_squeeze = may_squeeze || velocity[body][c] != velocity[heaviest][c];
            }
        }
    }

    // Of a row, or that of one before that is nearly the same: both would need impulses beyond all measure.
    Velocity normal_of(int row) const {
        const Velocity& own = pairs[pair_of[row]].n;
        for (int before = 0; before < row; ++before) {
            const Velocity& n = pairs[pair_of[before]].x.n;
            const double sign = fused_dot(n, own) < 0.0 ? -1.0 : 1.0;
            const Velocity off = fused_sum(-sign, n, own);
            if (fused_dot(off, off) < alike * alike) return fused_sum(sign, n, Velocity{});
        }
        return own;
    }

    // Of a pair's approach, what is more than its impulse may leave.
    double remaining(const NodePair<C>& pair) const {
        const double w_n = fused_dot(velocity[pair.a] - velocity[pair.b], pair.x.n);
        const double left = pair.left.yield * pair.r.u_n, push = pair.left.push;
        const double more = (w_n + push) - left;
        return fabs(more) <= 1e-15 * (push + left) ? 0.0 : more;
    }

    // All normal impulses for the present friction, and both applied. The largest change; -1: none fits, or roundoff leaves too much.
    double press(double approach, double tolerance) {
        const double allowed = max(1e-6 * tolerance, 1e-13) * approach;
        for (int body = 0; body < bodies; ++body) velocity[body] = trial[body];
        double b[most_pairs] = {}, before[most_pairs] = {};
        for (int row = 0; row < system.count(); ++row)
            push(pairs[pair_of[row]], pairs[pair_of[row]].u_t, 1.0);
        for (int row = 0; row < system.count(); ++row) {
            NodePair<C>& pair = pairs[pair_of[row]];
            before[row] = pair.r.u_n;
            pair.r.u_n = 0.0;
            b[row] = remaining(pair);
        }
        Velocity rubbed[most_bodies];
        for (int body = 0; body < bodies; ++body) rubbed[body] = velocity[body];
        if (!system.solve(b, allowed, !may_squeeze)) return -1.0;
        apply();
        refine(allowed);
        const double speed = max(approach, relative_speed);
        if (are_squeezed(rubbed, speed)) return -1.0;
        if (!is_last() && !leave_no_more_than(alike * speed)) return -1.0;
        double change = 0.0;
        for (int row = 0; row < system.count(); ++row) {
            NodePair<C>& pair = pairs[pair_of[row]];
            const double u_n = pair.r.u_n;
            change = max(change, fabs(u_n - before[row]));
            pair.r.w_n = (1.0 + pair.left.yield) * u_n - pair.left.push;  // what the others leave
            pair.r.touches = u_n > 0.0;
            for (int c = 0; c < C; ++c) pair.r.u[c] = fma(u_n, pair.x.n[c], pair.u_t[c]);
        }
        return change;
    }
    // By impulses, which keep momentum; but light bodies between heavy ones, whose velocities would be roundoff of these, by
    // what the system knows of them.
    void apply() {
        double load[most_bodies] = {};  // of all impulses
        for (int row = 0; row < system.count(); ++row) {
            const NodePair<C>& pair = pairs[pair_of[row]];
            load[pair.a] += pair.shares.m_r * system.u(row);
            load[pair.b] += pair.shares.m_r * system.u(row);
        }
        Velocity known[most_bodies];
        bool light[most_bodies] = {};
        const double in_all = system.change_in_all();
        for (int t = 0; t < touching; ++t) {
            const int body = toucher[t];
            if (rigid[body]) continue;
            const double root = sqrt(mass[body]);
            light[body] = load[body] > root * in_all;
            for (int c = 0; c < C; ++c)
                known[body][c] = velocity[body][c] + system.change_of(first[body] + c) / root;
        }
        for (int row = 0; row < system.count(); ++row) press_more(row, system.u(row));
        for (int body = 0; body < bodies; ++body)
            if (light[body]) velocity[body] = known[body];
    }
    void press_more(int row, double u_n) {
        NodePair<C>& pair = pairs[pair_of[row]];
        pair.r.u_n += u_n;
        push(pair, pair.x.n, u_n);
    }
    // Takes the roundoff of approaches back, as long as there is less of it.
    void refine(double allowed) {
        constexpr int most_rounds = 8;
        double b[most_pairs] = {}, more[most_pairs] = {};
        double largest = largest_remaining(b);
        for (int round = 0; round < most_rounds && !is_enough(b, allowed); ++round) {
            Velocity before[most_bodies];
            double u_n[most_pairs];
            for (int body = 0; body < bodies; ++body) before[body] = velocity[body];
            for (int row = 0; row < system.count(); ++row) u_n[row] = pairs[pair_of[row]].r.u_n;
            system.add_for(b, more);
            for (int row = 0; row < system.count(); ++row)
                if (pairs[pair_of[row]].r.u_n + more[row] < 0.0) return;
            for (int row = 0; row < system.count(); ++row) press_more(row, more[row]);
            const double last = largest;
            largest = largest_remaining(b);
            if (largest < last) continue;
            for (int body = 0; body < bodies; ++body) velocity[body] = before[body];
            for (int row = 0; row < system.count(); ++row) pairs[pair_of[row]].r.u_n = u_n[row];
            return;
        }
    }
    // Of pairs that press; b of all.
    double largest_remaining(double* b) const {
        double largest = 0.0;
        for (int row = 0; row < system.count(); ++row) {
            b[row] = remaining(pairs[pair_of[row]]);
            if (system.presses(row)) largest = max(largest, fabs(b[row]));
        }
        return largest;
    }
    bool is_enough(const double* b, double allowed) const {
        for (int row = 0; row < system.count(); ++row)
            if (system.presses(row) && fabs(b[row]) > system.allowed(row, allowed)) return false;
        return true;
    }
    // What rigid bodies press out much faster than they move has no way out; nor has what is pressed with more than all that is
    // free could take. Where nothing holds them such impulses are roundoff, or around a ring.
    bool are_squeezed(const Velocity* before, double speed) const {
        constexpr double most_times_faster = 1e4, most_times_pressed = 1e10;
        if (is_last() && !may_squeeze) return false;
        for (int row = 0; row < system.count(); ++row)
            if (!(pairs[pair_of[row]].shares.m_r * pairs[pair_of[row]].r.u_n <=
                  most_times_pressed * free_mass * speed))
                return true;
        if (!may_squeeze) return false;
        for (int t = 0; t < touching; ++t)
            for (int c = 0; c < C; ++c)
                if (!(fabs(velocity[toucher[t]][c] - before[toucher[t]][c]) <=
                      most_times_faster * speed))
                    return true;
        return false;
    }

    // Friction of one pair after the other; the largest change.
    double rub() {
        double change = 0.0;
        for (int row = 0; row < system.count(); ++row) {
            NodePair<C>& pair = pairs[pair_of[row]];
            push(pair, pair.u_t, -1.0);
            const Velocity w = velocity[pair.a] - velocity[pair.b];
            const Velocity w_t = fused_sum(-fused_dot(w, pair.x.n), pair.x.n, w);
            const double limit =
                pair.r.touches ? friction_limit(pair.law, pair.shares, pair.x, pair.r) : 0.0;
            pair.r.w_t = sqrt(fused_dot(w_t, w_t));
            pair.r.slips = pair.r.touches && limit < pair.r.w_t;
            pair.r.u_t = min(pair.r.w_t, limit);
            const double part = pair.r.w_t > limit ? limit / pair.r.w_t
                                : pair.r.touches   ? 1.0
                                                   : 0.0;
            for (int c = 0; c < C; ++c) {
                change = max(change, fabs(part * w_t[c] - pair.u_t[c]));
                pair.u_t[c] = part * w_t[c];
                pair.r.u[c] = fma(pair.r.u_n, pair.x.n[c], pair.u_t[c]);
            }
            push(pair, pair.u_t, 1.0);
        }
        return change;
    }

    // Take times u from the relative velocity of a pair.
    void push(const NodePair<C>& pair, const Velocity& u, double times) {
        for (int c = 0; c < C; ++c) {
            velocity[pair.a][c] -= pair.shares.a * (times * u[c]);
            velocity[pair.b][c] += pair.shares.b * (times * u[c]);
        }
    }

    static constexpr double most_alike = 1e-4;
    // Bodies in a ring may press each other by a spring that nothing else gives way to.
    static constexpr double least_yield = 1e-20;

    Velocity trial[most_bodies];
    NormalSystem<C> system;
    bool has_springs = false, rubs = false, may_squeeze = false;
    double relative_speed;  // the largest of pairs that can touch
    double free_mass;
    // Normals that differ by less are one, and roundoff leaves no larger share of the speed.
    double alike;
    int heaviest;  // of bodies that can touch; a rigid one is
    int touching;  // bodies that can touch, in the order in which pairs name them
    int toucher[most_bodies];
    int first[most_bodies];   // entry of a body in the system; -1: none
    int pair_of[most_pairs];  // row of the system
};

GRIT_KERNEL_END
