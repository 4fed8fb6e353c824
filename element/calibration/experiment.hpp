// SPDX-License-Identifier: BSD-3-Clause
// A test of a laboratory: how the sample started, what was done to it and what was read.
#pragma once

#include <string>
#include <vector>

#include "element/linear_quantity.hpp"
#include "element/simulate.hpp"
#include "element/start.hpp"

namespace calibration {

// What a column of readings is.
struct Channel {
    std::string name, unit;  // "axial_deviator", "kPa"
    element::LinearQuantity quantity;
    bool change = false;  // since the first row: strains, pore pressure
};

struct Reading {
    int row = 0;      // of the rows that are followed, from 0: where they begin
    int channel = 0;  // of Experiment::channels
    double value = 0.0;
    double error = 1.0;  // standard deviation
};

struct Experiment {
    std::string name, kind;  // "TMD7", "triaxial_drained"
    element::GritLawOptions options;
    element::Settings settings;
    // At rest: stress[0] is given, the lateral stress is 1 - sin phi_c of it. At zero pressure: the void ratio is
    // e_0 of (H6).
    element::Start start;
    bool at_rest = false, at_zero_pressure = false;
    double void_ratio_error = 0.0;  // standard deviation of the void ratio at the start
    // The last step leads from row to row and records each increment; those before prepare the sample.
    element::Program program;
    std::vector<int> records;    // of that step, in which a row is reached; 0: where it begins
    std::vector<double> driven;  // what drives the test, a value per row, in the signs of Grit
    std::string driver;          // what that is: "axial_strain", "stress_11"
    std::vector<Channel> channels;
    std::vector<Reading> readings;
    double independent = 0.0;  // what the readings count as, 0: their number
    bool fitted = true;        // otherwise held out
};

struct Prediction {
    Eigen::VectorXd values;   // a row per reading
    element::MatrixX slopes;  // a column per direction, none without
    std::string failure;      // empty: all of it could be computed
};

// What would be read from a sand with these parameters. Parameters or starts that the law refuses are failures too.
Prediction predict(const Experiment& experiment, const grit_sand_parameters& parameters,
                   const element::Directions& by = {});

}  // namespace calibration
