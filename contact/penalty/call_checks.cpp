// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty/call_checks.hpp"

#include "support/versioned.hpp"

namespace grit::penalty {

grit_status read_options(const grit_penalty_options* given, grit_penalty_options& o,
                         grit_error* error) {
    GRIT_REQUIRE(given, "options is null: normal_stiffness and depth_max have no default");
    GRIT_REQUIRE(read_versioned(given, o),
                 "grit_penalty_options.struct_size %zu is not understood: call "
                 "grit_penalty_options_init first",
                 given->struct_size);
    GRIT_REQUIRE(is_switch(o.axisymmetric), "axisymmetric must be 0 or 1, got %d", o.axisymmetric);
    GRIT_REQUIRE(is_switch(o.validate_only), "validate_only must be 0 or 1, got %d",
                 o.validate_only);
    GRIT_REQUIRE(o.normal_stiffness > 0.0 && o.normal_stiffness <= 1e60,
                 "normal_stiffness must be in (0, 1e60] (stress / length), got %g",
                 o.normal_stiffness);
    GRIT_REQUIRE(o.tangential_stiffness >= 0.0 && o.tangential_stiffness <= 1e60,
                 "tangential_stiffness must be in [0, 1e60] (stress / length), got %g",
                 o.tangential_stiffness);
    GRIT_REQUIRE(o.friction_coefficient >= 0.0 && o.friction_coefficient <= 1e6,
                 "friction_coefficient must be in [0, 1e6], got %g", o.friction_coefficient);
    GRIT_REQUIRE(o.depth_max > 0.0 && o.depth_max <= largest_length,
                 "depth_max must be in (0, 1e30] (length), got %g", o.depth_max);
    const bool friction = o.friction_coefficient > 0.0;
    GRIT_REQUIRE(!friction || (o.time_step > 0.0 && o.time_step <= 1e30),
                 "time_step must be in (0, 1e30] (time) with friction, got %g", o.time_step);
    if (!friction) o.time_step = 0.0;
    if (o.tangential_stiffness == 0.0) o.tangential_stiffness = o.normal_stiffness;
    return GRIT_OK;
}

grit_status read_surface(const grit_penalty_surface* given, const char* name,
                         grit_penalty_surface& s, grit_error* error) {
    GRIT_REQUIRE(given, "%s is null", name);
    GRIT_REQUIRE(read_versioned(given, s),
                 "%s: grit_penalty_surface.struct_size %zu is not understood: set it to sizeof",
                 name, given->struct_size);
    GRIT_REQUIRE(is_switch(s.closed), "%s: closed must be 0 or 1, got %d", name, s.closed);
    GRIT_REQUIRE(s.reserved == 0, "%s: reserved must be 0, got %d", name, s.reserved);
    GRIT_REQUIRE(s.count >= (s.closed ? 3 : 2) && s.count <= largest_count,
                 "%s: count must be at least %d vertices for %s line, got %td", name,
                 s.closed ? 3 : 2, s.closed ? "a closed" : "an open", s.count);
    GRIT_REQUIRE(s.position.base, "%s: position has no base pointer", name);
    return GRIT_OK;
}

grit_status check_output(const grit_mutable_view& view, const char* name, const char* member,
                         std::ptrdiff_t components, grit_error* error) {
    GRIT_REQUIRE(view.base, "%s: %s has no base pointer", name, member);
    GRIT_REQUIRE(view.point_stride != 0, "%s: %s is written: point_stride must not be 0", name,
                 member);
    GRIT_REQUIRE(components == 1 || view.component_stride != 0,
                 "%s: %s is written: component_stride must not be 0", name, member);
    return GRIT_OK;
}

grit_status check_motion(const grit_penalty_surface& s, const char* name,
                         const grit_penalty_options& o, grit_error* error) {
    const bool friction = o.friction_coefficient > 0.0;
    if (!o.validate_only)
        if (const grit_status bad = check_output(s.force, name, "force", 2, error)) return bad;
    if (s.stiffness.base)
        if (const grit_status bad = check_output(s.stiffness, name, "stiffness", 1, error))
            return bad;
    if (friction || s.history.base)
        if (const grit_status bad =
                check_output(s.history, name, "history", GRIT_PENALTY_HISTORY_SIZE, error))
            return bad;
    GRIT_REQUIRE(!friction || s.velocity.base,
                 "%s: velocity has no base pointer: friction needs it", name);
    for (std::ptrdiff_t i = 0; friction && i < s.count; ++i) {
        for (int c = 0; c < 2; ++c)
            if (const double v = component(s.velocity, i, c); !(std::fabs(v) <= 1e30))
                return failure(error, GRIT_BAD_STATE, i,
                               "%s vertex %td: velocity %d must be within +-1e30 (length / time), "
                               "got %g",
                               name, i, c, v);
        const double t_t = component(s.history, i, GRIT_PENALTY_TANGENTIAL_TRACTION);
        if (!(std::fabs(t_t) <= 1e90))
            return failure(error, GRIT_BAD_STATE, i,
                           "%s vertex %td: stored tangential traction must be within +-1e90 "
                           "(stress), got %g",
                           name, i, t_t);
        const double t_n = component(s.history, i, GRIT_PENALTY_NORMAL_TRACTION);
        if (!(t_n >= 0.0 && t_n <= 1e90))
            return failure(error, GRIT_BAD_STATE, i,
                           "%s vertex %td: stored normal traction must be in [0, 1e90] (stress), "
                           "got %g",
                           name, i, t_n);
    }
    return GRIT_OK;
}

}  // namespace grit::penalty
