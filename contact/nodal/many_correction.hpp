// SPDX-License-Identifier: BSD-3-Clause
// More than two bodies at a node, (C7): node after node is read, settled and written.
#pragma once

#include "contact/nodal/bodies_at_node.hpp"
#include "contact/nodal/pair_correction.hpp"

GRIT_KERNEL_BEGIN

template <int C> class ManyCorrection {
  public:
    explicit ManyCorrection(const ManyRequest& request)
        : q(request), b(*request.bodies),
          tolerance(b.sweep_tolerance > 0.0 ? b.sweep_tolerance : 1e-3),
          sweep_limit(b.sweep_limit > 0 ? b.sweep_limit : 50) {
        node.bodies = b.count;
        node.pair_count = q.pair_count;
        for (int p = 0; p < q.pair_count; ++p) {
            NodePair<C>& pair = node.pairs[p];
            pair.a = q.pairs[p].a;
            pair.b = q.pairs[p].b;
            pair.law = Law(q.pair_options[p]);
            node.rigid[pair.a] = pair.law.rigid_a;
            node.rigid[pair.b] = pair.law.rigid_b;
        }
    }

    CorrectionOutcome run() {
        for (std::ptrdiff_t i = 0; i < q.n; ++i) take(i);
        return outcome;
    }

  private:
    using Velocity = Vector<double, C>;

    void take(std::ptrdiff_t i) {
        const NodeIndices<1> here{{b.index ? b.index[i] : i}, 1, false};
        const int bad_pair = read(here);
        if (bad_pair >= 0) return fail(i, bad_pair, GRIT_BAD_STATE);
        if (!node.settle(tolerance, sweep_limit)) return fail(i, 0, GRIT_NOT_CONVERGED);
        if (!b.validate_only) write(here);
        if (q.reports || q.sums) report(i, here);
    }

    // -1, or the first pair that cannot be used.
    int read(const NodeIndices<1>& here) {
        for (int body = 0; body < b.count; ++body) {
            node.mass[body] = load<double>(b.mass[body], 0, here);
            node.velocity[body] = load_vector<C, double>(b.velocity[body], here);
        }
        node.active = 0;
        for (int p = 0; p < q.pair_count; ++p) {
            NodePair<C>& pair = node.pairs[p];
            const double m_a = node.mass[pair.a], m_b = node.mass[pair.b];
            if (!good_mass(m_a) || !good_mass(m_b)) return p;
            pair.r = {};
            pair.u_t = {};
            pair.shares = shares_of(pair.law, m_a, m_b);
            if (!pair.shares.active) continue;
            ++node.active;
            if (!read_pair(q.pairs[p], pair, here)) return p;
        }
        return -1;
    }

    bool read_pair(const grit_contact_pair& views, NodePair<C>& pair,
                   const NodeIndices<1>& here) const {
        const auto all = [](const auto& x) { return x; };
        const auto [x, good, no_normal] =
            read_approach<double, C>(views, pair.law, pair.law.geo, here, all);
        pair.x = x;
        pair.silent = no_normal;
        return good && good_body(pair.a, here) && good_body(pair.b, here) &&
               (!moves() || good_vector(load_vector<C, double>(b.position, here)));
    }

    bool good_body(int body, const NodeIndices<1>& here) const {
        bool good = good_vector(node.velocity[body]);
        if (b.acceleration && b.acceleration[body].base)
            good = good && good_vector(load_vector<C, double>(b.acceleration[body], here));
        if (dissipates())
            good = good && good_vector(load_vector<C, double>(b.previous_velocity[body], here));
        return good;
    }

    void write(const NodeIndices<1>& here) const {
        bool touched[most_bodies] = {};
        Velocity gained[most_bodies] = {};
        for (int p = 0; p < q.pair_count; ++p) {
            const NodePair<C>& pair = node.pairs[p];
            if (!pair.shares.active || !pair.r.touches) continue;
            const double per_dt = pair.law.inverse_dt;
            touched[pair.a] |= !pair.law.rigid_a;
            touched[pair.b] |= !pair.law.rigid_b;
            for (int c = 0; c < C; ++c) {
                gained[pair.a][c] += -pair.shares.a * pair.r.u[c] * per_dt;
                gained[pair.b][c] += pair.shares.b * pair.r.u[c] * per_dt;
            }
        }
        for (int body = 0; body < b.count; ++body) {
            if (!touched[body]) continue;
            for (int c = 0; c < C; ++c) {
                store(node.velocity[body][c], b.velocity[body], c, here);
                if (!b.acceleration || !b.acceleration[body].base) continue;
                const double old = load<double>(b.acceleration[body], c, here);
                store(old + gained[body][c], b.acceleration[body], c, here);
            }
        }
    }

    void report(std::ptrdiff_t i, const NodeIndices<1>& here) const {
        for (int p = 0; p < q.pair_count; ++p) {
            const NodePair<C>& pair = node.pairs[p];
            Velocity mean{};
            if (dissipates() && pair.shares.active) {
                const auto old_a = load_vector<C, double>(b.previous_velocity[pair.a], here);
                const auto old_b = load_vector<C, double>(b.previous_velocity[pair.b], here);
                for (int c = 0; c < C; ++c) {
                    const double w_new = node.velocity[pair.a][c] - node.velocity[pair.b][c];
                    mean[c] = 0.5 * (old_a[c] - old_b[c] + w_new);
                }
            }
            const grit_contact_report r = report_of(pair.law, lane_of(pair.shares, pair.r, 0),
                                                    pair.x.n, dissipates() ? &mean : nullptr);
            double moment[3] = {0.0, 0.0, 0.0};
            if (moves() && r.state >= GRIT_CONTACT_STICK)
                moment_of(r, load_vector<C, double>(b.position, here), moment);
            if (q.reports) q.reports[i * q.pair_count + p] = r;
            if (q.sums) add_to_sums(q.sums[p], r, moment);
        }
    }

    void fail(std::ptrdiff_t i, int pair, grit_status status) {
        if (outcome.node < 0) outcome = {i, pair, status};
        grit_contact_report r{};
        r.status = status;
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
    BodiesAtNode<C> node;
    CorrectionOutcome outcome;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

CorrectionOutcome correct_many(const ManyRequest& request) {
    if (request.bodies->components == 2) return ManyCorrection<2>(request).run();
    return ManyCorrection<3>(request).run();
}

}  // namespace grit::GRIT_TARGET
