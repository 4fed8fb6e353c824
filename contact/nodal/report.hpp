// SPDX-License-Identifier: BSD-3-Clause
// The report of a node, from what its bodies answered.
#pragma once

#include "contact/nodal/node_views.hpp"
#include "contact/nodal/sums.hpp"

GRIT_KERNEL_BEGIN

// One node as plain numbers.
template <int C> struct NodeResponse {
    bool active, touches, slips;
    double m_r, a, b;  // as Shares
    Response<double, C> r;
};

template <class Real, int C>
GRIT_INLINE NodeResponse<C> lane_of(const Shares<Real>& shares, const Response<Real, C>& r,
                                    int lane) {
    NodeResponse<C> x;
    x.active = lane_of(shares.active, lane);
    x.touches = lane_of(r.touches, lane);
    x.slips = lane_of(r.slips, lane);
    x.m_r = lane_of(shares.m_r, lane);
    x.a = lane_of(shares.a, lane);
    x.b = lane_of(shares.b, lane);
    x.r.f_p = lane_of(r.f_p, lane);
    x.r.w_n = lane_of(r.w_n, lane);
    x.r.w_t = lane_of(r.w_t, lane);
    x.r.u_n = lane_of(r.u_n, lane);
    x.r.u_t = lane_of(r.u_t, lane);
    for (int i = 0; i < C; ++i) x.r.u[i] = lane_of(r.u[i], lane);
    return x;
}

// mean: (w_old + w_new) / 2, null if not known.
template <int C>
inline grit_contact_report report_of(const Law& law, const NodeResponse<C>& x,
                                     const Vector<double, C>& n, const Vector<double, C>* mean) {
    grit_contact_report report{};
    report.state = !x.active                     ? GRIT_CONTACT_INACTIVE
                   : !x.touches                  ? GRIT_CONTACT_OPEN
                   : x.slips || law.frictionless ? GRIT_CONTACT_SLIP
                                                 : GRIT_CONTACT_STICK;
    if (!x.active || !x.touches) return report;
    const Response<double, C>& r = x.r;
    report.penalty_factor = r.f_p;
    for (int i = 0; i < C; ++i) {
        report.impulse[i] = x.m_r * r.u[i];
        report.force[i] = report.impulse[i] * law.inverse_dt;
    }
    report.trial_energy_normal = x.m_r * r.u_n * (r.w_n - 0.5 * r.u_n);  // (C6)
    report.trial_energy_tangential = x.m_r * r.u_t * (r.w_t - 0.5 * r.u_t);
    if (mean) {
        report.dissipation_normal = x.m_r * r.u_n * fused_dot(*mean, n);
        const Vector<double, C> tangential = fused_sum(-r.u_n, n, r.u);
        report.dissipation_tangential = x.m_r * fused_dot(tangential, *mean);
    }
    return report;
}

// Moment of the force about the origin.
template <int C>
inline void moment_of(const grit_contact_report& report, const Vector<double, C>& x,
                      double moment[3]) {
    const double* f = report.force;
    const double z = C == 3 ? x[C - 1] : 0.0;
    moment[0] = x[1] * f[2] - z * f[1];
    moment[1] = z * f[0] - x[0] * f[2];
    moment[2] = x[0] * f[1] - x[1] * f[0];
}

GRIT_KERNEL_END
