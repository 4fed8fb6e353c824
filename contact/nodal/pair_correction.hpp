// SPDX-License-Identifier: BSD-3-Clause
// One pair of bodies at many nodes, a pack of nodes at a time. A lane never looks at its neighbours.
#pragma once

#include "contact/nodal/read_approach.hpp"
#include "contact/nodal/report.hpp"
#include "contact/nodal/request.hpp"

GRIT_KERNEL_BEGIN

// What inactive lanes hold is not looked at: a comparison with their NaN might trap. In most packs of a
// contact surface all lanes are active.
struct Partly {
    template <class Mask, class X> GRIT_INLINE X only(const Mask& mask, const X& x) const {
        return where(mask, x);
    }
};
struct Fully {
    template <class Mask, class X> GRIT_INLINE X only(const Mask&, const X& x) const { return x; }
};

template <int C, bool geo> class Correction {
  public:
    explicit Correction(const CorrectionRequest& request)
        : q(*request.nodes), law(*request.options), n(request.n), reports(request.reports),
          sums(request.sums), writes(!request.options->validate_only),
          dissipates((reports || sums) && q.previous_velocity_a.base && q.previous_velocity_b.base),
          moves(sums && q.position.base) {}

    CorrectionOutcome run() {
        std::ptrdiff_t i = 0;
        for (; i + native_lanes <= n; i += native_lanes) take<Pack<native_lanes>>(i, native_lanes);
        if (n - i == 1) take<double>(i, 1);
        else if (n > i) take<Pack<native_lanes>>(i, static_cast<int>(n - i));
        return outcome;
    }

  private:
    template <class Real> GRIT_INLINE void take(std::ptrdiff_t first, int used) {
        using Mask = MaskOf<Real>;
        const auto indices = node_indices<lanes_of<Real>>(q.index, first, used);
        const Real m_a = load<Real>(q.mass_a, 0, indices);
        const Real m_b = load<Real>(q.mass_b, 0, indices);
        Shares<Real> shares = shares_of(law, m_a, m_b);
        const Mask good_masses = good_mass(m_a) & good_mass(m_b), bad_masses = !good_masses;
        shares.active = shares.active & good_masses;
        if (!any(shares.active)) {
            if (any(bad_masses) || reports || sums)
                finish<Real>(first, indices, shares, bad_masses, {}, {}, {});
            return;
        }
        if (any(!shares.active)) correct<Real>(first, indices, shares, bad_masses, Partly{});
        else correct<Real>(first, indices, shares, bad_masses, Fully{});
    }

    template <class Real, class Lanes>
    GRIT_INLINE void correct(std::ptrdiff_t first, const NodeIndices<lanes_of<Real>>& indices,
                             const Shares<Real>& shares, const MaskOf<Real>& bad_masses,
                             Lanes lanes) {
        using Mask = MaskOf<Real>;
        const Mask& active = shares.active;
        const auto only = [&](const auto& x) { return lanes.only(active, x); };
        const auto v_a = load_vector<C, Real>(q.velocity_a, indices);
        const auto v_b = load_vector<C, Real>(q.velocity_b, indices);
        auto [x, good, no_normal] = read_approach<Real, C>(q, law, geo, indices, only);
        good = good & good_vector(only(v_a)) & good_vector(only(v_b));
        good = good & good_companions<Real>(only, indices);
        x.w = only(v_a - v_b);

        Response<Real, C> r = respond<Real, C>(law, shares, x);
        const Mask bad = bad_masses | (active & (!good));
        r.touches = r.touches & (!bad) & (!no_normal);
        r.slips = r.slips & r.touches;
        if (writes && any(r.touches)) write(indices, shares, r, v_a, v_b);
        if (reports || sums || any(bad)) finish(first, indices, shares, bad, r, x, {v_a, v_b});
    }

    template <class Real> struct Velocities {
        Vector<Real, C> a, b;  // before the correction
    };

    template <class Real>
    GRIT_INLINE MaskOf<Real> good_companions(const auto& only,
                                             const NodeIndices<lanes_of<Real>>& indices) const {
        const auto good_if = [&](bool asked, const auto& view) __attribute__((always_inline)) {
            if (!asked || !view.base) return MaskOf<Real>(true);
            return MaskOf<Real>(good_vector(only(load_vector<C, Real>(view, indices))));
        };
        return good_if(true, q.acceleration_a) & good_if(true, q.acceleration_b) &
               good_if(dissipates, q.previous_velocity_a) &
               good_if(dissipates, q.previous_velocity_b) & good_if(moves, q.position);
    }

    template <class Real>
    GRIT_INLINE void write(const NodeIndices<lanes_of<Real>>& indices, const Shares<Real>& shares,
                           const Response<Real, C>& r, const Vector<Real, C>& v_a,
                           const Vector<Real, C>& v_b) const {
        const Vector<Real, C> a = -shares.a * r.u, b = shares.b * r.u;  // (C6)
        if (!law.rigid_a) {
            store_vector(added(r.touches, a, v_a), q.velocity_a, indices);
            if (q.acceleration_a.base) accelerate(indices, r, q.acceleration_a, a);
        }
        if (!law.rigid_b) {
            store_vector(added(r.touches, b, v_b), q.velocity_b, indices);
            if (q.acceleration_b.base) accelerate(indices, r, q.acceleration_b, b);
        }
    }

    // v + by where mask holds, the bits of v elsewhere.
    template <class Real>
    static GRIT_INLINE Vector<Real, C> added(const MaskOf<Real>& mask, const Vector<Real, C>& by,
                                             const Vector<Real, C>& v) {
        Vector<Real, C> sum;
        for (int i = 0; i < C; ++i) sum[i] = select(mask, v[i] + by[i], v[i]);
        return sum;
    }

    template <class Real>
    GRIT_INLINE void accelerate(const NodeIndices<lanes_of<Real>>& indices,
                                const Response<Real, C>& r, const grit_mutable_view& view,
                                const Vector<Real, C>& by) const {
        const auto old = load_vector<C, Real>(view, indices);
        const auto rate = Real(law.inverse_dt) * by;
        store_vector(added(r.touches, rate, old), view, indices);
    }

    template <class Real>
    void finish(std::ptrdiff_t first, const NodeIndices<lanes_of<Real>>& indices,
                const Shares<Real>& shares, const MaskOf<Real>& bad, const Response<Real, C>& r,
                const Approach<Real, C>& x, const Velocities<Real>& v) {
        for (int lane = 0; lane < indices.used; ++lane) {
            grit_contact_report report{};
            double moment[3] = {0.0, 0.0, 0.0};
            if (lane_of(bad, lane)) {
                report.status = GRIT_BAD_STATE;
                if (outcome.node < 0) outcome.node = first + lane;
            } else if (lane_of(shares.active, lane)) {
                describe(lane, indices.at[lane], shares, r, x, v, report, moment);
            }
            if (reports) reports[first + lane] = report;
            if (sums) add_to_sums(*sums, report, moment);
        }
    }

    template <class Real>
    void describe(int lane, std::ptrdiff_t at, const Shares<Real>& shares,
                  const Response<Real, C>& r, const Approach<Real, C>& x, const Velocities<Real>& v,
                  grit_contact_report& report, double moment[3]) const {
        const NodeResponse<C> node = lane_of(shares, r, lane);
        const NodeIndices<1> here{{at}, 1, false};
        Vector<double, C> normal, mean;
        for (int i = 0; i < C; ++i) normal[i] = lane_of(x.n[i], lane);
        if (dissipates) {
            const auto old_a = load_vector<C, double>(q.previous_velocity_a, here);
            const auto old_b = load_vector<C, double>(q.previous_velocity_b, here);
            for (int i = 0; i < C; ++i) {
                const double w_new = (lane_of(v.a[i], lane) - node.a * node.r.u[i]) -
                                     (lane_of(v.b[i], lane) + node.b * node.r.u[i]);
                mean[i] = 0.5 * (old_a[i] - old_b[i] + w_new);
            }
        }
        report = report_of(law, node, normal, dissipates ? &mean : nullptr);
        if (moves) moment_of(report, load_vector<C, double>(q.position, here), moment);
    }

    const grit_contact_nodes& q;
    const Law law;
    const std::ptrdiff_t n;
    grit_contact_report* const reports;
    grit_contact_sums* const sums;
    const bool writes, dissipates, moves;
    CorrectionOutcome outcome;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

CorrectionOutcome correct(const CorrectionRequest& request) {
    const bool plane = request.options->components == 2;
    if (request.options->law == GRIT_CONTACT_GEO)
        return plane ? Correction<2, true>(request).run() : Correction<3, true>(request).run();
    return plane ? Correction<2, false>(request).run() : Correction<3, false>(request).run();
}

}  // namespace grit::GRIT_TARGET
