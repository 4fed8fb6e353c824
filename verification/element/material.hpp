// SPDX-License-Identifier: BSD-3-Clause
// The sand of a case as one material point.
#pragma once

#include <array>

#include "element/case.hpp"

namespace element {

struct Point {
    Vector6 stress = Vector6::Zero();
    Vector6 strain = Vector6::Zero();  // since the start
    std::array<double, GRIT_SAND_STATE_SIZE> state{};
    double substep = 0.0;
};

struct UpdateResult {
    grit_status status = GRIT_OK;
    int evaluations = 0;
    bool stress_free = false;  // separated or below the pressure floor of the library
    std::string message;
};

class Material {
  public:
    // Throws BadCase for parameters the library refuses.
    explicit Material(const Case& test);

    // Throws BadCase for a start the sand cannot be in.
    Point start(const Start& start) const;

    // Point, untouched unless the result is GRIT_OK, over a strain increment; tangent consistent.
    UpdateResult update(const Vector6& strain_increment, Point& point, Matrix6& tangent) const;

    grit_sand_invariants invariants(const Point& point) const;

  private:
    double start_void_ratio(const Start& start) const;

    grit_sand sand{};
    grit_sand_options options{};
};

}  // namespace element
