// SPDX-License-Identifier: BSD-3-Clause
// Normals by logistic regression, node after node; the packs run over the particles of a node, so a
// node knows nothing of its neighbours.
#pragma once

#include "contact/normals/logistic.hpp"

GRIT_KERNEL_BEGIN

struct NodeNormal {
    RegressionFault fault;
    std::ptrdiff_t entry;
    bool defined;
    double n[3];
};

template <int D>
void write_direction(const RegressionRequest& q, const Cloud& cloud, NodeNormal& r) {
    const Regression<D> found = separate<D>(cloud, q.ridge, q.iteration_limit);
    if (!found.converged) {
        r.fault = RegressionFault::not_converged;
        return;
    }
    double largest = 0.0, length = 0.0;
    for (int c = 0; c < D; ++c) largest = max(largest, fabs(found.plane.u[c]));
    constexpr double noise = 1e-10;
    // Roundoff of the loss' gradient, at most radius, over its smallest curvature
    const double R = cloud.radius;
    r.defined = largest * (0.25 * R * R + q.ridge) > noise * R;
    if (!r.defined) return;
    for (int c = 0; c < D; ++c) length += square(found.plane.u[c] / largest);
    length = sqrt(length);
    for (int c = 0; c < D; ++c) r.n[cloud.component[c]] = found.plane.u[c] / largest / length;
}

inline NodeNormal normal_of(const RegressionRequest& q, std::ptrdiff_t node) {
    const grit_contact_clouds& in = *q.clouds;
    NodeNormal r{};
    const int fixed = mask_at(in.fixed, in.fixed_stride, node);
    if (!is_mask(fixed, in.components)) {
        r.fault = RegressionFault::fixed_out_of_range;
        return r;
    }
    const std::ptrdiff_t first = in.offset[node], last = in.offset[node + 1];
    if (!is_range(first, last)) {
        r.fault = RegressionFault::list_decreasing;
        return r;
    }
    Cloud cloud = empty_cloud(q, fixed);
    const CloudFault found = gather(q, first, last, cloud);
    r.fault = found.fault;
    r.entry = found.entry;
    if (r.fault != RegressionFault::none || !cloud.has_both) return r;
    if (cloud.dimensions == 3) write_direction<3>(q, cloud, r);
    if (cloud.dimensions == 2) write_direction<2>(q, cloud, r);
    if (cloud.dimensions == 1) write_direction<1>(q, cloud, r);
    return r;
}

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

RegressionOutcome regress(const RegressionRequest& q) {
    const grit_contact_clouds& in = *q.clouds;
    RegressionOutcome outcome;
    for (std::ptrdiff_t i = 0; i < q.n; ++i) {
        const std::ptrdiff_t node = in.index ? in.index[i] : i;
        const NodeNormal r = normal_of(q, node);
        if (r.fault != RegressionFault::none) {
            ++outcome.failed;
            if (outcome.fault == RegressionFault::none) {
                outcome.fault = r.fault;
                outcome.place = i;
                outcome.entry = r.entry;
            }
        } else {
            ++(r.defined ? outcome.defined : outcome.undefined);
            for (int c = 0; c < in.components; ++c)
                in.normal.base[node * in.normal.point_stride + c * in.normal.component_stride] =
                    r.n[c];
        }
        if (in.status) in.status[i] = status_of_regression(r.fault);
    }
    return outcome;
}

}  // namespace grit::GRIT_TARGET
