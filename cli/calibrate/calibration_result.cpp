// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/calibration_result.hpp"

#include <algorithm>

namespace cli {
namespace {

// Void ratios in their order.
void limit_by_order(int index, const grit_sand_parameters& best, double& lowest, double& highest) {
    const std::string symbol = calibration::symbol_of(index);
    if (symbol == "e_d0") highest = std::min(highest, best.critical_void_ratio);
    if (symbol == "e_c0") {
        lowest = std::max(lowest, best.densest_void_ratio);
        highest = std::min(highest, best.loosest_void_ratio);
    }
    if (symbol == "e_i0") lowest = std::max(lowest, best.critical_void_ratio);
}

}  // namespace

std::vector<ParameterInterval> intervals(const calibration::ParameterSpace& space,
                                         const CalibrationResult& result) {
    const calibration::Vector low =
        result.posterior ? result.posterior->quantile(0.025)
                         : result.fit.x - normal_quantile_975 * result.laplace.deviation;
    const calibration::Vector high =
        result.posterior ? result.posterior->quantile(0.975)
                         : result.fit.x + normal_quantile_975 * result.laplace.deviation;
    std::vector<ParameterInterval> out;
    for (Eigen::Index k = 0; k < space.size(); ++k) {
        const calibration::FreeParameter& each = space.free[static_cast<std::size_t>(k)];
        double lowest = each.lowest, highest = each.highest;
        if (!result.posterior) limit_by_order(each.index, result.best, lowest, highest);
        ParameterInterval one{std::max(lowest, each.value(low[k])),
                              std::min(highest, each.value(high[k])), false};
        const double least = each.coordinate(each.lowest), most = each.coordinate(each.highest);
        const double near = 0.01 * (most - least);
        one.ends_at_bound = each.coordinate(one.lowest) < least + near ||
                            each.coordinate(one.highest) > most - near;
        out.push_back(one);
    }
    return out;
}

}  // namespace cli
