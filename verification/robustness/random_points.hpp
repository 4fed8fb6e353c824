// SPDX-License-Identifier: BSD-3-Clause
// Random states and increments, far beyond what a sane host asks for; the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <grit/grit.h>

#include "support/trials/split_mix.hpp"

namespace robustness {

using Random = grit::SplitMix;

// A random symmetric tensor of the given norm, as Voigt stress (shear_factor 1) or engineering
// strain (shear_factor 2).
inline void random_direction(Random& random, double length, double shear_factor, double out[6]) {
    double sum = 0.0;
    for (int c = 0; c < 6; ++c) {
        out[c] = random.normal();
        sum += out[c] * out[c];
    }
    for (int c = 0; c < 6; ++c)
        out[c] *= length / std::sqrt(sum) * (c < 3 ? 1.0 : shear_factor / std::sqrt(2.0));
}

struct Sand {
    grit_sand prepared;
    grit_sand_parameters parameters;
};

// Parameters from the whole of the documented ranges, hardness in Pa; every sixth without
// intergranular strain, every fourth with p_t.
inline Sand random_sand(Random& random) {
    for (;;) {
        Sand sand;
        grit_sand_parameters& p = sand.parameters;
        grit_sand_parameters_init(&p, sizeof p);
        p.critical_friction_angle = random.uniform(0.18, 1.04);
        p.granulate_hardness = random.log_uniform(1e8, 1e11);
        p.stiffness_exponent = random.uniform(0.05, 0.9);
        p.densest_void_ratio = random.uniform(0.1, 1.0);
        p.critical_void_ratio = p.densest_void_ratio * random.uniform(1.05, 2.0);
        p.loosest_void_ratio = p.critical_void_ratio * random.uniform(1.02, 1.5);
        p.pyknotropy_exponent = random.uniform(0.01, 0.6);
        p.stiffness_void_exponent = random.uniform(0.0, 4.0);
        if (random.below(4) == 0) p.pressure_shift = random.log_uniform(1.0, 1e5);
        if (random.below(6) != 0) {
            p.reversal_stiffness = random.uniform(1.0, 15.0);
            p.transverse_stiffness = random.uniform(1.0, p.reversal_stiffness);
            if (random.below(4) == 0) p.reversal_stiffness = p.transverse_stiffness = 1.0;
            p.elastic_strain_radius = random.log_uniform(1e-6, 1e-2);
            p.evolution_exponent = random.uniform(0.02, 2.0);
            p.stiffness_interpolation_exponent = random.uniform(0.5, 15.0);
        }
        if (grit_sand_prepare(&p, &sand.prepared, nullptr) == GRIT_OK) return sand;
    }
}

// All built-in sands that have intergranular strain, in Pa, and some random ones.
inline std::vector<Sand> various_sands(int random_ones) {
    std::vector<Sand> sands;
    Random random(314159);
    for (int i = 0; i < random_ones; ++i) sands.push_back(random_sand(random));
    for (int i = 0; i < grit_sand_record_count(); ++i) {
        Sand sand;
        grit_sand_parameters_init(&sand.parameters, sizeof sand.parameters);
        grit_sand_record_parameters(i, 1000.0, &sand.parameters);
        if (std::isnan(sand.parameters.reversal_stiffness)) continue;
        if (grit_sand_prepare(&sand.parameters, &sand.prepared, nullptr) == GRIT_OK)
            sands.push_back(sand);
    }
    return sands;
}

struct Points {
    std::vector<double> strain, stress, state;
    explicit Points(std::size_t n) : strain(6 * n), stress(6 * n), state(8 * n) {}
};

enum class Kind { inside, outside_cone, tension, zero_stress, bad_number };

// One point: p 1 Pa ... 10 MPa, e from e_d - 0.1 to e_i + 0.3, |h| <= R, increments 1e-12 ... 1e-1.
inline Kind random_point(Random& random, const Sand& sand, bool wild, double* strain,
                         double* stress, double* state) {
    Kind kind = Kind::inside;
    if (wild) {
        const int dice = random.below(100);
        kind = dice < 60   ? Kind::inside
               : dice < 80 ? Kind::outside_cone
               : dice < 88 ? Kind::tension
               : dice < 95 ? Kind::zero_stress
                           : Kind::bad_number;
    }
    const double p = random.log_uniform(1.0, 1e7);
    const double tan_psi =
        kind == Kind::outside_cone ? random.uniform(1.4, 4.0) : random.uniform(0.0, 1.1);
    random_direction(random, 1.0, 1.0, stress);
    const double mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    for (int c = 0; c < 3; ++c) stress[c] -= mean;
    double dev = 0.0;
    for (int c = 0; c < 6; ++c) dev += (c < 3 ? 1.0 : 2.0) * stress[c] * stress[c];
    for (int c = 0; c < 6; ++c)
        stress[c] = stress[c] * tan_psi * 3.0 * p / std::sqrt(3.0 * dev) - (c < 3 ? p : 0.0);
    if (kind == Kind::tension)
        for (int c = 0; c < 6; ++c) stress[c] = -stress[c];
    if (kind == Kind::zero_stress)
        for (int c = 0; c < 6; ++c) stress[c] = 0.0;

    const bool igs = !std::isnan(sand.parameters.elastic_strain_radius);
    const double R = igs ? sand.parameters.elastic_strain_radius : 1e-4;
    const double rho = random.below(4) == 0 ? 1.0 : random.uniform();
    random_direction(random, rho * R, 2.0, state);
    double limits[3];
    grit_sand_void_ratios(&sand.prepared, p, limits);
    state[GRIT_SAND_VOID_RATIO] = std::fmax(1e-3, random.uniform(limits[2] - 0.1, limits[0] + 0.3));
    state[GRIT_SAND_SEPARATION] =
        kind == Kind::zero_stress && random.below(2) ? random.log_uniform(1e-8, 1e-1) : 0.0;

    random_direction(random, random.log_uniform(1e-12, 1e-1), 2.0, strain);
    if (wild && random.below(50) == 0)
        for (int c = 0; c < 6; ++c) strain[c] = 0.0;
    if (kind == Kind::bad_number) {
        const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308};
        double* where[] = {strain, stress, state};
        where[random.below(3)][random.below(6)] = bad[random.below(5)];
    }
    return kind;
}

}  // namespace robustness
