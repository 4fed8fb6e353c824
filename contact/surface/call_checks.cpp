// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/call_checks.hpp"

#include <cmath>

namespace grit::surface {
namespace {

bool is_within(double x, double limit) { return std::fabs(x) <= limit; }

grit_status check_vector(const grit_view& view, std::ptrdiff_t i, int components, const char* whose,
                         const char* what, const char* unit, grit_error* error) {
    for (int c = 0; c < components; ++c)
        if (const double x = component(view, i, c); !is_within(x, largest_number))
            return failure(error, GRIT_BAD_STATE, i,
                           "%s %td: %s %d must be within +-1e30 (%s), got %g", whose, i, what, c,
                           unit, x);
    return GRIT_OK;
}

// check(vertex) of the vertices of all facets.
template <class Check>
grit_status check_vertices(const grit_surface& s, int components, const Check& check) {
    for (std::ptrdiff_t i = 0; i < components * s.facets; ++i) GRIT_CHECK(check(s.facet[i]));
    return GRIT_OK;
}

grit_status check_positions(const grit_surface& s, const char* name, const grit_surface_options& o,
                            grit_error* error) {
    for (std::ptrdiff_t f = 0; f < s.facets; ++f)
        for (int i = 0; i < o.components; ++i)
            if (const std::ptrdiff_t v = s.facet[o.components * f + i]; !is_index(v, s.vertices))
                return refuse_index(v, s.vertices, f, {name, "facet"}, error);
    return check_vertices(s, o.components, [&](std::ptrdiff_t v) -> grit_status {
        for (int c = 0; c < o.components; ++c)
            if (const double x = component(s.position, v, c); !is_within(x, largest_number))
                return failure(error, GRIT_BAD_STATE, v,
                               "%s vertex %td: position %d must be within +-1e30 (length), got %g",
                               name, v, c, x);
        if (o.axisymmetric && component(s.position, v, 0) < -1e-9 * o.reach)
            return failure(error, GRIT_BAD_STATE, v,
                           "%s vertex %td: r must be >= 0 (length) in axisymmetry, got %g", name, v,
                           component(s.position, v, 0));
        return GRIT_OK;
    });
}

grit_status check_rigid(const grit_surface& s, const char* name, int components,
                        grit_error* error) {
    GRIT_CHECK(check_usable(s.vertex_velocity, components, {name, "vertex_velocity"}, error));
    return check_vertices(s, components, [&](std::ptrdiff_t v) {
        return check_vector(s.vertex_velocity, v, components, name, "vertex velocity",
                            "length / time", error);
    });
}

grit_status check_water(const grit_surface& s, const char* name, std::ptrdiff_t node,
                        int components, grit_error* error) {
    constexpr const char* what[] = {"mass of water", "drag", "porosity"};
    constexpr const char* range[] = {"1e30] (mass)", "1e30] (mass)", "1]"};
    for (int i = 0; i < 3; ++i)
        if (const double x = component(s.pores, node, i);
            !(x >= 0.0 && x <= (i == 2 ? 1.0 : largest_number)))
            return failure(error, GRIT_BAD_STATE, node, "%s node %td: %s must be in [0, %s, got %g",
                           name, node, what[i], range[i], x);
    const grit_view seepage{s.seepage.base, s.seepage.point_stride, s.seepage.component_stride};
    for (const grit_view& v : {seepage, s.previous_seepage})
        for (int c = 0; v.base && c < components; ++c)
            if (const double x = component(v, node, c); !is_within(x, largest_number))
                return failure(
                    error, GRIT_BAD_STATE, node,
                    "%s node %td: seepage %d must be within +-1e30 (length / time), got %g", name,
                    node, c, x);
    if (s.water_fixed && !is_mask(s.water_fixed[node], components))
        return refuse_mask(s.water_fixed[node], components, node, {name, "water_fixed"}, error);
    return GRIT_OK;
}

grit_status check_node(const grit_surface& s, const char* name, std::ptrdiff_t node, int components,
                       grit_error* error) {
    const double m = component(s.mass, node, 0);
    if (!(m >= 1.0 / largest_number && m <= largest_number))
        return failure(
            error, GRIT_BAD_STATE, node,
            "%s node %td: mass must be in [1e-30, 1e30] (mass) where a vertex has weight, got "
            "%g",
            name, node, m);
    const grit_view velocity{s.velocity.base, s.velocity.point_stride, s.velocity.component_stride};
    for (const grit_view& v : {velocity, s.previous_velocity})
        for (int c = 0; v.base && c < components; ++c)
            if (const double x = component(v, node, c); !is_within(x, largest_number))
                return failure(
                    error, GRIT_BAD_STATE, node,
                    "%s node %td: velocity %d must be within +-1e30 (length / time), got "
                    "%g",
                    name, node, c, x);
    if (s.fixed && !is_mask(s.fixed[node], components))
        return refuse_mask(s.fixed[node], components, node, {name, "fixed"}, error);
    return s.pores.base ? check_water(s, name, node, components, error) : GRIT_OK;
}

grit_status check_free(const grit_surface& s, const char* name, const grit_surface_options& o,
                       grit_error* error) {
    const int components = o.components;
    GRIT_REQUIRE(s.nodes_each >= 1 && s.nodes_each <= 64,
                 "%s: nodes_each must be in [1, 64], got %d", name, s.nodes_each);
    GRIT_CHECK(check_count(s.nodes, {name, "nodes"}, error));
    GRIT_CHECK(check_given(s.node, {name, "node"}, error));
    GRIT_CHECK(check_given(s.weight, {name, "weight"}, error));
    GRIT_CHECK(check_base(s.mass, {name, "mass"}, error));
    GRIT_CHECK(check_output(s.velocity, components, {name, "velocity"}, error));
    GRIT_CHECK(check_apart(s.velocity, components, s.nodes, {name, "velocity"}, "nodes", error));
    if (s.previous_velocity.base)
        GRIT_CHECK(
            check_components(s.previous_velocity, components, {name, "previous_velocity"}, error));
    if (s.pores.base) {
        GRIT_CHECK(check_components(s.pores, 3, {name, "pores"}, error));
        GRIT_CHECK(check_output(s.seepage, components, {name, "seepage"}, error));
        GRIT_CHECK(check_apart(s.seepage, components, s.nodes, {name, "seepage"}, "nodes", error));
        if (s.previous_seepage.base)
            GRIT_CHECK(check_components(s.previous_seepage, components, {name, "previous_seepage"},
                                        error));
    }
    for (std::ptrdiff_t corner = 0; corner < components * s.facets; ++corner) {
        const std::ptrdiff_t v = s.facet[corner];
        double sum = 0.0;
        for (std::ptrdiff_t k = v * s.nodes_each; k < (v + 1) * s.nodes_each; ++k) {
            const double N = s.weight[k];
            if (!(N >= 0.0 && N <= 1.0 + 1e-6))
                return failure(error, GRIT_BAD_STATE, v,
                               "%s vertex %td: weight must be in [0, 1], got %g", name, v, N);
            sum += N;
            if (N == 0.0) continue;
            if (!is_index(s.node[k], s.nodes))
                return refuse_index(s.node[k], s.nodes, v, {name, "node"}, error);
            GRIT_CHECK(check_node(s, name, s.node[k], components, error));
        }
        if (!is_within(sum - 1.0, 1e-6))
            return failure(error, GRIT_BAD_STATE, v,
                           "%s vertex %td: the weights must add up to 1 within 1e-6, got %.9g",
                           name, v, sum);
    }
    return GRIT_OK;
}

}  // namespace

grit_status read_options(const grit_surface_options* given, grit_surface_options& o,
                         grit_error* error) {
    GRIT_REQUIRE(given, "options is null: time_step, spacing and reach have no default");
    GRIT_CHECK(read_struct(given, o, "grit_surface_options", error,
                           "call grit_surface_options_init first"));
    GRIT_CHECK(check_dimension(o.components, error));
    GRIT_CHECK(check_switch(o.axisymmetric, "axisymmetric", error));
    GRIT_CHECK(check_switch(o.validate_only, "validate_only", error));
    GRIT_REQUIRE(!o.axisymmetric || o.components == 2,
                 "axisymmetric needs components 2, r and z, got %d", o.components);
    GRIT_REQUIRE(o.sweep_limit >= 1 && o.sweep_limit <= 100000,
                 "sweep_limit must be in [1, 100000], got %d", o.sweep_limit);
    GRIT_REQUIRE(o.sweep_tolerance > 0.0 && o.sweep_tolerance <= 1.0,
                 "sweep_tolerance must be in (0, 1], got %g", o.sweep_tolerance);
    GRIT_REQUIRE(o.friction_coefficient >= 0.0 && o.friction_coefficient <= 1e6,
                 "friction_coefficient must be in [0, 1e6], got %g", o.friction_coefficient);
    GRIT_REQUIRE(o.time_step >= 1.0 / largest_number && o.time_step <= largest_number,
                 "time_step must be in [1e-30, 1e30] (time), got %g", o.time_step);
    GRIT_REQUIRE(o.spacing >= 1.0 / largest_number && o.spacing <= largest_number,
                 "spacing must be in [1e-30, 1e30] (length), got %g", o.spacing);
    GRIT_REQUIRE(o.reach >= 1.0 / largest_number && o.reach <= largest_number,
                 "reach must be in [1e-30, 1e30] (length), got %g", o.reach);
    GRIT_REQUIRE(o.end_spacings >= 1.0 && o.end_spacings <= 10.0,
                 "end_spacings must be in [1, 10], got %g", o.end_spacings);
    GRIT_REQUIRE(o.contact_stiffness >= 0.0 && o.contact_stiffness <= largest_number,
                 "contact_stiffness must be in [0, 1e30] (stress / length), got %g",
                 o.contact_stiffness);
    GRIT_REQUIRE(o.relaxation_time >= 0.0 && o.relaxation_time <= largest_number,
                 "relaxation_time must be in [0, 1e30] (time), got %g", o.relaxation_time);
    GRIT_REQUIRE(o.relaxation_time == 0.0 || o.contact_stiffness > 0.0,
                 "relaxation_time needs a contact_stiffness, got %g without", o.relaxation_time);
    return GRIT_OK;
}

grit_status read_surface(const grit_surface* given, const char* name, const grit_surface_options& o,
                         grit_surface& s, grit_error* error) {
    GRIT_CHECK(check_given(given, name, error));
    GRIT_CHECK(read_struct(given, s, {name, "grit_surface"}, error));
    GRIT_CHECK(check_switch(s.rigid, {name, "rigid"}, error));
    GRIT_REQUIRE(s.body >= 0, "%s: body must be >= 0, got %d", name, s.body);
    GRIT_CHECK(check_count(s.vertices, {name, "vertices"}, error));
    GRIT_CHECK(check_count(s.facets, {name, "facets"}, error));
    GRIT_REQUIRE(s.vertices <= largest_count && s.facets <= largest_count,
                 "%s: at most %td vertices and facets, got %td and %td", name, largest_count,
                 s.vertices, s.facets);
    if (s.vertices == 0 && s.facets == 0) return GRIT_OK;
    GRIT_CHECK(check_usable(s.position, o.components, {name, "position"}, error));
    if (s.facets > 0) GRIT_CHECK(check_given(s.facet, {name, "facet"}, error));
    GRIT_CHECK(check_positions(s, name, o, error));
    for (std::ptrdiff_t f = 0; s.spacing && f < s.facets; ++f)
        if (!(s.spacing[f] >= 1.0 / largest_number && s.spacing[f] <= largest_number))
            return failure(error, GRIT_BAD_STATE, f,
                           "%s facet %td: spacing must be in [1e-30, 1e30] (length), got %g", name,
                           f, s.spacing[f]);
    for (std::ptrdiff_t f = 0; s.pore_pressure && f < s.facets; ++f)
        if (!is_within(s.pore_pressure[f], largest_number))
            return failure(error, GRIT_BAD_STATE, f,
                           "%s facet %td: pore_pressure must be within +-1e30 (stress), got %g",
                           name, f, s.pore_pressure[f]);
    return s.rigid ? check_rigid(s, name, o.components, error) : check_free(s, name, o, error);
}

}  // namespace grit::surface
