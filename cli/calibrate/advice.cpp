// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/advice.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cli {
namespace {

struct Remedy {
    const char* symbol;
    const char* test;
};
constexpr Remedy remedies[] = {
    {"phi_c", "the angle of repose, or a drained triaxial test of loose sand to 20 % and more"},
    {"h_s", "an oedometer or isotropic test of loose sand over a wide range of stress"},
    {"n", "an oedometer or isotropic test of loose sand over a wide range of stress"},
    {"e_d0", "the least void ratio, or drained triaxial tests of the densest sand"},
    {"e_c0", "the largest void ratio, or triaxial tests of loose sand to the critical state"},
    {"e_i0", "an oedometer or isotropic test of the loosest sand; or tie it to e_c0 by 1.15"},
    {"alpha", "a drained triaxial test of dense sand beyond its peak"},
    {"beta", "an oedometer test of dense sand"},
    {"p_t", "triaxial tests at low pressure"},
    {"m_R", "the stiffness at reversals of small strain: small cycles, or bender elements"},
    {"m_T", "small strains after a turn of 90 degrees of the path"},
    {"R", "the stiffness over strains of 1e-5 to 1e-3 after a reversal"},
    {"beta_r", "the stiffness over strains of 1e-5 to 1e-3 after a reversal"},
    {"chi", "the stiffness over strains of 1e-5 to 1e-3 after a reversal"},
};

std::string remedy_for(const std::string& symbol) {
    for (const Remedy& each : remedies)
        if (symbol == each.symbol) return each.test;
    return "another test";
}

}  // namespace

std::vector<std::string> advice(const calibration::ParameterSpace& space,
                                const calibration::Laplace& laplace) {
    std::vector<std::string> out;
    for (const calibration::Combination& each : laplace.combinations) {
        if (each.determined) continue;
        std::string names, tests;
        int count = 0;
        for (Eigen::Index k = 0; k < each.weights.size(); ++k) {
            if (!(std::abs(each.weights[k]) > calibration::share_that_counts)) continue;
            const std::string symbol =
                calibration::symbol_of(space.free[static_cast<std::size_t>(k)].index);
            names += (names.empty() ? "" : ", ") + symbol;
            const std::string test = remedy_for(symbol);
            if (tests.find(test) == std::string::npos)
                tests += (tests.empty() ? "" : "; or ") + test;
            ++count;
        }
        out.push_back(fmt::format("these tests do not determine {}{}: add {}",
                                  count > 1 ? "all of " : "", names, tests));
    }
    if (out.empty()) {
        const calibration::Combination& worst = laplace.combinations.back();
        out.push_back(fmt::format("these tests determine all {} parameters; the least known "
                                  "combination to {:.2g} % of its range",
                                  space.size(), 100.0 * worst.deviation));
    }
    return out;
}

}  // namespace cli
