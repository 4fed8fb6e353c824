// SPDX-License-Identifier: BSD-3-Clause
// The single calls through umat_ of any library.
#pragma once

#include <string>
#include <vector>

#include "element/umat_function.hpp"
#include "single_calls.hpp"
#include "umat_layout.hpp"

namespace benchmarks {

// umat_, UMAT or umat of the library, which stays loaded. Symbols that it lacks, such as routines of
// Abaqus, are looked for when they are called. Throws std::runtime_error.
element::UmatFunction open_umat(const std::string& library);

// Points as a host has them.
struct UmatPoints {
    std::vector<double> dstran, stress, statev, ddsdde, pnewdt;

    UmatPoints(const std::vector<Call>& calls, const UmatLayout& layout);
    std::size_t size() const { return pnewdt.size(); }
};

// All points, one by one; without the tangent DDSDDE is null.
void run_umat(element::UmatFunction umat, UmatLayout& layout, bool tangent, UmatPoints& points);

// A call has failed if it leaves the stress as it was, is not finite or asks for a smaller increment.
std::vector<Outcome> outcomes_of(const std::vector<Call>& calls, const UmatLayout& layout,
                                 const UmatPoints& points);

}  // namespace benchmarks
