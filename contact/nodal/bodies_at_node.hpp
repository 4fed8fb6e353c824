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
    Approach<double, C> x;
    Response<double, C> r;
    Vector<double, C> u_t;        // tangential part of r.u
    bool silent;                  // an allowed zero normal
    Resistance<double> spring{};  // with contact_stiffness only
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

    // False if no normal impulses keep the bodies apart.
    bool sweep(double tolerance, int sweep_limit) {
        for (int body = 0; body < bodies; ++body) trial[body] = velocity[body];
        const double approach = assemble();
        const double allowed = max(1e-6 * tolerance, 1e-13) * approach;  // what is less is roundoff
        if (!(approach > 0.0)) return true;
        double given = 0.0;  // by springs
        for (int s = 0; s < sweep_limit; ++s) {
            const double pressed = press(allowed);
            if (pressed < 0.0) return false;
            if (s == 0 && has_springs) given = max(-loss().work, 0.0);
            if (max(pressed, rub()) <= tolerance * approach) break;
        }
        // Coulomb's law at several normals may have no solution, or one that gains energy: then friction
        // is left out.
        const Loss lost = loss();
        if (lost.work + given >= -1e-15 * lost.size && consistent(approach)) return true;
        for (int row = 0; row < system.count; ++row) {
            NodePair<C>& pair = pairs[pair_of[row]];
            pair.u_t = {};
            pair.r.u_t = 0.0;
            pair.r.slips = true;
        }
        return press(allowed) >= 0.0;
    }

    // Does every pair leave no more approach than it may, where the sweeps ended?
    bool consistent(double approach) const {
        for (int row = 0; row < system.count; ++row) {
            const NodePair<C>& pair = pairs[pair_of[row]];
            const Velocity w = velocity[pair.a] - velocity[pair.b];
            const double left =
                pair.law.springs ? pair.r.w_n - pair.r.u_n : (1.0 - pair.r.f_p) * pair.r.w_n;
            if (fused_dot(w, pair.x.n) > left + 0.1 * approach) return false;
        }
        return true;
    }

    // Twice the work that the pairs take, sum J . (w before + w after), and the size of its terms. Without rigid bodies
    // it is twice the kinetic energy lost; rigid ones that move differently may do work of their own.
    struct Loss {
        double work, size;
    };
    Loss loss() const {
        Loss sum{0.0, 0.0};
        for (int row = 0; row < system.count; ++row) {
            const NodePair<C>& pair = pairs[pair_of[row]];
            for (int c = 0; c < C; ++c) {
                const double J = pair.shares.m_r * pair.r.u[c];
                const double w = (trial[pair.a][c] - trial[pair.b][c]) +
                                 (velocity[pair.a][c] - velocity[pair.b][c]);
                sum.work += J * w;
                sum.size += fabs(J) * (fabs(trial[pair.a][c]) + fabs(trial[pair.b][c]) +
                                       fabs(velocity[pair.a][c]) + fabs(velocity[pair.b][c]));
            }
        }
        return sum;
    }

    // The pairs that can touch and the matrix of their normal impulses; the largest approach.
    double assemble() {
        system.count = 0;
        has_springs = false;
        double largest = 0.0;
        for (int p = 0; p < pair_count; ++p) {
            NodePair<C>& pair = pairs[p];
            if (!pair.shares.active || pair.silent) continue;
            pair.x.w = velocity[pair.a] - velocity[pair.b];
            const double approach = fused_dot(pair.x.w, pair.x.n);
            largest = max(largest, approach);
            Approach<double, C> closing = pair.x;
            closing.w = pair.x.n;  // would it touch if it approached?
            pair.r = respond<double, C>(pair.law, pair.shares, closing);
            const bool near = pair.r.touches;
            pair.r.touches = false;
            if (!near) continue;
            const int row = system.count++;
            pair_of[row] = p;
            for (int r = 0; r <= row; ++r)
                system.M[row][r] = system.M[r][row] = coupling(p, pair_of[r]);
            if (pair.law.springs) {
                has_springs = true;
                pair.spring = resistance(pair.law, pair.shares, pair.x, pair.r.f_p);
                largest = max(largest, (approach + pair.spring.push) / (1.0 + pair.spring.yield));
                system.M[row][row] += pair.spring.yield / pair.shares.m_r;
            } else {
                system.M[row][row] += (1.0 - pair.r.f_p) / (pair.r.f_p * pair.shares.m_r);
            }
        }
        return largest;
    }

    // What a normal impulse of pair s takes from the approach of pair p [1/mass].
    double coupling(int p, int s) const {
        const auto side = [](const NodePair<C>& pair, int body) {
            return pair.a == body ? 1.0 : pair.b == body ? -1.0 : 0.0;
        };
        double sum = 0.0;
        for (const int body : {pairs[p].a, pairs[p].b})
            if (!rigid[body]) sum += side(pairs[p], body) * side(pairs[s], body) / mass[body];
        return sum * fused_dot(pairs[p].x.n, pairs[s].x.n);
    }

    // All normal impulses for the present friction, and both applied. The largest change, -1: none fits.
    double press(double allowed) {
        for (int body = 0; body < bodies; ++body) velocity[body] = trial[body];
        for (int row = 0; row < system.count; ++row)
            push(pairs[pair_of[row]], pairs[pair_of[row]].u_t, 1.0);
        for (int row = 0; row < system.count; ++row) {
            const NodePair<C>& pair = pairs[pair_of[row]];
            system.b[row] = fused_dot(velocity[pair.a] - velocity[pair.b], pair.x.n);
            if (pair.law.springs) system.b[row] += pair.spring.push;
        }
        if (!solve_normals(system, allowed)) return -1.0;
        double change = 0.0;
        for (int row = 0; row < system.count; ++row) {
            NodePair<C>& pair = pairs[pair_of[row]];
            const double u_n = system.J[row] / pair.shares.m_r;
            change = max(change, fabs(u_n - pair.r.u_n));
            pair.r.u_n = u_n;
            // What the others leave, (C5) or (C9).
            pair.r.w_n = pair.law.springs ? (1.0 + pair.spring.yield) * u_n - pair.spring.push
                                          : u_n / pair.r.f_p;
            pair.r.touches = u_n > 0.0;
            push(pair, pair.x.n, u_n);
            for (int c = 0; c < C; ++c) pair.r.u[c] = fma(u_n, pair.x.n[c], pair.u_t[c]);
        }
        return change;
    }

    // Friction of one pair after the other; the largest change.
    double rub() {
        double change = 0.0;
        for (int row = 0; row < system.count; ++row) {
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

    Velocity trial[most_bodies];
    NormalSystem system;
    bool has_springs = false;
    int pair_of[most_pairs];  // row of the system
};

GRIT_KERNEL_END
