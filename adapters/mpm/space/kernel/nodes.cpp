// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/kernel/nodes.hpp"

#include "adapters/mpm/kernel/local_damping.hpp"

namespace grit::mpm::space {
namespace {

bool is_fixed(const NodeCall& call, std::ptrdiff_t i, int k) {
    return call.fixed[i] & fixed::along(k);
}

void hold(const NodeCall& call, std::ptrdiff_t i) {
    for (int k = 0; k < 3; ++k)
        if (is_fixed(call, i, k)) call.motions[i][motion::v_x + k] = 0.0;
}

}  // namespace

void advance_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        NodeRecord& n = call.records[i];
        NodeMotion& v = call.motions[i];
        const double m = n[record::m];
        if (!(m > call.least_mass)) {
            v = NodeMotion{};
            continue;
        }
        // Nothing is mapped away where the node is reached for the first time.
        const bool moved = v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0;
        for (int k = 0; k < 3; ++k) {
            double &now = v[motion::v_x + k], &before = v[motion::other_x + k];
            double& force = n[record::f_x + k];
            before = is_fixed(call, i, k) ? 0.0 : n[record::p_x + k] / m;
            if (moved)
                call.add(sums.mapped_away, i,
                         0.5 * force * (call.dt_before * now - call.dt * before));
            if (call.loads) force += call.loads[i][k];
            now = is_fixed(call, i, k) ? 0.0 : before + call.dt * (force / m + call.gravity[k]);
        }
    }
}

void damp_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const NodeRecord& n = call.records[i];
        const double m = n[record::m];
        if (!(m > call.least_mass)) continue;
        NodeMotion& v = call.motions[i];
        hold(call, i);
        const double undamped_z = v[motion::v_z];
        for (int k = 0; k < 3; ++k)
            call.add(sums.damping_work, i,
                     damp(v[motion::v_x + k], v[motion::other_x + k], m,
                          call.dt * (n[record::f_x + k] + m * call.gravity[k]), call.damping));
        call.add(sums.damping_z, i, m * (v[motion::v_z] - undamped_z));
    }
}

void close_nodes(const NodeCall& call, NodeSums& sums) {
    for (std::ptrdiff_t i = call.begin; i < call.end; ++i) {
        const double m = call.records[i][record::m];
        if (!(m > call.least_mass)) continue;
        const NodeMotion& v = call.motions[i];
        hold(call, i);
        for (int k = 0; k < 3; ++k) {
            const double now = v[motion::v_x + k], before = v[motion::other_x + k];
            call.add(sums.change, i, 0.5 * m * (now - before) * (now - before));
            call.add(sums.gravity_work, i, 0.5 * call.dt * m * call.gravity[k] * (now + before));
        }
    }
}

}  // namespace grit::mpm::space
