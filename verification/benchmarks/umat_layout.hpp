// SPDX-License-Identifier: BSD-3-Clause
// Where a UMAT has what a call needs; layouts/classic.toml explains the keys of the file.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace benchmarks {

struct UmatLayout {
    std::string name;
    std::vector<double> props;
    int nstatv;
    int void_ratio;                   // places count from 0
    int intergranular_strain;         // of the first of six
    int evaluations = -1;             // -1: nowhere
    double shear = 1.0;               // of its h by the engineering one
    bool ddsdde_may_be_null = false;  // no tangent then
    std::vector<std::pair<int, double>> initial_statev;
};

// Throws std::runtime_error naming file, key, value and limit.
UmatLayout read_umat_layout(const std::string& path);

}  // namespace benchmarks
