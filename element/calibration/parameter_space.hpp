// SPDX-License-Identifier: BSD-3-Clause
// The parameters that are sought, and the coordinates in which they are: the logarithm where a parameter goes over
// decades, itself otherwise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <grit/grit.h>

#include "element/slopes.hpp"

namespace calibration {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// Indices are those of grit_sand_parameter_describe, values in the units of the library.
struct FreeParameter {
    int index = 0;
    double lowest = 0.0, highest = 0.0;

    bool logarithmic() const;
    double coordinate(double value) const;
    double value(double coordinate) const;
};

// One parameter is a multiple of another.
struct Tie {
    int index = 0, to = 0;
    double factor = 1.0;
};

struct ParameterSpace {
    grit_sand_parameters base{};  // what is not sought
    std::vector<FreeParameter> free;
    std::vector<Tie> ties;

    Eigen::Index size() const { return static_cast<Eigen::Index>(free.size()); }
    grit_sand_parameters at(const Vector& x) const;
    Vector coordinates(const grit_sand_parameters& parameters) const;
    Vector lowest() const;
    Vector highest() const;
    bool contains(const Vector& x) const;
    // Free and tied parameters, in this order: by what a test is differentiated ...
    element::Directions directions() const;
    // ... and what these change by per coordinate: a row per direction.
    Matrix chain(const Vector& x) const;
    // Place of a parameter among the free ones.
    std::optional<Eigen::Index> find(int index) const;
};

double get(const grit_sand_parameters& parameters, int index);
void set(grit_sand_parameters& parameters, int index, double value);
// Of a symbol ("phi_c") or a name ("critical_friction_angle"), -1: none.
int parameter_index(const std::string& word);
std::string symbol_of(int index);

}  // namespace calibration
