// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/axis.hpp"

namespace cli {

const Axis* axis_of(const std::string& column) {
    using namespace axis;
    for (const Axis* each : {&eps_a, &eps_v, &q, &p, &e, &pw, &phi, &sigma_a, &gamma_12, &tau_12,
                             &sigma_n, &gamma, &tau})
        if (column == each->column) return each;
    return nullptr;
}

}  // namespace cli
