// SPDX-License-Identifier: BSD-3-Clause
// A bad node in words: the first of its numbers that fails, with its limit.
#define GRIT_TARGET c_api
#include <cmath>
#include <utility>

#include "contact/nodal/call_checks.hpp"
#include "contact/nodal/node_checks.hpp"
#include "support/require.hpp"
#include "support/views.hpp"

namespace grit {
namespace {

double number(const grit_view& view, std::ptrdiff_t at, int c = 0) {
    return component(view, at, c);
}

// Vectors of two components have a third that is 0.
template <class View> Vector<double, 3> vector(const View& view, std::ptrdiff_t at, int count) {
    Vector<double, 3> v{};
    for (int c = 0; c < count; ++c) v[c] = component(view, at, c);
    return v;
}

// The component that is most to blame.
int worst(const Vector<double, 3>& v) {
    int at = 0;
    for (int c = 0; c < 3; ++c) {
        if (!(std::isfinite(v[c]))) return c;
        if (std::fabs(v[c]) > std::fabs(v[at])) at = c;
    }
    return at;
}

}  // namespace

grit_status describe_node(const grit_contact_nodes& q, const grit_contact_options& o,
                          std::ptrdiff_t i, grit_error* error) {
    const std::ptrdiff_t at = q.index ? q.index[i] : i;
    const auto say = [&](const char* format, auto... values) {
        return failure(error, GRIT_BAD_STATE, at, format, at, values...);
    };
    for (const auto& [name, view] : {std::pair("mass_a", q.mass_a), std::pair("mass_b", q.mass_b)})
        if (!c_api::good_mass(number(view, at)))
            return say("node %td: %s must be in [0, 1e100] [mass], got %g", name, number(view, at));

    const auto check_vector = [&](const char* name, const auto& view, const char* unit) {
        const auto v = vector(view, at, o.components);
        if (c_api::good_vector(v)) return grit_status(GRIT_OK);
        return say(
            "node %td: %s must be finite, |components| at most 1e100 in sum [%s], component %d "
            "is %g",
            name, unit, worst(v), v[worst(v)]);
    };
    if (const auto s = check_vector("velocity_a", q.velocity_a, "velocity")) return s;
    if (const auto s = check_vector("velocity_b", q.velocity_b, "velocity")) return s;
    const auto n = vector(q.normal, at, o.components);
    const bool silent = o.allow_zero_normal && c_api::zero_normal(n);
    if (!silent && !c_api::good_normal(n))
        return say("node %td: normal must be a unit vector, |n|^2 within %g of 1 [-], got |n| = %g",
                   normal_tolerance, std::sqrt(c_api::fused_dot(n, n)));
    if (q.gap.base && !c_api::good_signed_length(number(q.gap, at)))
        return say("node %td: gap must be >= -1e100 [length], got %g", number(q.gap, at));
    if (o.law == GRIT_CONTACT_GEO) {
        if (!c_api::good_signed_length(number(q.distance, at)))
            return say("node %td: distance must be >= -1e100 [length], got %g",
                       number(q.distance, at));
        if (!silent && q.cell_size.base && !c_api::good_length(number(q.cell_size, at)))
            return say("node %td: cell_size must be in [1e-100, 1e100] [length], got %g",
                       number(q.cell_size, at));
        for (int c = 0; c < o.components && !silent && !q.cell_size.base; ++c)
            if (!c_api::good_length(number(q.spacing, at, c)))
                return say("node %td: spacing component %d must be in [1e-100, 1e100] [length], "
                           "got %g",
                           c, number(q.spacing, at, c));
    }
    if ((o.adhesion > 0.0 || o.contact_stiffness > 0.0) &&
        !c_api::good_area(number(q.contact_area, at)))
        return say("node %td: contact_area must be in [0, 1e100] [area], got %g",
                   number(q.contact_area, at));
    if (q.pore_impulse.base && !c_api::good_impulse(number(q.pore_impulse, at)))
        return say("node %td: pore_impulse must be in [-1e100, 1e100] [mass velocity], got %g",
                   number(q.pore_impulse, at));
    const auto check_optional = [&](const char* name, const auto& view, const char* unit) {
        return view.base ? check_vector(name, view, unit) : grit_status(GRIT_OK);
    };
    const char* acceleration = "acceleration";
    if (const auto s = check_optional("acceleration_a", q.acceleration_a, acceleration)) return s;
    if (const auto s = check_optional("acceleration_b", q.acceleration_b, acceleration)) return s;
    const char* velocity = "velocity";
    if (const auto s = check_optional("previous_velocity_a", q.previous_velocity_a, velocity))
        return s;
    if (const auto s = check_optional("previous_velocity_b", q.previous_velocity_b, velocity))
        return s;
    if (const auto s = check_optional("position", q.position, "length")) return s;
    return failure(error, GRIT_INTERNAL, at, "node %td: unknown fault", at);
}

}  // namespace grit
