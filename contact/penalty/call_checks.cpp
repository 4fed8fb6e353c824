// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty/call_checks.hpp"

namespace grit::penalty {

grit_status read_options(const grit_penalty_options* given, grit_penalty_options& o,
                         grit_error* error) {
    GRIT_REQUIRE(given, "options is null: normal_stiffness and depth_max have no default");
    GRIT_CHECK(read_struct(given, o, "grit_penalty_options", error,
                           "call grit_penalty_options_init first"));
    GRIT_CHECK(check_switch(o.axisymmetric, "axisymmetric", error));
    GRIT_CHECK(check_switch(o.validate_only, "validate_only", error));
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

grit_status check_vertex_count(std::ptrdiff_t count, bool closed, Named about, grit_error* error) {
    const int least = closed ? 3 : 2;
    GRIT_REQUIRE_OF(about, count >= least && count <= largest_count,
                    " must be at least %d vertices for %s line, got %td", least,
                    closed ? "a closed" : "an open", count);
    return GRIT_OK;
}

grit_status read_surface(const grit_penalty_surface* given, const char* name,
                         grit_penalty_surface& s, grit_error* error) {
    GRIT_CHECK(check_given(given, name, error));
    GRIT_CHECK(read_struct(given, s, {name, "grit_penalty_surface"}, error));
    GRIT_CHECK(check_switch(s.closed, {name, "closed"}, error));
    GRIT_CHECK(check_reserved(s.reserved, {name, "reserved"}, error));
    GRIT_CHECK(check_vertex_count(s.count, s.closed, {name, "count"}, error));
    return check_vectors(s.position, {name, "position"}, error);
}

grit_status check_motion(const grit_penalty_surface& s, const char* name,
                         const grit_penalty_options& o, grit_error* error) {
    const bool friction = o.friction_coefficient > 0.0;
    if (!o.validate_only) GRIT_CHECK(check_output(s.force, 2, {name, "force"}, error));
    if (s.stiffness.base) GRIT_CHECK(check_output(s.stiffness, 1, {name, "stiffness"}, error));
    if (friction || s.history.base)
        GRIT_CHECK(check_output(s.history, GRIT_PENALTY_HISTORY_SIZE, {name, "history"}, error));
    if (friction)
        GRIT_CHECK(check_vectors(s.velocity, {name, "velocity"}, error, ": friction needs it"));
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
