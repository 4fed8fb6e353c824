// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/nodes.hpp"

#include <cmath>

namespace grit::mpm {
namespace {

// Against the motion; returns the force that is left.
double damped(double f, double v, double damping) {
    return v == 0.0 ? f : f - damping * std::copysign(std::fabs(f), v);
}

}  // namespace

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
        const double per_m = 1.0 / m;
        const double old_r = free_r * n[record::p_r] * per_m;
        const double old_z = free_z * n[record::p_z] * per_m;
        const int lane = call.by_other ? motion::other_r : motion::v_r;
        if (v[lane] != 0.0 || v[lane + 1] != 0.0)  // not reached for the first time
            sums.mapped_away +=
                0.5 * (n[record::f_r] * (call.dt_before * v[lane] - call.dt * old_r) +
                       n[record::f_z] * (call.dt_before * v[lane + 1] - call.dt * old_z));
        const double all_r = n[record::f_r] + m * call.gravity.r;
        const double all_z = n[record::f_z] + m * call.gravity.z;
        double f_r = all_r, f_z = all_z;
        if (call.damping > 0.0) {
            f_r = damped(f_r, old_r, call.damping);
            f_z = damped(f_z, old_z, call.damping);
        }
        const double v_r = old_r + free_r * call.dt * f_r * per_m;
        const double v_z = old_z + free_z * call.dt * f_z * per_m;
        if (call.damping > 0.0)
            sums.damping_work +=
                0.5 * call.dt * ((all_r - f_r) * (old_r + v_r) + (all_z - f_z) * (old_z + v_z));
        v = NodeMotion{v_r, v_z, old_r, old_z};
    }
}

void close_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const double m = call.records[i][record::m];
        if (!(m > call.least_mass)) continue;
        NodeMotion& v = call.motions[i];
        if (call.fixed[i] & fixed::r) v[motion::v_r] = 0.0;
        if (call.fixed[i] & fixed::z) v[motion::v_z] = 0.0;
        const double dv_r = v[motion::v_r] - v[motion::other_r];
        const double dv_z = v[motion::v_z] - v[motion::other_z];
        sums.change += 0.5 * m * (dv_r * dv_r + dv_z * dv_z);
        sums.gravity_work += 0.5 * call.dt * m *
                             (call.gravity.r * (v[motion::v_r] + v[motion::other_r]) +
                              call.gravity.z * (v[motion::v_z] + v[motion::other_z]));
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
        sums.mapped_away += 0.5 * call.dt *
                            (n[record::f_r] * (v[motion::other_r] - v[motion::v_r]) +
                             n[record::f_z] * (v[motion::other_z] - v[motion::v_z]));
    }
}

}  // namespace grit::mpm
