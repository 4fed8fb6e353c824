// SPDX-License-Identifier: BSD-3-Clause
// More than two bodies at a node, (C7): Gauss-Seidel sweeps over the pairs, node after node.
#pragma once

#include "contact/nodal_correction.hpp"

GRIT_KERNEL_BEGIN

constexpr int most_bodies = GRIT_CONTACT_MOST_BODIES;
constexpr int most_pairs = most_bodies * (most_bodies - 1) / 2;

template <int C> class ManyCorrection {
  public:
    explicit ManyCorrection(const ManyRequest& request)
        : q(request), b(*request.bodies),
          tolerance(b.sweep_tolerance > 0.0 ? b.sweep_tolerance : 1e-3),
          sweep_limit(b.sweep_limit > 0 ? b.sweep_limit : 20) {}

    CorrectionOutcome run() {
        for (std::ptrdiff_t i = 0; i < q.n; ++i) take(i);
        return outcome;
    }

  private:
    using Velocity = Vector<double, C>;

    struct Pair {
        Shares<double> shares;
        Approach<double, C> x;
        Response<double, C> r;
        bool silent;  // an allowed zero normal
    };

    void take(std::ptrdiff_t i) {
        const Places<1> here{{b.index ? b.index[i] : i}, 1, false};
        const int bad_pair = read(here);
        if (bad_pair >= 0) {
            if (outcome.node < 0) outcome = {i, bad_pair};
            return report_failure(i);
        }
        if (active > 0) sweep();
        if (!b.validate_only) write(here);
        if (q.reports || q.sums) report(i, here);
    }

    // -1, or the first pair that cannot be used.
    int read(const Places<1>& here) {
        for (int body = 0; body < b.count; ++body) mass[body] = load<double>(b.mass[body], 0, here);
        for (int body = 0; body < b.count; ++body)
            velocity[body] = load_vector<C, double>(b.velocity[body], here);
        active = 0;
        for (int p = 0; p < q.pair_count; ++p) {
            const grit_contact_pair& pair = q.pairs[p];
            if (!good_mass(mass[pair.a]) || !good_mass(mass[pair.b])) return p;
            const Law law(q.pair_options[p]);
            pairs[p] = {};
            pairs[p].shares = shares_of(law, mass[pair.a], mass[pair.b]);
            if (!pairs[p].shares.active) continue;
            ++active;
            if (!read_pair(pair, q.pair_options[p], pairs[p], here)) return p;
        }
        return -1;
    }

    bool read_pair(const grit_contact_pair& pair, const grit_contact_options& options, Pair& p,
                   const Places<1>& here) const {
        p.x.n = load_vector<C, double>(pair.normal, here);
        p.silent = options.allow_zero_normal && zero_normal(p.x.n);
        bool good = p.silent || good_normal(p.x.n);
        p.x.gap = -std::numeric_limits<double>::infinity();
        if (pair.gap.base) p.x.gap = load<double>(pair.gap, 0, here);
        good = good && (!pair.gap.base || good_signed_length(p.x.gap));
        if (options.law == GRIT_CONTACT_GEO) {
            p.x.s = load<double>(pair.distance, 0, here);
            bool good_d = true;
            p.x.cell = cell_along(pair.cell_size, pair.spacing, p.x.n, here, good_d);
            good = good && good_signed_length(p.x.s) && (good_d || p.silent);
        }
        if (options.adhesion > 0.0) {
            p.x.area = load<double>(pair.contact_area, 0, here);
            good = good && good_area(p.x.area);
        }
        good = good && good_body(pair.a, here) && good_body(pair.b, here);
        return good && (!moves() || good_vector(load_vector<C, double>(b.position, here)));
    }

    bool good_body(int body, const Places<1>& here) const {
        bool good = good_vector(velocity[body]);
        if (b.acceleration && b.acceleration[body].base)
            good = good && good_vector(load_vector<C, double>(b.acceleration[body], here));
        if (dissipates())
            good = good && good_vector(load_vector<C, double>(b.previous_velocity[body], here));
        return good;
    }

    void sweep() {
        double largest_approach = 0.0;
        for (int s = 0; s < sweep_limit; ++s) {
            double largest_change = 0.0;
            for (int p = 0; p < q.pair_count; ++p) {
                Pair& pair = pairs[p];
                if (!pair.shares.active || pair.silent) continue;
                Velocity& v_a = velocity[q.pairs[p].a];
                Velocity& v_b = velocity[q.pairs[p].b];
                const Velocity old = pair.r.u;
                if (pair.r.touches)  // without what this pair did in the last sweep
                    for (int c = 0; c < C; ++c) {
                        v_a[c] += pair.shares.a * old[c];
                        v_b[c] -= pair.shares.b * old[c];
                    }
                pair.x.w = difference(v_a, v_b);
                pair.r = respond<double, C>(Law(q.pair_options[p]), pair.shares, pair.x);
                largest_approach = max(largest_approach, pair.r.w_n);
                if (!pair.r.touches) pair.r.u = {};
                for (int c = 0; c < C; ++c) {
                    if (pair.r.touches) {
                        v_a[c] -= pair.shares.a * pair.r.u[c];
                        v_b[c] += pair.shares.b * pair.r.u[c];
                    }
                    largest_change = max(largest_change, fabs(pair.r.u[c] - old[c]));
                }
            }
            if (active == 1 || largest_change <= tolerance * largest_approach) return;
        }
    }

    void write(const Places<1>& here) const {
        bool touched[most_bodies] = {};
        Velocity gained[most_bodies] = {};
        for (int p = 0; p < q.pair_count; ++p) {
            const Pair& pair = pairs[p];
            if (!pair.shares.active || !pair.r.touches) continue;
            const Law law(q.pair_options[p]);
            touched[q.pairs[p].a] |= !law.rigid_a;
            touched[q.pairs[p].b] |= !law.rigid_b;
            for (int c = 0; c < C; ++c) {
                gained[q.pairs[p].a][c] += -(pair.shares.a * pair.r.u[c]) * law.inverse_dt;
                gained[q.pairs[p].b][c] += pair.shares.b * pair.r.u[c] * law.inverse_dt;
            }
        }
        for (int body = 0; body < b.count; ++body) {
            if (!touched[body]) continue;
            for (int c = 0; c < C; ++c) {
                store(velocity[body][c], b.velocity[body], c, here);
                if (!b.acceleration || !b.acceleration[body].base) continue;
                const double old = load<double>(b.acceleration[body], c, here);
                store(old + gained[body][c], b.acceleration[body], c, here);
            }
        }
    }

    void report(std::ptrdiff_t i, const Places<1>& here) const {
        for (int p = 0; p < q.pair_count; ++p) {
            const Pair& pair = pairs[p];
            const grit_contact_pair& who = q.pairs[p];
            Velocity mean{};
            if (dissipates() && pair.shares.active) {
                const auto old_a = load_vector<C, double>(b.previous_velocity[who.a], here);
                const auto old_b = load_vector<C, double>(b.previous_velocity[who.b], here);
                for (int c = 0; c < C; ++c)
                    mean[c] = 0.5 * (old_a[c] - old_b[c] + velocity[who.a][c] - velocity[who.b][c]);
            }
            const grit_contact_report r =
                report_of(Law(q.pair_options[p]), lane_of(pair.shares, pair.r, 0), pair.x.n,
                          dissipates() ? &mean : nullptr);
            double moment[3] = {0.0, 0.0, 0.0};
            if (moves() && r.state >= GRIT_CONTACT_STICK)
                moment_of(r, load_vector<C, double>(b.position, here), moment);
            if (q.reports) q.reports[i * q.pair_count + p] = r;
            if (q.sums) add_to_sums(q.sums[p], r, moment);
        }
    }

    void report_failure(std::ptrdiff_t i) const {
        grit_contact_report r{};
        r.status = GRIT_BAD_STATE;
        const double moment[3] = {0.0, 0.0, 0.0};
        for (int p = 0; p < q.pair_count; ++p) {
            if (q.reports) q.reports[i * q.pair_count + p] = r;
            if (q.sums) add_to_sums(q.sums[p], r, moment);
        }
    }

    bool dissipates() const { return (q.reports || q.sums) && b.previous_velocity; }
    bool moves() const { return q.sums && b.position.base; }

    const ManyRequest& q;
    const grit_contact_bodies& b;
    const double tolerance;
    const int sweep_limit;
    double mass[most_bodies];
    Velocity velocity[most_bodies];
    Pair pairs[most_pairs];
    int active = 0;
    CorrectionOutcome outcome;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

CorrectionOutcome correct_many(const ManyRequest& request) {
    if (request.bodies->components == 2) return ManyCorrection<2>(request).run();
    return ManyCorrection<3>(request).run();
}

}  // namespace grit::GRIT_TARGET
