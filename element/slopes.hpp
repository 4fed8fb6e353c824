// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of what a sample is, by parameters of its law and by how it started: a column per direction.
#pragma once

#include <vector>

#include "element/vectors.hpp"

namespace element {

// A direction: the number of a parameter, as grit_sand_parameter_describe counts them, or the void ratio at the start.
inline constexpr int by_void_ratio = -1;
using Directions = std::vector<int>;

using Matrix6X = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;
using MatrixX = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Of stress and state variables as the law keeps them.
struct PointSlopes {
    Matrix6X stress;
    MatrixX state;
};

// Of a sample.
struct Slopes {
    Directions by;  // empty: nothing is differentiated
    PointSlopes point;
    Matrix6X strain;                   // total
    Eigen::RowVectorXd pore_pressure;  // kept by the driver

    bool wanted() const { return !by.empty(); }
};

// Of a record: columns as in Slopes::by.
struct RecordSlopes {
    Matrix6X strain, stress, effective_stress, total_stress;
    MatrixX state;
    Eigen::RowVectorXd void_ratio, pore_pressure;  // 0 where the law does not know
};

}  // namespace element
