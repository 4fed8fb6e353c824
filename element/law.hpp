// SPDX-License-Identifier: BSD-3-Clause
// What the driver knows of a constitutive law: one point advances over one increment.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "element/slopes.hpp"

namespace element {

// Stress and state variables as the law keeps them between two increments.
struct MaterialPoint {
    Vector6 stress = Vector6::Zero();  // effective, unless the law carries pore water itself
    std::vector<double> state;
};

// Times are those at the start of the increment.
struct StrainIncrement {
    Vector6 strain = Vector6::Zero();               // in the configuration at the end
    Matrix3 rotation = Matrix3::Identity();         // from the start to the end, proper orthogonal
    Vector6 total_strain = Vector6::Zero();         // at the start, rotated to the end
    Matrix3 gradient_before = Matrix3::Identity();  // deformation gradient F at the start
    Matrix3 gradient_after = Matrix3::Identity();   // and at the end
    double step_time = 0.0, total_time = 0.0, duration = 0.0;
    double temperature = 0.0, temperature_change = 0.0;
    int step = 1, number = 1;  // KSTEP and KINC of a UMAT, from 1
};

enum class Outcome {
    done,
    retry_smaller,  // the increment is too large: reduction suggests how much of it may work
    hopeless        // a smaller increment will not help: parameters or state are wrong
};

struct Response {
    Outcome outcome = Outcome::done;
    double reduction = 1.0;             // (0, 1] of the increment
    std::string message;                // why not done: value, limit, unit
    MaterialPoint end;                  // meaningful if done
    Matrix6 tangent = Matrix6::Zero();  // d stress / d strain increment, unsymmetric, if done
    int evaluations = 0;                // of the rate, 0 if the law does not say
    bool stress_free = false;           // the point has separated
};

// Of a point, for records; NaN where the law does not know.
struct Observation {
    double void_ratio = std::numeric_limits<double>::quiet_NaN();     // e [-]
    double pore_pressure = std::numeric_limits<double>::quiet_NaN();  // carried by the law [stress]
};

struct ObservedSlopes {
    Eigen::RowVectorXd void_ratio, pore_pressure;  // a column per direction
};

// Immutable: a law may be shared by runs in several threads (a UMAT if its library allows it).
class Law {
  public:
    Law() = default;
    Law(const Law&) = default;
    Law& operator=(const Law&) = default;
    virtual ~Law() = default;

    // start is not changed. The law rotates stress and state by increment.rotation, then strains.
    virtual Response advance(const MaterialPoint& start,
                             const StrainIncrement& increment) const = 0;

    // advance without a tangent and, in place, derivatives along directions: a column per parameter, then one per
    // column of strain_slopes that is left, which has none. They have columns for all of them. Throws BadCase where
    // a law has no derivatives.
    virtual Response differentiate(const MaterialPoint& start, const StrainIncrement& increment,
                                   const Directions& parameters, const Matrix6X& strain_slopes,
                                   PointSlopes& slopes) const;

    virtual Observation observe(const MaterialPoint& point) const = 0;

    // Its derivatives. Throws BadCase where a law has none.
    virtual ObservedSlopes observe(const MaterialPoint& point, const PointSlopes& slopes) const;

    // One name per state variable: names of columns.
    virtual const std::vector<std::string>& state_names() const = 0;
};

}  // namespace element
