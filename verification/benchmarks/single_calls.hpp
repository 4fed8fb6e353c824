// SPDX-License-Identifier: BSD-3-Clause
// The 320 states x 5 increments of verification/data/speed_states.csv: Lausitz sand, kPa, single
// calls with their exact results (integrated to 1e-13).
#pragma once

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <grit/grit.h>

namespace benchmarks {

struct Call {
    double stress[6], state[8], strain[6], stress_end[6], h_end[6], e_end;
};

inline std::map<double, std::vector<Call>> read_calls(const std::string& path) {
    std::map<double, std::vector<Call>> calls;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        double increment;
        Call c{};
        row >> increment;
        for (double& x : c.stress) row >> x;
        for (int i = 0; i < 7; ++i) row >> c.state[i];
        for (double& x : c.strain) row >> x;
        for (double& x : c.stress_end) row >> x;
        for (double& x : c.h_end) row >> x;
        row >> c.e_end;
        if (row) calls[increment].push_back(c);
    }
    return calls;
}

inline grit_sand lausitz() {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &parameters);
    grit_sand sand;
    grit_sand_prepare(&parameters, &sand, nullptr);
    return sand;
}

}  // namespace benchmarks
