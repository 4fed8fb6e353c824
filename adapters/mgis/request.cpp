// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mgis/request.hpp"

#include <cmath>

#include "adapters/host/failure.hpp"

namespace grit::mgis {

grit_status read_request(double code, Request& out, grit_error& error) {
    if (!std::isfinite(code))
        return failure(error, GRIT_BAD_CALL,
                       "K[0] must be in -3 ... 4, or 100 more for the speed of sound, got %g",
                       code);
    out.speed_of_sound = code > 50.0;
    const double kind = out.speed_of_sound ? code - 100.0 : code;
    out.prediction = kind < -0.5;
    const double size = std::fabs(kind);
    if (size <= 0.5) out.wanted = Operator::none;
    else if (size < 1.5) out.wanted = Operator::elastic;
    else if (size < 2.5) out.wanted = Operator::secant;
    else if (out.prediction || size < 3.5) out.wanted = Operator::tangent;
    else out.wanted = Operator::consistent;
    return GRIT_OK;
}

grit_status check_pointers(const mfront_gb_BehaviourData& call, const Request& request,
                           grit_error& error) {
    const struct {
        bool missing;
        const char* name;
    } pointers[] = {
        {!call.s0.gradients, "s0.gradients"},
        {!call.s1.gradients, "s1.gradients"},
        {!call.s0.thermodynamic_forces, "s0.thermodynamic_forces"},
        {!call.s1.thermodynamic_forces && !request.prediction, "s1.thermodynamic_forces"},
        {!call.s0.internal_state_variables, "s0.internal_state_variables"},
        {!call.s1.internal_state_variables && !request.prediction, "s1.internal_state_variables"},
        {!call.s1.material_properties, "s1.material_properties"},
        {!call.speed_of_sound && request.speed_of_sound, "speed_of_sound"},
        {!call.s1.mass_density && request.speed_of_sound, "s1.mass_density"},
    };
    for (const auto& pointer : pointers)
        if (pointer.missing)
            return failure(error, GRIT_BAD_CALL, "%s is a null pointer", pointer.name);
    return GRIT_OK;
}

}  // namespace grit::mgis
