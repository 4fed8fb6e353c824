// SPDX-License-Identifier: BSD-3-Clause
// The residuals of all tests: (computed - measured)/error.
#pragma once

#include <functional>
#include <optional>

#include "element/calibration/experiment.hpp"
#include "element/calibration/parameter_space.hpp"

namespace calibration {

// A parameter that was measured by itself, as phi_c by the angle of repose.
struct Direct {
    int index = 0;
    double value = 0.0, error = 1.0;  // standard deviation
};

struct Residuals {
    Vector values;
    Matrix slopes;  // by the coordinates; no rows unless asked for
};

class Problem {
  public:
    // Experiments that are held out are left aside. threads >= 1 change no result.
    Problem(ParameterSpace space, std::vector<Experiment> experiments, std::vector<Direct> direct,
            int threads);

    const ParameterSpace& space() const { return parameters; }
    const std::vector<Experiment>& experiments() const { return tests; }
    int threads() const { return workers; }
    // Of the fitted experiments and the direct measurements.
    Eigen::Index rows() const { return row_count; }
    // What all of them count as, where neighbouring readings are not independent.
    double independent() const;

    // Nothing where an experiment cannot be computed; why then says which and why.
    std::optional<Residuals> residuals(const Vector& x, bool with_slopes,
                                       std::string* why = nullptr) const;
    // Sum of rho(r^2), one test after the other in this thread; nothing as soon as it exceeds the limit, or where an
    // experiment cannot be computed.
    using Loss = std::function<double(double)>;
    std::optional<double> sum(const Vector& x, double limit, const Loss& rho) const;

    // An error of the void ratio at the start moves all readings of a test together: from now on they are weighed
    // with that, as linear as it is at x. False where no test has any.
    bool weigh_starts(const Vector& x);

  private:
    Vector weighed(std::size_t experiment, const Vector& values) const;
    // What a prediction of a fitted experiment leaves, weighed.
    Vector left(std::size_t experiment, const Vector& predicted) const;
    void add_direct(const Vector& x, Residuals& out) const;

    ParameterSpace parameters;
    std::vector<Experiment> tests;
    std::vector<Direct> measured;
    int workers;
    Eigen::Index row_count = 0;
    std::vector<std::size_t> fitted;   // of tests
    std::vector<Eigen::Index> begins;  // of their rows
    std::vector<Vector> readings;      // ... and
    std::vector<Vector> scales;        // 1/error of each
    std::vector<Vector> common;        // of each: what weigh_starts has found, empty: nothing
};

// work(i) for i = 0 ... count - 1, in so many threads, or fewer if the system gives no more. Throws what the lowest threw.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace calibration
