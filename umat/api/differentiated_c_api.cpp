// SPDX-License-Identifier: BSD-3-Clause
#include <grit/sand_derivatives.h>

#include <utility>

#include "support/instruction_set.hpp"
#include "umat/api/update_call.hpp"

namespace grit {
namespace {

grit_status check_parameters(const grit_sand_derivatives& d, bool igs, grit_error* error) {
    for (int k = 0; d.parameters && k < d.count; ++k) {
        const int index = d.parameters[k];
        if (index == GRIT_SAND_NO_PARAMETER) continue;
        const grit_sand_parameter_info* const info = grit_sand_parameter_describe(index);
        GRIT_REQUIRE(info, "parameter %d of the derivatives must be in [0, %d), or -1, got %d", k,
                     GRIT_SAND_PARAMETER_COUNT, index);
        GRIT_REQUIRE(igs || info->optional != 2,
                     "parameter %d of the derivatives is %s (%s), which an update without "
                     "intergranular strain does not use",
                     k, info->name, info->symbol);
    }
    return GRIT_OK;
}

grit_status check_derivatives(const grit_sand_derivatives& d, const UpdateRequest& request,
                              grit_error* error) {
    GRIT_REQUIRE(d.count >= 1 && d.count <= GRIT_SAND_LARGEST_DIRECTION_COUNT,
                 "count of the derivatives must be in [1, %d], got %d",
                 GRIT_SAND_LARGEST_DIRECTION_COUNT, d.count);
    GRIT_CHECK(check_reserved(d.reserved, "grit_sand_derivatives.reserved", error));
    GRIT_CHECK(check_parameters(d, request.igs, error));
    for (const auto& [view, name] :
         {std::pair{&d.stress, "derivatives: stress"}, std::pair{&d.state, "derivatives: state"}}) {
        GRIT_CHECK(check_base(*view, name, error));
        GRIT_CHECK(check_written(*view, request.n, name, "points", error));
        GRIT_CHECK(check_entries_written(*view, name, error));
    }
    if (d.strain_increment.base)
        GRIT_CHECK(check_usable(d.strain_increment, "derivatives: strain_increment", error));
    return GRIT_OK;
}

}  // namespace
}  // namespace grit

using namespace grit;

extern "C" grit_status grit_sand_update_differentiated(const grit_sand* sand,
                                                       const grit_sand_options* options,
                                                       const grit_sand_derivatives* derivatives,
                                                       ptrdiff_t n, const grit_sand_points* points,
                                                       grit_sand_report* reports,
                                                       grit_error* error) {
    constexpr char name[] = "grit_sand_update_differentiated";
    static constexpr grit_sand_derivatives nothing{};
    SandCall call;
    grit_sand_derivatives own;
    GRIT_CHECK(read_call(name, sand, options, n, points, call, error));
    GRIT_CHECK(check_given(derivatives, {name, "derivatives"}, error));
    const grit_sand_derivatives* const d = view_versioned(derivatives, nothing, own);
    GRIT_CHECK(check_understood(d, derivatives, "grit_sand_derivatives", set_it_to_sizeof, error));
    GRIT_REQUIRE(
        call.options->tangent != GRIT_TANGENT_CONSISTENT,
        "tangent must be GRIT_TANGENT_NONE or _CONTINUUM beside derivatives: directions of "
        "strain give the consistent one");
    GRIT_CHECK(check_update(call, n, error));
    if (n == 0) return GRIT_OK;
    const UpdateRequest request = request_of(*sand, call, n, reports);
    GRIT_CHECK(check_derivatives(*d, request, error));
    const DifferentiationRequest both{&request, d};
    const UpdateOutcome outcome =
        GRIT_DISPATCH(call.options->instruction_set, update_differentiated(both));
    return outcome.fault == Fault::none ? GRIT_OK : describe(request, outcome, error);
}
