// SPDX-License-Identifier: BSD-3-Clause
// The particles of one node as the regression sees them: checked, scaled by the length, centred, of
// the free components only, and filled up to whole packs with rows that weigh nothing.
#pragma once

#include "contact/normals/regression_request.hpp"
#include "support/elementary.hpp"
#include "support/views.hpp"

GRIT_KERNEL_BEGIN

using Lanes = Pack<native_lanes>;

struct Cloud {
    double* row[4];    // y x of the free components, then y: -1 for A, +1 for B
    double* weight;    // sum 1
    int dimensions;    // free components
    int component[3];  // which these are
    int packs;
    double radius;  // largest |component| of an x
    bool has_both;  // bodies
};

struct CloudFault {
    RegressionFault fault;
    std::ptrdiff_t entry;
};

GRIT_INLINE Lanes load(const double* aligned) {
    Lanes x;
    __builtin_memcpy(&x.v, __builtin_assume_aligned(aligned, sizeof x.v), sizeof x.v);
    return x;
}

// Free components of a node, and where its rows go.
inline Cloud empty_cloud(const RegressionRequest& q, int fixed) {
    Cloud cloud{};
    for (int c = 0; c < q.clouds->components; ++c)
        if (!(fixed >> c & 1)) cloud.component[cloud.dimensions++] = c;
    for (int r = 0; r <= cloud.dimensions; ++r) cloud.row[r] = q.workspace + r * q.capacity;
    cloud.weight = q.workspace + (cloud.dimensions + 1) * q.capacity;
    return cloud;
}

// Move the rows to their mean, give them the sign of their body, and the weights of each body the sum
// 1/2: particles of one body that outnumber those of the other do not outvote them.
inline void centre(Cloud& cloud, std::ptrdiff_t count, const double sum[3], const double total[2]) {
    double* const y = cloud.row[cloud.dimensions];
    for (int r = 0; r < cloud.dimensions; ++r) {
        const double mean = sum[r] / static_cast<double>(count);
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            const double x = cloud.row[r][k] - mean;
            cloud.radius = max(cloud.radius, fabs(x));
            cloud.row[r][k] = y[k] * x;
        }
    }
    for (std::ptrdiff_t k = 0; k < count; ++k) cloud.weight[k] *= 0.5 / total[y[k] > 0.0];
    cloud.packs = static_cast<int>((count + native_lanes - 1) / native_lanes);
    for (std::ptrdiff_t k = count; k < cloud.packs * native_lanes; ++k) {
        for (int r = 0; r <= cloud.dimensions; ++r) cloud.row[r][k] = 0.0;
        cloud.weight[k] = 0.0;
    }
}

// Read the particles first ... last-1 of the list. One of weight 0 is as if it were not there.
inline CloudFault gather(const RegressionRequest& q, std::ptrdiff_t first, std::ptrdiff_t last,
                         Cloud& cloud) {
    const grit_contact_clouds& in = *q.clouds;
    const int D = cloud.dimensions;
    const std::ptrdiff_t body_stride = integer_stride(in.body_stride);
    double origin[3] = {}, low[3] = {}, high[3] = {}, sum[3] = {}, total[2] = {};
    std::ptrdiff_t count = 0;
    for (std::ptrdiff_t k = first; k < last; ++k) {
        const std::ptrdiff_t p = in.particle ? in.particle[k] : k;
        if (!is_index(p, in.particles)) return {RegressionFault::particle_out_of_range, k};
        const int body = in.body[p * body_stride];
        if (body != GRIT_CONTACT_BODY_A && body != GRIT_CONTACT_BODY_B)
            return {RegressionFault::body_unknown, k};
        const double weight = in.weight.base ? in.weight.base[p * in.weight.point_stride] : 1.0;
        if (!(weight == 0.0 ||
              (weight >= smallest_particle_weight && weight <= largest_particle_weight)))
            return {RegressionFault::weight_out_of_range, k};
        const double* const position = in.position.base + p * in.position.point_stride;
        for (int c = 0; c < in.components; ++c)
            if (!is_finite(position[c * in.position.component_stride]))
                return {RegressionFault::position_not_finite, k};
        if (weight == 0.0) continue;
        for (int r = 0; r < D; ++r) {
            const double x = position[cloud.component[r] * in.position.component_stride];
            if (count == 0) origin[r] = x;
            const double scaled = (x - origin[r]) / in.length;
            low[r] = min(low[r], scaled);
            high[r] = max(high[r], scaled);
            if (!(high[r] - low[r] <= largest_cloud)) return {RegressionFault::too_far_apart, k};
            cloud.row[r][count] = scaled;
            sum[r] += scaled;
        }
        cloud.row[D][count] = body == GRIT_CONTACT_BODY_B ? 1.0 : -1.0;
        cloud.weight[count] = weight;
        total[body] += weight;
        ++count;
    }
    cloud.has_both = total[0] > 0.0 && total[1] > 0.0;
    if (cloud.has_both) centre(cloud, count, sum, total);
    return {RegressionFault::none, -1};
}

GRIT_KERNEL_END
