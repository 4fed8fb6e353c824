// SPDX-License-Identifier: BSD-3-Clause
// What large residuals cost: rho(r^2), r over its standard deviation.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace ceres {
class LossFunction;
}

namespace calibration {

class Loss {
  public:
    // "squares", "huber", "soft_l1" or "cauchy"; beyond about the scale, residuals count less than their squares.
    explicit Loss(const std::string& word, double scale = 2.0);
    Loss() = default;  // squares

    static const std::vector<std::string>& words();
    double operator()(double square) const;
    const ceres::LossFunction* function() const { return rho.get(); }  // null: squares

  private:
    std::shared_ptr<const ceres::LossFunction> rho;
};

}  // namespace calibration
