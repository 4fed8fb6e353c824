// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/loss.hpp"

#include <ceres/loss_function.h>

namespace calibration {

Loss::Loss(const std::string& word, double scale) {
    if (word == "huber") rho = std::make_shared<ceres::HuberLoss>(scale);
    if (word == "soft_l1") rho = std::make_shared<ceres::SoftLOneLoss>(scale);
    if (word == "cauchy") rho = std::make_shared<ceres::CauchyLoss>(scale);
}

const std::vector<std::string>& Loss::words() {
    static const std::vector<std::string> all = {"squares", "huber", "soft_l1", "cauchy"};
    return all;
}

double Loss::operator()(double square) const {
    if (!rho) return square;
    double out[3];
    rho->Evaluate(square, out);
    return out[0];
}

}  // namespace calibration
