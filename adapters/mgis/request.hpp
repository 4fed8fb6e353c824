// SPDX-License-Identifier: BSD-3-Clause
// K[0]: what the host asks for.
#pragma once

#include <grit/status.h>

#include "adapters/mgis/generic_behaviour.hpp"

namespace grit::mgis {

enum class Operator { none, elastic, secant, tangent, consistent };

struct Request {
    bool prediction;  // the operator at the start alone: nothing is integrated
    Operator wanted;
    bool speed_of_sound;
};

grit_status read_request(double code, Request& out, grit_error& error);

// Pointers that the sand needs for this request are there.
grit_status check_pointers(const mfront_gb_BehaviourData& call, const Request& request,
                           grit_error& error);

}  // namespace grit::mgis
