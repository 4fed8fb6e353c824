// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_normals_from_gradients: one vector per node, without its fixed components, of length 1.
#include <algorithm>
#include <cmath>

#include <grit/contact_normals.h>

#include "support/call_checks.hpp"
#include "support/vector.hpp"

namespace grit {
namespace {

constexpr double default_threshold = 1e-8;

double largest(const Vector3& v) {
    return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

struct Node {
    Vector3 a{}, b{};    // n is along a - b
    double scale = 0.0;  // size of the terms they were summed of
    int fixed = 0;
};

grit_status read_vector(const grit_view& view, int components, std::ptrdiff_t node,
                        const char* name, Vector3& v, grit_error* error, std::ptrdiff_t i) {
    for (int c = 0; c < components; ++c) {
        v[c] = component(view, node, c);
        if (!is_finite(v[c]))
            return failure(error, GRIT_BAD_STATE, i,
                           "node %td: %s component %d must be finite, got %g", node, name, c, v[c]);
    }
    return GRIT_OK;
}

grit_status read_node(const grit_contact_gradients& q, std::ptrdiff_t i, Node& x,
                      grit_error* error) {
    const std::ptrdiff_t node = q.index ? q.index[i] : i;
    const auto read = [&](const grit_view& view, const char* name, Vector3& v) {
        return read_vector(view, q.components, node, name, v, error, i);
    };
    grit_status status = GRIT_OK;
    if (q.source == GRIT_CONTACT_NORMAL_GIVEN) status = read(q.given, "given", x.a);
    if (q.source == GRIT_CONTACT_NORMAL_OF_A || q.source == GRIT_CONTACT_NORMAL_AVERAGE)
        status = read(q.gradient_a, "gradient_a", x.a);
    if (status) return status;
    if (q.source == GRIT_CONTACT_NORMAL_OF_B || q.source == GRIT_CONTACT_NORMAL_AVERAGE)
        status = read(q.gradient_b, "gradient_b", x.b);
    if (status) return status;
    if (q.scale.base) x.scale = component(q.scale, node, 0);
    if (!(x.scale >= 0.0 && is_finite(x.scale)))
        return failure(error, GRIT_BAD_STATE, i, "node %td: scale must be finite and >= 0, got %g",
                       node, x.scale);
    x.fixed = mask_at(q.fixed, q.fixed_stride, node);
    if (!is_mask(x.fixed, q.components))
        return refuse_mask(x.fixed, q.components, i, {"node", node, "fixed"}, error);
    return GRIT_OK;
}

// (C2). All zero where the fixed components and roundoff leave nothing.
Vector3 normal_of(const Node& x, double threshold) {
    const double unit = std::max(largest(x.a), largest(x.b));  // tiny and huge ones are alike
    if (unit == 0.0) return {};
    const Vector3 a = x.a / unit, b = x.b / unit;
    Vector3 v{};
    for (int c = 0; c < 3; ++c)
        if (!(x.fixed >> c & 1)) v[c] = a[c] - b[c];
    const double size = std::max(norm(a) + norm(b), x.scale / unit);
    const double left = largest(v);
    if (!(left > 0.0) || norm(v) <= threshold * size) return {};
    v = v / left;
    return v / norm(v);
}

grit_status check_call(const grit_contact_gradients& q, std::ptrdiff_t n, grit_error* error) {
    GRIT_CHECK(check_dimension(q.components, error));
    GRIT_REQUIRE(q.source >= GRIT_CONTACT_NORMAL_OF_A && q.source <= GRIT_CONTACT_NORMAL_GIVEN,
                 "source must be GRIT_CONTACT_NORMAL_OF_A, _OF_B, _AVERAGE or _GIVEN, got %d",
                 q.source);
    GRIT_REQUIRE(q.threshold >= 0.0 && q.threshold < 1.0, "threshold must be in [0, 1), got %g",
                 q.threshold);
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    const bool average = q.source == GRIT_CONTACT_NORMAL_AVERAGE;
    const auto check_source = [&](const grit_view& view, const char* name) {
        return check_usable_for("source", q.source, view, q.components, name, error);
    };
    if (average || q.source == GRIT_CONTACT_NORMAL_OF_A)
        GRIT_CHECK(check_source(q.gradient_a, "gradient_a"));
    if (average || q.source == GRIT_CONTACT_NORMAL_OF_B)
        GRIT_CHECK(check_source(q.gradient_b, "gradient_b"));
    if (q.source == GRIT_CONTACT_NORMAL_GIVEN) GRIT_CHECK(check_source(q.given, "given"));
    GRIT_CHECK(check_usable(q.normal, q.components, "normal", error));
    return check_written(q.normal, n, "normal", "nodes", error);
}

}  // namespace
}  // namespace grit

extern "C" grit_status grit_contact_normals_from_gradients(ptrdiff_t n,
                                                           const grit_contact_gradients* gradients,
                                                           grit_contact_normal_counts* counts,
                                                           grit_error* error) {
    using namespace grit;
    const char* const name = "grit_contact_normals_from_gradients";
    GRIT_CHECK(check_given(gradients, {name, "gradients"}, error));
    GRIT_CHECK(check_count(n, {name, "n"}, error));
    grit_contact_gradients q{};
    GRIT_CHECK(read_struct(gradients, q, "grit_contact_gradients", error));
    grit_contact_normal_counts found{};
    GRIT_CHECK(begin_result(found, counts, "grit_contact_normal_counts", error));
    GRIT_CHECK(check_call(q, n, error));
    const double threshold = q.threshold > 0.0 ? q.threshold : default_threshold;
    grit_status result = GRIT_OK;
    for (ptrdiff_t i = 0; i < n; ++i) {
        Node x;
        const grit_status status = read_node(q, i, x, result == GRIT_OK ? error : nullptr);
        if (q.status) q.status[i] = status;
        if (status != GRIT_OK) {
            ++found.failed;
            if (result == GRIT_OK) result = status;
            continue;
        }
        const Vector3 v = normal_of(x, threshold);
        ++(largest(v) > 0.0 ? found.defined : found.undefined);
        const ptrdiff_t node = q.index ? q.index[i] : i;
        for (int c = 0; c < q.components; ++c) component(q.normal, node, c) = v[c];
    }
    if (counts) write_versioned(found, counts);
    return result;
}
