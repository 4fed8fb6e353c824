// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/nodes.hpp"

#include "adapters/mpm/kernel/local_damping.hpp"

namespace grit::mpm {
namespace {

// p/m without the fixed components.
Vector2 old_velocity(const NodeCall& call, std::ptrdiff_t i) {
    const NodeRecord& n = call.records[i];
    const double per_m = 1.0 / n[record::m];
    return {call.fixed[i] & fixed::r ? 0.0 : n[record::p_r] * per_m,
            call.fixed[i] & fixed::z ? 0.0 : n[record::p_z] * per_m};
}

// See NodeSums; none where the node is reached for the first time.
double mapped_away(const NodeCall& call, std::ptrdiff_t i, const Vector2& old) {
    const NodeMotion& v = call.motions[i];
    const int lane = call.by_other ? motion::other_r : motion::v_r;
    if (v[lane] == 0.0 && v[lane + 1] == 0.0) return 0.0;
    return 0.5 * (call.internal[i][0] * (call.dt_before * v[lane] - call.dt * old[0]) +
                  call.internal[i][1] * (call.dt_before * v[lane + 1] - call.dt * old[1]));
}

void hold(const NodeCall& call, std::ptrdiff_t i) {
    if (call.fixed[i] & fixed::r) call.motions[i][motion::v_r] = 0.0;
    if (call.fixed[i] & fixed::z) call.motions[i][motion::v_z] = 0.0;
}

}  // namespace

void start_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        NodeMotion& v = call.motions[i];
        if (!(call.records[i][record::m] > call.least_mass)) {
            v = NodeMotion{};
            continue;
        }
        const Vector2 old = old_velocity(call, i);
        call.add(sums.mapped_away, i, -mapped_away(call, i, old));
        v = NodeMotion{old[0], old[1], old[0], old[1]};
    }
}

void keep_internal(const NodeCall& call) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i)
        call.internal[i] = {call.records[i][record::f_r], call.records[i][record::f_z]};
}

void advance_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const NodeRecord& n = call.records[i];
        NodeMotion& v = call.motions[i];
        const double m = n[record::m];
        if (!(m > call.least_mass)) {
            v = NodeMotion{};
            continue;
        }
        const double free_r = call.fixed[i] & fixed::r ? 0.0 : 1.0;
        const double free_z = call.fixed[i] & fixed::z ? 0.0 : 1.0;
        const Vector2 old = old_velocity(call, i);
        if (!call.stress_first) call.add(sums.mapped_away, i, mapped_away(call, i, old));
        const double v_r = old[0] + free_r * call.dt * (n[record::f_r] / m + call.gravity[0]);
        const double v_z = old[1] + free_z * call.dt * (n[record::f_z] / m + call.gravity[1]);
        v = NodeMotion{v_r, v_z, old[0], old[1]};
    }
}

void damp_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const NodeRecord& n = call.records[i];
        const double m = n[record::m];
        if (!(m > call.least_mass)) continue;
        NodeMotion& v = call.motions[i];
        hold(call, i);
        const NodeMotion undamped = v, drag = call.drag ? call.drag[i] : NodeMotion{};
        const auto without_contact = [&](int k) {
            if (call.tied && (call.tied[i] & (k == 0 ? fixed::r : fixed::z)))
                return m * (v[k] - v[motion::other_r + k]);
            return call.dt * (n[record::f_r + k] + m * call.gravity[static_cast<std::size_t>(k)]) +
                   drag[motion::other_r + k];
        };
        const double of_r =
            damp(v[motion::v_r], v[motion::other_r], m, without_contact(0), call.damping);
        call.add(sums.damping_work, i,
                 of_r +
                     damp(v[motion::v_z], v[motion::other_z], m, without_contact(1), call.damping));
        call.add(sums.damping_z, i, m * (v[motion::v_z] - undamped[motion::v_z]));
        if (!call.damped) continue;
        NodeMotion& damped = call.damped[i];
        for (int k = 0; k < 2; ++k) {
            damped[k] = v[k];
            damped[motion::other_r + k] = m * (v[k] - undamped[k]);
            if (call.meets)
                damped[motion::other_r + k] +=
                    m * (undamped[k] - undamped[motion::other_r + k]) - without_contact(k);
        }
    }
}

void close_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const double m = call.records[i][record::m];
        if (!(m > call.least_mass)) continue;
        const NodeMotion& v = call.motions[i];
        hold(call, i);
        if (call.damping > 0.0 && call.damped)
            for (int k = 0; k < 2; ++k)
                call.add(sums.damping_work, i,
                         -0.5 * call.damped[i][motion::other_r + k] * (v[k] - call.damped[i][k]));
        const double dv_r = v[motion::v_r] - v[motion::other_r];
        const double dv_z = v[motion::v_z] - v[motion::other_z];
        call.add(sums.change, i, 0.5 * m * (dv_r * dv_r + dv_z * dv_z));
        call.add(sums.gravity_work, i,
                 0.5 * call.dt * m *
                     (call.gravity[0] * (v[motion::v_r] + v[motion::other_r]) +
                      call.gravity[1] * (v[motion::v_z] + v[motion::other_z])));
    }
}

void remap_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const NodeRecord& n = call.records[i];
        NodeMotion& v = call.motions[i];
        const double m = n[record::m];
        if (!(m > call.least_mass)) continue;
        v[motion::other_r] = call.fixed[i] & fixed::r ? 0.0 : n[record::p_r] / m;
        v[motion::other_z] = call.fixed[i] & fixed::z ? 0.0 : n[record::p_z] / m;
        call.add(sums.mapped_away, i,
                 0.5 * call.dt *
                     (call.internal[i][0] * (v[motion::other_r] - v[motion::v_r]) +
                      call.internal[i][1] * (v[motion::other_z] - v[motion::v_z])));
    }
}

}  // namespace grit::mpm
