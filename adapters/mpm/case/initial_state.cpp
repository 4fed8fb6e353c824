// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/initial_state.hpp"

#include <algorithm>
#include <stdexcept>

#include <grit/sand_operators.h>

#include "adapters/mpm/kernel/elastic.hpp"
#include "adapters/mpm/kernel/sand.hpp"

namespace grit::mpm {
namespace {

namespace c = column;

[[noreturn]] void refuse(const BodyPlan& body, const std::string& why) {
    throw std::invalid_argument("body " + body.name + ": " + why);
}

grit_sand prepared(const BodyPlan& body, const SandPlan& plan) {
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&plan.parameters, &sand, &error) != GRIT_OK) refuse(body, error.message);
    return sand;
}

// Mean pressure of the particle after its stress is set [Pa].
double pressure(const ParticleView& q, std::ptrdiff_t p) {
    return -(q[c::S_rr][p] + q[c::S_zz][p] + q[c::S_tt][p]) / 3.0;
}

void set_sand(const BodyPlan& body, const SandPlan& plan, Particles& particles) {
    const grit_sand sand = prepared(body, plan);
    const ParticleView q = particles.view();
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i) {
        const double p = std::max(0.0, pressure(q, i)) + plan.parameters.pressure_shift;
        double e = plan.void_ratio, limits[3];
        if (plan.at_zero_pressure) grit_sand_void_ratio_at_pressure(&sand, plan.void_ratio, p, &e);
        grit_sand_void_ratios(&sand, p, limits);
        if (!(e >= limits[2] && e <= limits[0]))
            refuse(body, "the void ratio must be in [e_d, e_i] = [" + std::to_string(limits[2]) +
                             ", " + std::to_string(limits[0]) + "] at z = " +
                             std::to_string(q[c::z][i]) + " m, got " + std::to_string(e));
        double state[GRIT_SAND_STATE_SIZE] = {};
        if (plan.intergranular_rho > 0.0) {
            double direction[6] = {};
            std::copy_n(plan.intergranular_direction, 4, direction);
            if (grit_sand_mobilise(&sand, direction, plan.intergranular_rho, state) != GRIT_OK)
                refuse(body, "this intergranular strain cannot be set");
        }
        state[GRIT_SAND_VOID_RATIO] = e;
        for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) q[Sand::state + k][i] = state[k];
    }
}

double K0_of(const BodyPlan& body, const Geostatic& rest) {
    if (rest.K0) return *rest.K0;
    const auto& elastic = std::get<ElasticPlan>(body.material);
    return elastic.poissons_ratio / (1.0 - elastic.poissons_ratio);
}

void set_geostatic(const BodyPlan& body, double gravity, Particles& particles) {
    const Geostatic& rest = *body.geostatic;
    const ParticleView q = particles.view();
    const double unit_weight = body.density * gravity;
    const auto* plan = std::get_if<SandPlan>(&body.material);
    const grit_sand sand = plan ? prepared(body, *plan) : grit_sand{};
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double depth = std::max(0.0, rest.surface - q[c::z][p]);
        double stress[6] = {};
        if (plan) {
            if (grit_sand_stress_at_rest(&sand, unit_weight, depth, rest.surcharge,
                                         rest.K0.value_or(-1.0), 1, stress) != GRIT_OK)
                refuse(body, "no stress at rest for this unit weight, surcharge and K0");
        } else {
            stress[1] = -(unit_weight * depth + rest.surcharge);
            stress[0] = stress[2] = K0_of(body, rest) * stress[1];
        }
        for (int k = 0; k < 4; ++k) q[c::S_rr + k][p] = stress[k];
    }
}

}  // namespace

std::unique_ptr<Material> make_material(const BodyPlan& body) {
    if (const auto* sand = std::get_if<SandPlan>(&body.material))
        return std::make_unique<Sand>(prepared(body, *sand), sand->options);
    const auto* elastic = std::get_if<ElasticPlan>(&body.material);
    if (!elastic) return nullptr;
    if (elastic->neo_hooke)
        return std::make_unique<NeoHooke>(elastic->youngs_modulus, elastic->poissons_ratio);
    return std::make_unique<LinearElastic>(elastic->youngs_modulus, elastic->poissons_ratio);
}

void set_initial_state(const BodyPlan& body, double gravity, Particles& particles) {
    if (body.geostatic) {
        const auto* elastic = std::get_if<ElasticPlan>(&body.material);
        if (body.rigid() || (elastic && elastic->neo_hooke))
            refuse(body, "sand and linear elastic bodies alone start with a stress");
        set_geostatic(body, gravity, particles);
    }
    if (const auto* sand = std::get_if<SandPlan>(&body.material)) set_sand(body, *sand, particles);
}

}  // namespace grit::mpm
