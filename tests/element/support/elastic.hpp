// SPDX-License-Identifier: BSD-3-Clause
// A law whose answers are known by hand.
#pragma once

#include <element/exit_condition.hpp>
#include <element/law.hpp>

namespace tests {

// Isotropic elasticity; state: the number of increments. Fails where it is told to.
class Elastic : public element::Law {
  public:
    explicit Elastic(double E = 1000.0, double nu = 0.25) {
        const double G = E / (2.0 * (1.0 + nu)), lambda = 2.0 * G * nu / (1.0 - 2.0 * nu);
        C.topLeftCorner<3, 3>().setConstant(lambda);
        for (int i = 0; i < 6; ++i) C(i, i) += i < 3 ? 2.0 * G : G;
    }

    element::Response advance(const element::MaterialPoint& start,
                              const element::StrainIncrement& increment) const override {
        element::Response out;
        out.end = start;
        if (increment.strain.norm() > largest_increment && start.state[0] < hard_increments) {
            out.outcome = element::Outcome::retry_smaller;
            out.reduction = 0.5;
            out.message = "increment must be small";
        }
        const element::Matrix3& Q = increment.rotation;
        out.end.stress =
            element::stress_components(Q * element::stress_tensor(start.stress) * Q.transpose());
        out.end.stress += C * increment.strain;
        out.end.state[0] += 1.0;
        if (out.end.stress.norm() > strength) {
            out.outcome = element::Outcome::hopeless;
            out.message = "stress must be <= strength";
        }
        out.tangent = C;
        out.evaluations = 1;
        return out;
    }
    element::Observation observe(const element::MaterialPoint&) const override { return {}; }
    const std::vector<std::string>& state_names() const override { return names; }

    element::Matrix6 C = element::Matrix6::Zero();
    double largest_increment = 1e300;
    double hard_increments = 1e300;  // the first so many know a largest increment
    double strength = 1e300;

  private:
    std::vector<std::string> names{"increments"};
};

// A condition in the words of incrementalDriver.
inline element::Condition when(const std::string& text) {
    return element::parse_condition(text, element::incremental_driver_words({"increments"}));
}

inline element::MaterialPoint elastic_point() { return {element::Vector6::Zero(), {0.0}}; }

}  // namespace tests
