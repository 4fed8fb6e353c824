// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_update: checks the call, chooses the instruction set, words the failures.
#define GRIT_TARGET c_api
#include <cstring>

#include "support/instruction_set.hpp"
#include "support/require.hpp"
#include "support/versioned.hpp"
#include "support/views.hpp"
#include "umat/api/call.hpp"
#include "umat/batch/point.hpp"

namespace grit {
namespace {

grit_status check_options(const grit_sand_options& o, grit_error* error) {
    GRIT_REQUIRE(o.tolerance >= 1e-12 && o.tolerance <= 0.1,
                 "tolerance must be in [1e-12, 0.1], got %g", o.tolerance);
    GRIT_REQUIRE(o.evaluation_limit >= 2 && o.evaluation_limit <= 1000000,
                 "evaluation_limit must be in [2, 1000000], got %d", o.evaluation_limit);
    GRIT_REQUIRE(is_switch(o.intergranular_off), "intergranular_off must be 0 or 1, got %d",
                 o.intergranular_off);
    GRIT_REQUIRE(is_switch(o.stress_is_rotated), "stress_is_rotated must be 0 or 1, got %d",
                 o.stress_is_rotated);
    GRIT_REQUIRE(is_switch(o.validate_only), "validate_only must be 0 or 1, got %d",
                 o.validate_only);
    GRIT_REQUIRE(o.tangent >= GRIT_TANGENT_NONE && o.tangent <= GRIT_TANGENT_CONSISTENT,
                 "tangent must be GRIT_TANGENT_NONE, _CONTINUUM or _CONSISTENT, got %d", o.tangent);
    return check_instruction_set(o.instruction_set, error);
}

grit_status check_points(const grit_sand_points& q, const grit_sand_options& o, std::ptrdiff_t n,
                         grit_error* error) {
    GRIT_REQUIRE(q.components == 0 || q.components == 6 || q.components == 4,
                 "components must be 6 or 4 (11 22 33 12), got %d", q.components);
    GRIT_REQUIRE(q.reserved == 0, "grit_sand_points.reserved must be 0, got %d", q.reserved);
    GRIT_REQUIRE(q.strain_increment.base, "strain_increment has no base pointer");
    GRIT_REQUIRE(q.stress.base, "stress has no base pointer");
    GRIT_REQUIRE(q.state.base, "state has no base pointer");
    const struct {
        const grit_mutable_view& view;
        const char* name;
    } outputs[] = {{q.stress, "stress"}, {q.state, "state"}, {q.substep, "substep"}};
    for (const auto& output : outputs)
        if (const grit_status bad = check_written(output.view, n, output.name, "points", error))
            return bad;
    if (o.tangent != GRIT_TANGENT_NONE && !o.validate_only) {
        GRIT_REQUIRE(q.tangent.base, "tangent %d is asked for, but its view has no base pointer",
                     o.tangent);
        if (const grit_status bad = check_written(q.tangent, n, "tangent", "points", error))
            return bad;
        GRIT_REQUIRE(q.tangent.row_stride != 0 && q.tangent.column_stride != 0,
                     "tangent is written: row_stride and column_stride must not be 0");
    }
    GRIT_REQUIRE(q.stress.component_stride != 0 && q.state.component_stride != 0,
                 "component_stride of stress and state must not be 0");
    GRIT_REQUIRE(q.strain_increment.component_stride != 0,
                 "component_stride of strain_increment must not be 0");
    return GRIT_OK;
}

const char* component_name(int c) {
    static constexpr const char* names[] = {"11", "22", "33", "12", "13", "23"};
    return names[c];
}

int first_not_finite(const double* x, int n) {
    for (int c = 0; c < n; ++c)
        if (!(x[c] - x[c] == 0.0)) return c;
    return 0;
}

// Say in words what was found at a point, from the same numbers the kernel saw.
grit_status describe(const Material& m, const grit_sand_options& o, const grit_sand_points& q,
                     const UpdateOutcome& found, grit_error* error) {
    const grit_status status = status_of(found.fault);
    const std::ptrdiff_t i = found.point;
    const c_api::RawPoint raw = c_api::read_point(q, q.index ? q.index[i] : i);
    const auto say = [&](const char* format, auto... values) {
        return failure(error, status, i, format, i, values...);
    };
    const double increment = c_api::norm(c_api::strain_from_voigt(raw.strain));
    switch (found.fault) {
        case Fault::strain_not_finite: {
            const int c = first_not_finite(raw.strain, 6);
            return say("point %td: strain_increment %s must be finite, got %g", component_name(c),
                       raw.strain[c]);
        }
        case Fault::stress_not_finite: {
            const int c = first_not_finite(raw.stress, 6);
            return say("point %td: stress %s must be finite, got %g", component_name(c),
                       raw.stress[c]);
        }
        case Fault::state_not_finite: {
            const int c = first_not_finite(raw.state, GRIT_SAND_STATE_SIZE);
            return say("point %td: state component %d must be finite, got %g", c, raw.state[c]);
        }
        case Fault::substep_not_finite:
            return say("point %td: substep must be finite, got %g", raw.substep);
        case Fault::rotation_improper:
            return say("point %td: rotation_increment must be a proper orthogonal matrix%s, "
                       "determinant 1",
                       q.components == 4 ? " about axis 3" : "");
        case Fault::void_ratio_out_of_range:
            return say("point %td: void ratio must be in (0, %g], got %g",
                       c_api::largest_void_ratio, raw.state[GRIT_SAND_VOID_RATIO]);
        case Fault::separation_negative:
            return say("point %td: separation must be >= 0, got %g",
                       raw.state[GRIT_SAND_SEPARATION]);
        case Fault::h_out_of_plane:
            return say("point %td: h13 and h23 must be 0 with 4 components, got %g and %g",
                       raw.state[GRIT_SAND_H13], raw.state[GRIT_SAND_H23]);
        case Fault::h_too_long:
            return say("point %td: |h| must be at most R = %g, got %g", m.R,
                       c_api::norm(c_api::strain_from_voigt(raw.state)));
        case Fault::stress_too_large:
            return say("point %td: stress components must be within 10 h_s = %g: units?",
                       c_api::largest_stress_per_h_s * m.h_s);
        case Fault::turned_stress_too_large:
            return say("point %td: stress components must be within 10 h_s = %g after the rotation "
                       "increment too: units?",
                       c_api::largest_stress_per_h_s * m.h_s);
        case Fault::increment_too_large:
            return say(
                "point %td: |strain increment| must be at most %g, got %g: use smaller steps",
                c_api::largest_increment, increment);
        case Fault::void_ratio_leaves_range:
            return say(
                "point %td: the increment (volumetric strain %g) takes e = %g out of (0, 1e9]",
                raw.strain[0] + raw.strain[1] + raw.strain[2], raw.state[GRIT_SAND_VOID_RATIO]);
        case Fault::evaluation_limit:
            return say("point %td: not converged to tolerance %g after %d evaluations (limit %d), "
                       "%.3g of the increment of %g done: use smaller steps",
                       o.tolerance, found.evaluations, o.evaluation_limit, found.progress,
                       increment);
        case Fault::none: break;
    }
    return failure(error, GRIT_INTERNAL, i, "point %td: unknown fault", i);
}

}  // namespace
}  // namespace grit

using namespace grit;

extern "C" {

grit_status grit_sand_options_init(grit_sand_options* options, size_t struct_size) {
    return init_versioned(default_options, options, struct_size) ? GRIT_OK : GRIT_BAD_CALL;
}

grit_status grit_sand_update(const grit_sand* sand, const grit_sand_options* options, ptrdiff_t n,
                             const grit_sand_points* points, grit_sand_report* reports,
                             grit_error* error) {
    SandCall call;
    if (const grit_status s = read_call("grit_sand_update", sand, options, n, points, call, error))
        return s;
    const grit_sand_options& o = *call.options;
    const grit_sand_points& q = *call.points;
    if (const grit_status s = check_options(o, error)) return s;
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    if (const grit_status s = check_points(q, o, n, error)) return s;

    const Material& m = material_of(*sand);
    const bool igs = m.has_intergranular_strain != 0.0 && !o.intergranular_off;
    const UpdateRequest request{&m, &o, &q, n, reports, igs};
    const UpdateOutcome outcome = GRIT_DISPATCH(o.instruction_set, update(request));
    return outcome.fault == Fault::none ? GRIT_OK : describe(m, o, q, outcome, error);
}
}
