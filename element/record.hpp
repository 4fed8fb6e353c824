// SPDX-License-Identifier: BSD-3-Clause
// What a run leaves behind.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "element/slopes.hpp"

namespace element {

struct Record {
    long step = 0;      // from 1, repetitions counted through; 0: the start
    int increment = 0;  // within the step, from 1
    double time = 0.0;
    Vector6 strain = Vector6::Zero();  // total since the start of the run
    Vector6 stress = Vector6::Zero();  // as the law keeps it
    std::vector<double> state;         // as the law keeps it
    double void_ratio = 0.0;           // e [-], NaN if the law does not know
    double pore_pressure = 0.0;        // excess, compression positive [stress]
    Vector6 effective_stress = Vector6::Zero();
    Vector6 total_stress = Vector6::Zero();  // effective - pore_pressure 1
    // Work since the previous record
    long iterations = 0;   // linear systems solved
    long evaluations = 0;  // of the rate
    long cut_backs = 0;    // halvings
    // Newton's residuals of the increment's last part, relative to the stress norm; if asked for.
    std::vector<double> residuals;
    RecordSlopes slopes;  // of a sample with derivatives
};

struct Failure {
    long step = 0;  // from 1, repetitions counted through
    int increment = 0;
    std::string message;  // one line: step, increment, strain reached, value, limit, unit
};

// The last record is the state where the run ended, however it ended.
struct History {
    std::vector<std::string> state_names;
    std::vector<Record> records;     // unless somebody else takes them
    std::optional<Failure> failure;  // the run stopped early
    // Conditions that ended a step: "step 2, increment 17: s1 < -400".
    std::vector<std::string> exits;
};

struct Progress {
    long step = 0, steps = 0;            // repetitions counted through
    long increment = 0, increments = 0;  // of the whole run; exits may leave some out
    const Record* record = nullptr;      // the point as it is now
};

// Who listens to a run. Either may be empty.
struct Listeners {
    // After every increment. Returning false stops the run; failure says so.
    std::function<bool(const Progress&)> increment;
    // Every record as it is made; History keeps none then.
    std::function<void(const Record&)> record;
};

}  // namespace element
