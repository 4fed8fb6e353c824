// SPDX-License-Identifier: BSD-3-Clause
// Start, merging and end of the distances' reduction.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/distance/surfaces.hpp"

namespace grit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int bodies = 2;

void lower(const grit_mutable_view& into, const grit_mutable_view& from, std::ptrdiff_t i) {
    for (int body = 0; body < bodies; ++body) {
        double& mine = component(into, i, body);
        const double other = component(from, i, body);
        mine = mine <= other   ? mine
               : other <= mine ? other
                               : mine + other;  // a NaN of either stays
    }
}

// The minimum of one body at a node: what reset and add leave is above -infinity.
bool is_minimum(double x) { return x > -infinity; }

grit_status finish_node(const grit_contact_surfaces& s, const grit_contact_distances& q,
                        std::ptrdiff_t i, grit_error* error) {
    const std::ptrdiff_t node = q.index ? q.index[i] : i;
    if (!is_index(node, s.nodes)) return refuse_entry(node, s.nodes, i, "index", error);
    const double from_a = component(s.surface, node, GRIT_CONTACT_BODY_A);
    const double from_b = component(s.surface, node, GRIT_CONTACT_BODY_B);
    if (!(is_minimum(from_a) && is_minimum(from_b)))
        return failure(error, GRIT_BAD_STATE, i,
                       "node %td: surface must be above -infinity, got %g and %g: never reset?",
                       node, from_a, from_b);
    if (q.distance.base) {
        double distance = q.stiffer == GRIT_CONTACT_BODY_A ? from_a : from_b;  // (C4)
        if (q.measure == GRIT_CONTACT_EDGE) distance = std::fabs(distance);
        if (q.measure == GRIT_CONTACT_NEAREST_CENTRE) {
            distance = component(s.centre, node, q.stiffer);
            if (!(distance >= 0.0))
                return failure(error, GRIT_BAD_STATE, i,
                               "node %td: centre must be >= 0, got %g: never reset?", node,
                               distance);
        }
        component(q.distance, node, 0) = distance;
    }
    if (q.gap.base) component(q.gap, node, 0) = from_a + from_b;  // (C3)
    return GRIT_OK;
}

grit_status check_distances(const grit_contact_surfaces& s, const grit_contact_distances& q,
                            std::ptrdiff_t n, grit_error* error) {
    GRIT_REQUIRE(q.distance.base || q.gap.base, "neither distance nor gap has a base pointer");
    GRIT_CHECK(check_written(q.distance, n, "distance", "nodes", error));
    GRIT_CHECK(check_written(q.gap, n, "gap", "nodes", error));
    if (!q.distance.base) return GRIT_OK;
    GRIT_CHECK(check_body(q.stiffer, "stiffer", error));
    GRIT_REQUIRE(q.measure >= GRIT_CONTACT_SUPPORT && q.measure <= GRIT_CONTACT_NEAREST_CENTRE,
                 "measure must be GRIT_CONTACT_SUPPORT, _EDGE or _NEAREST_CENTRE, got %d",
                 q.measure);
    GRIT_REQUIRE(q.measure != GRIT_CONTACT_NEAREST_CENTRE || s.centre.base,
                 "GRIT_CONTACT_NEAREST_CENTRE needs centre, which has no base pointer");
    return GRIT_OK;
}

}  // namespace
}  // namespace grit

extern "C" {

grit_status grit_contact_surfaces_reset(const grit_contact_surfaces* surfaces, grit_error* error) {
    using namespace grit;
    grit_contact_surfaces s{};
    GRIT_CHECK(read_surfaces(surfaces, s, error));
    for (ptrdiff_t i = 0; i < s.nodes; ++i)
        for (int body = 0; body < bodies; ++body) {
            component(s.surface, i, body) = infinity;
            if (s.centre.base) component(s.centre, i, body) = infinity;
        }
    return GRIT_OK;
}

grit_status grit_contact_surfaces_merge(const grit_contact_surfaces* into,
                                        const grit_contact_surfaces* from, grit_error* error) {
    using namespace grit;
    grit_contact_surfaces a{}, b{};
    GRIT_CHECK(read_surfaces(into, a, error));
    GRIT_CHECK(read_surfaces(from, b, error));
    GRIT_REQUIRE(a.nodes == b.nodes, "nodes must be the same to merge, got %td and %td", a.nodes,
                 b.nodes);
    GRIT_REQUIRE(!a.centre.base == !b.centre.base, "one of the surfaces to merge has no centre");
    for (ptrdiff_t i = 0; i < a.nodes; ++i) {
        lower(a.surface, b.surface, i);
        if (a.centre.base) lower(a.centre, b.centre, i);
    }
    return GRIT_OK;
}

grit_status grit_contact_surfaces_finish(const grit_contact_surfaces* surfaces, ptrdiff_t n,
                                         const grit_contact_distances* distances,
                                         grit_error* error) {
    using namespace grit;
    GRIT_CHECK(check_given(distances, {"grit_contact_surfaces_finish", "distances"}, error));
    GRIT_CHECK(check_count(n, {"grit_contact_surfaces_finish", "n"}, error));
    grit_contact_surfaces s{};
    GRIT_CHECK(read_surfaces(surfaces, s, error));
    grit_contact_distances q{};
    GRIT_CHECK(read_struct(distances, q, "grit_contact_distances", error));
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    GRIT_CHECK(check_distances(s, q, n, error));
    grit_status result = GRIT_OK;
    for (ptrdiff_t i = 0; i < n; ++i) {
        const grit_status status = finish_node(s, q, i, result == GRIT_OK ? error : nullptr);
        if (result == GRIT_OK) result = status;
    }
    return result;
}
}
