// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/calibration_result.hpp"

#include <algorithm>

namespace cli {

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
        out.push_back({std::max(each.lowest, each.value(low[k])),
                       std::min(each.highest, each.value(high[k]))});
    }
    return out;
}

}  // namespace cli
