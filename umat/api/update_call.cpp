// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET c_api
#include "umat/api/update_call.hpp"

#include "support/instruction_set.hpp"
#include "umat/batch/point.hpp"

namespace grit {
namespace {

grit_status check_options(const grit_sand_options& o, grit_error* error) {
    GRIT_REQUIRE(o.tolerance >= GRIT_SAND_LEAST_TOLERANCE &&
                     o.tolerance <= GRIT_SAND_LARGEST_TOLERANCE,
                 "tolerance must be in [%g, %g], got %g", GRIT_SAND_LEAST_TOLERANCE,
                 GRIT_SAND_LARGEST_TOLERANCE, o.tolerance);
    GRIT_REQUIRE(o.evaluation_limit >= GRIT_SAND_LEAST_EVALUATION_LIMIT &&
                     o.evaluation_limit <= GRIT_SAND_LARGEST_EVALUATION_LIMIT,
                 "evaluation_limit must be in [%d, %d], got %d", GRIT_SAND_LEAST_EVALUATION_LIMIT,
                 GRIT_SAND_LARGEST_EVALUATION_LIMIT, o.evaluation_limit);
    GRIT_CHECK(check_switch(o.intergranular_off, "intergranular_off", error));
    GRIT_CHECK(check_switch(o.stress_is_rotated, "stress_is_rotated", error));
    GRIT_CHECK(check_switch(o.validate_only, "validate_only", error));
    GRIT_REQUIRE(o.tangent >= GRIT_TANGENT_NONE && o.tangent <= GRIT_TANGENT_CONSISTENT,
                 "tangent must be GRIT_TANGENT_NONE, _CONTINUUM or _CONSISTENT, got %d", o.tangent);
    return check_instruction_set(o.instruction_set, error);
}

grit_status check_views(const grit_sand_points& q, const grit_sand_options& o, std::ptrdiff_t n,
                        grit_error* error) {
    GRIT_CHECK(check_point_components(q.components, error));
    GRIT_CHECK(check_reserved(q.reserved, "grit_sand_points.reserved", error));
    GRIT_CHECK(check_base(q.strain_increment, "strain_increment", error));
    GRIT_CHECK(check_base(q.stress, "stress", error));
    GRIT_CHECK(check_base(q.state, "state", error));
    GRIT_CHECK(check_written(q.stress, n, "stress", "points", error));
    GRIT_CHECK(check_written(q.state, n, "state", "points", error));
    GRIT_CHECK(check_written(q.substep, n, "substep", "points", error));
    if (o.tangent != GRIT_TANGENT_NONE && !o.validate_only) {
        GRIT_REQUIRE(q.tangent.base, "tangent %d is asked for, but its view has no base pointer",
                     o.tangent);
        GRIT_CHECK(check_written(q.tangent, n, "tangent", "points", error));
        GRIT_CHECK(check_entries_written(q.tangent, "tangent", error));
    }
    GRIT_CHECK(check_component_strides({q.stress.component_stride, q.state.component_stride},
                                       "stress and state", error));
    return check_component_strides({q.strain_increment.component_stride}, "strain_increment",
                                   error);
}

const char* component_name(int c) {
    static constexpr const char* names[] = {"11", "22", "33", "12", "13", "23"};
    return names[c];
}

}  // namespace

grit_status check_update(const SandCall& call, std::ptrdiff_t n, grit_error* error) {
    GRIT_CHECK(check_options(*call.options, error));
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    return check_views(*call.points, *call.options, n, error);
}

UpdateRequest request_of(const grit_sand& sand, const SandCall& call, std::ptrdiff_t n,
                         grit_sand_report* reports) {
    const Material& m = material_of(sand);
    const bool igs = m.has_intergranular_strain != 0.0 && !call.options->intergranular_off;
    return {&m, call.options, call.points, n, reports, igs};
}

UpdateOutcome run(const UpdateRequest& request) {
    return GRIT_DISPATCH(request.options->instruction_set, update(request));
}

grit_status describe(const UpdateRequest& request, const UpdateOutcome& found, grit_error* error) {
    const Material& m = *request.material;
    const grit_sand_options& o = *request.options;
    const grit_sand_points& q = *request.points;
    const grit_status status = status_of(found.fault);
    const std::ptrdiff_t i = q.index ? q.index[found.point] : found.point;
    const c_api::RawPoint raw = c_api::read_point(q, i);
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
        case Fault::derivative_not_finite:
            return say(
                "point %td: derivatives of stress, state and strain increment must be finite");
        case Fault::derivative_leaves_range:
            return say(
                "point %td: the derivatives of the increment of %g are not finite: use smaller "
                "steps",
                increment);
        case Fault::increment_too_large:
            return say(
                "point %td: |strain increment| must be at most %g, got %g: use smaller steps",
                c_api::largest_increment, increment);
        case Fault::void_ratio_leaves_range:
            return say(
                "point %td: the increment (volumetric strain %g) takes e = %g out of (0, 1e9]",
                raw.strain[0] + raw.strain[1] + raw.strain[2], raw.state[GRIT_SAND_VOID_RATIO]);
        case Fault::stress_leaves_range:
            return say("point %td: the increment of %g takes the stress out of 10 h_s = %g: use "
                       "smaller steps",
                       increment, c_api::largest_stress_per_h_s * m.h_s);
        case Fault::evaluation_limit:
            return say("point %td: not converged to tolerance %g after %d evaluations (limit %d), "
                       "%.3g of the increment of %g done: use smaller steps",
                       o.tolerance, found.evaluations, o.evaluation_limit, found.progress,
                       increment);
        case Fault::none: break;
    }
    return failure(error, GRIT_INTERNAL, i, "point %td: unknown fault", i);
}

}  // namespace grit
