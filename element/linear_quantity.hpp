// SPDX-License-Identifier: BSD-3-Clause
// What is read off a sample, where it is a linear function of the record: its derivatives follow from the record's.
#pragma once

#include "element/record.hpp"

namespace element {

// Sum of weights times components.
struct LinearQuantity {
    Vector6 strain = Vector6::Zero();
    Vector6 effective_stress = Vector6::Zero();
    Vector6 total_stress = Vector6::Zero();
    double void_ratio = 0.0, pore_pressure = 0.0;

    double of(const Record& record) const {
        return strain.dot(record.strain) + effective_stress.dot(record.effective_stress) +
               total_stress.dot(record.total_stress) + void_ratio * record.void_ratio +
               pore_pressure * record.pore_pressure;
    }
    // A column per direction.
    Eigen::RowVectorXd of(const RecordSlopes& slopes) const {
        return strain.transpose() * slopes.strain +
               effective_stress.transpose() * slopes.effective_stress +
               total_stress.transpose() * slopes.total_stress + void_ratio * slopes.void_ratio +
               pore_pressure * slopes.pore_pressure;
    }
};

}  // namespace element
