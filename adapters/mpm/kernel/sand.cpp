// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/sand.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>

#include <grit/sand_operators.h>

#include "adapters/mpm/kernel/material_failure.hpp"

namespace grit::mpm {
namespace c = column;
namespace {

// Stress and state of a range as the library sees them.
grit_sand_points points_of(const Range& range) {
    const ParticleView& q = range.particles;
    grit_sand_points points{};
    points.struct_size = sizeof points;
    points.components = 4;
    points.stress = grit_mutable_view_of(q[c::S_rr] + range.begin, 1, q.stride);
    points.state = grit_mutable_view_of(q[Sand::state] + range.begin, 1, q.stride);
    return points;
}

// The point that failed is as it was.
SandUpdate asked_of(const Range& range, const Increments& d, std::ptrdiff_t i) {
    const ParticleView& q = range.particles;
    const std::ptrdiff_t p = range.begin + i;
    SandUpdate out{};
    for (int k = 0; k < 4; ++k) {
        out.stress[k] = q[c::S_rr + k][p];
        out.strain[k] = d.strain[k][i];
    }
    for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) out.state[k] = q[Sand::state + k][p];
    for (int k = 0; k < 9; ++k) out.rotation[k] = d.rotation[k][i];
    return out;
}

}  // namespace

std::vector<std::string> sand_words(const grit_sand& sand, const grit_sand_options& options) {
    std::vector<std::string> out{"sand"};
    const auto add = [&out](const char* name, double value) {
        char number[32];
        std::snprintf(number, sizeof number, " %.17g", value);
        out.push_back(name + std::string(number));
    };
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_parameters_of(&sand, &parameters);
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        double value = 0.0;
        grit_sand_parameter_get(&parameters, i, &value);
        add(grit_sand_parameter_describe(i)->name, value);
    }
    add("tolerance", options.tolerance);
    add("evaluation_limit", options.evaluation_limit);
    add("intergranular_off", options.intergranular_off);
    return out;
}

double opening_cap(const grit_sand& sand) {
    double void_ratios[3];
    grit_sand_void_ratios(&sand, 0.0, void_ratios);
    return 1.2 * void_ratios[0];
}

Sand::Sand(const grit_sand& prepared, const grit_sand_options& given)
    : sand(prepared), options(given) {}

std::vector<const char*> Sand::own_column_names() const {
    return {"h_rr", "h_zz", "h_tt", "h_rz", "h_rt", "h_zt", "e", "separation", "work"};
}

std::vector<std::string> Sand::words() const { return sand_words(sand, options); }

void Sand::update(const Range& range, const Increments& d) {
    const ParticleView& q = range.particles;
    const std::ptrdiff_t n = range.end - range.begin;
    double before[4][Increments::capacity];
    for (int k = 0; k < 4; ++k)
        for (std::ptrdiff_t i = 0; i < n; ++i) before[k][i] = q[c::S_rr + k][range.begin + i];

    grit_sand_points points = points_of(range);
    points.strain_increment = grit_view_of(d.strain[0], 1, Increments::capacity);
    points.rotation_increment = grit_view_of(d.rotation[0], 1, Increments::capacity);
    grit_error error;
    if (grit_sand_update(&sand, &options, n, &points, nullptr, &error) != GRIT_OK)
        throw_failure(error, range.begin, [&](std::ptrdiff_t i) { return asked_of(range, d, i); });

    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const std::ptrdiff_t p = range.begin + i;
        double density = 0.0;
        for (int k = 0; k < 4; ++k)
            density += 0.5 * (before[k][i] + q[c::S_rr + k][p]) * d.strain[k][i];
        q[work][p] += density * q[c::V0][p] * q.J(p);
    }
}

void Sand::wave_moduli(const Range& range, double* moduli) const {
    grit_error error;
    const grit_sand_points points = points_of(range);
    if (grit_sand_wave_moduli(&sand, &options, range.end - range.begin, &points, moduli, &error) !=
        GRIT_OK)
        throw std::runtime_error(std::string("sand: ") + error.message);
}

double Sand::energy(const ParticleView& q, std::ptrdiff_t p) const { return q[work][p]; }

Separation Sand::separation() const { return {state + GRIT_SAND_VOID_RATIO, opening_cap(sand)}; }

void Sand::reflect(const ParticleView& q, std::ptrdiff_t p) const {
    q[state + GRIT_SAND_H12][p] = -q[state + GRIT_SAND_H12][p];
}

}  // namespace grit::mpm
