// SPDX-License-Identifier: BSD-3-Clause
// A program of steps: what is done to a sample.
#pragma once

#include <cstdint>
#include <variant>

#include "element/control.hpp"
#include "element/exit_condition.hpp"

namespace element {

// c grows in proportion from 0 to change.
struct Linear {
    Restrictions rows;
    Vector6 change = Vector6::Zero();
    // A row that is absolute takes its change as the value to be reached by
    // stress * sigma + strain * eps, wherever the sample is when the step begins.
    std::array<bool, 6> absolute{};
};

// c_r(x) = amplitude_r [sin(2 pi cycles x + phase_r) - sin(phase_r)] + drift_r x, x = 0 ... 1.
struct Circulating {
    Restrictions rows;
    Vector6 amplitude = Vector6::Zero();
    Vector6 phase = Vector6::Zero();  // [rad]
    Vector6 drift = Vector6::Zero();  // over the whole step
    double cycles = 1.0;
    // incrementalDriver takes the rate in the middle of each increment instead of the difference:
    // its amplitude is larger by x/sin x, x = pi cycles/increments.
    bool rate_at_midpoint = false;
};

// Strain and rotation from a deformation gradient that starts from F = 1 in each such step.
struct DeformationGradient {
    Matrix3 F = Matrix3::Identity();  // at the end, det F > 0
    enum class Path {
        linear,               // 1 + x (F - 1), as incrementalDriver
        stretch_and_rotation  // R^x U^x of F = R U: a pure rotation never strains
    } path = Path::stretch_and_rotation;
    enum class Increments {
        polar,         // exact: F_1 F_0^-1 = V R, strain increment ln V, rotation R
        hughes_winget  // midpoint rule of Hughes & Winget (1980), as incrementalDriver
    } increments = Increments::polar;
};

// c follows a table: row r takes factor * (its column - its first value). The table's rows are the
// increments; Step::increments is not used.
struct Imported {
    Restrictions rows;
    std::vector<std::vector<double>> table;
    struct Column {
        int index = -1;  // from 0, -1: c stays 0
        double factor = 1.0;
    };
    std::array<Column, 6> columns{};
    Column time;  // index -1: Step::duration divided evenly
};

// Response envelopes: each increment is a probe  c = cos(a) first + sin(a) second,
// a = 2 pi (i - 1)/increments, recorded and then undone.
struct Perturbations {
    Restrictions rows;
    Vector6 first = Vector6::Zero();
    Vector6 second = Vector6::Zero();
};

// Each increment is uniform in [-amplitude, amplitude], the same on every machine for one seed.
struct RandomWalk {
    Restrictions rows;
    Vector6 amplitude = Vector6::Zero();  // of one increment
    std::uint64_t seed = 1;
};

struct Step;

// Its steps one after another. Step::exit ends the repetition, whichever of its steps is going on;
// nothing else of the step that a repetition is has a meaning.
struct Repetition {
    std::vector<Step> steps;
    int times = 1;
};

using Kind = std::variant<Linear, Circulating, DeformationGradient, Imported, Perturbations,
                          RandomWalk, Repetition>;

struct Exit {
    std::vector<Condition> any_of;  // the step ends after the increment where one holds
    // Solve for the part of that increment at which the first condition just holds (to 1e-9 of
    // the increment), instead of keeping all of it.
    bool exactly = false;
};

struct Step {
    Kind kind;
    std::string name;          // for messages and progress
    int increments = 100;      // [1, 10 000 000]
    double first_share = 0.0;  // of the path in the first increment, the others growing
                               // geometrically; 0: all even. Strain is straight within an
                               // increment: resolve R after a reversal.
    double duration = 0.0;     // [time]
    double temperature_change = 0.0;
    int every = 1;              // record each every-th increment ...
    bool record_first = false;  // ... or increments 1, 1 + every, 1 + 2 every ...
    bool record_end = true;     // ... and the last of the step
    int iteration_limit = 0;    // of Newton's method, 0: that of Settings
    // Undrained: rows speak of total stress, volumetric strain is zero, and the pore pressure is the
    // seventh unknown. At least one row must feel the mean total stress.
    bool undrained = false;
    bool drains = false;  // rows speak of total stress while the pore pressure goes to zero evenly
    Exit exit;
};

using Program = std::vector<Step>;

}  // namespace element
