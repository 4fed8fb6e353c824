// SPDX-License-Identifier: BSD-3-Clause
// The sands the tests run at.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <grit/grit.h>

namespace tests {

struct Sand {
    std::string name;
    grit_sand_parameters p;
    grit_sand prepared;
    operator const grit_sand*() const { return &prepared; }
};

inline grit_sand_parameters parameters_of(const std::string& name, double stress_scale = 1.0) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    if (grit_sand_record_parameters(grit_sand_record_find(name.c_str()), stress_scale, &p))
        throw std::runtime_error("no record " + name);
    return p;
}

inline Sand prepared(const std::string& name, const grit_sand_parameters& p) {
    Sand sand{name, p, {}};
    grit_error error;
    if (grit_sand_prepare(&p, &sand.prepared, &error))
        throw std::runtime_error(name + ": " + error.message);
    return sand;
}

inline Sand sand_named(const std::string& name, double stress_scale = 1.0) {
    return prepared(name, parameters_of(name, stress_scale));
}

// In kPa.
inline const std::vector<Sand>& four_sands() {
    static const std::vector<Sand> sands = {sand_named("lausitz"), sand_named("hochstetten"),
                                            sand_named("hostun"), sand_named("karlsruhe-fine")};
    return sands;
}

inline Sand with_evolution_exponent(const Sand& sand, double beta_r) {
    grit_sand_parameters p = sand.p;
    p.evolution_exponent = beta_r;
    return prepared(sand.name, p);
}

}  // namespace tests
