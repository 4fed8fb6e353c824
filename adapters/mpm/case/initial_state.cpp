// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/initial_state.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <grit/sand_operators.h>

#include "adapters/mpm/kernel/elastic.hpp"
#include "adapters/mpm/kernel/sand.hpp"

namespace grit::mpm {
namespace {

namespace c = column;

[[noreturn]] void refuse(const BodyPlan& body, const std::string& why) {
    throw std::invalid_argument("body " + body.name + ": " + why);
}

double K0_of(const BodyPlan& body, const Geostatic& rest) {
    if (rest.K0) return *rest.K0;
    const auto& elastic = std::get<ElasticPlan>(body.material);
    return elastic.poissons_ratio / (1.0 - elastic.poissons_ratio);
}

// Mean pressure of the particle after its stress is set [Pa].
double pressure(const ParticleView& q, std::ptrdiff_t p) {
    return -(q[c::S_rr][p] + q[c::S_zz][p] + q[c::S_tt][p]) / 3.0;
}

void set_sand(const BodyPlan& body, const SandPlan& plan, Particles& particles) {
    const grit_sand sand = prepared_sand(body, plan);
    const ParticleView q = particles.view();
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i) {
        double state[GRIT_SAND_STATE_SIZE];
        find_start(body, plan, sand, pressure(q, i), q[c::z][i], state);
        for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) q[Sand::state + k][i] = state[k];
    }
}

double void_ratio_of(const BodyPlan& body) {
    const auto* sand = std::get_if<SandPlan>(&body.material);
    return sand ? sand->void_ratio : body.water->porosity / (1.0 - body.water->porosity);
}

void set_geostatic(const BodyPlan& body, double gravity, Particles& particles) {
    const ParticleView q = particles.view();
    const StressAtRest at_rest(body, gravity,
                               {q[c::z], static_cast<std::size_t>(particles.size())});
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        double stress[6];
        at_rest.find(q[c::z][p], 1, stress);
        for (int k = 0; k < 4; ++k) q[c::S_rr + k][p] = stress[k];
    }
}

}  // namespace

// Effective vertical stresses of a body whose pores are full, compression positive, by depth below its surface:
// the weight above less the pore pressure that bears, where void ratios follow the stress.
class StressAtRest::EffectiveWeight {
  public:
    EffectiveWeight(const BodyPlan& of, double gravity_down, double deepest)
        : body(of), gravity(gravity_down), spacing(deepest / levels) {
        // Free water above the surface presses on grains and pores alike.
        double borne = pressure_at(0.0);
        stress.push_back(body.geostatic->surcharge + std::max(borne, 0.0) - borne);
        for (int i = 0; i < levels; ++i) {
            const double before = stress.back(), below = pressure_at((i + 1) * spacing);
            const double change = below - borne;
            const double half = before + 0.5 * (spacing * unit_weight(before) - change);
            stress.push_back(before + spacing * unit_weight(half) - change);
            borne = below;
        }
    }
    double operator()(double depth) const {
        if (!(spacing > 0.0)) return stress.front();
        const double at = depth / spacing;
        const auto i = std::min(static_cast<std::size_t>(at), stress.size() - 2);
        return stress[i] + (at - static_cast<double>(i)) * (stress[i + 1] - stress[i]);
    }

  private:
    static constexpr int levels = 256;
    double pressure_at(double depth) const {
        const WaterPlan& water = *body.water;
        return std::max(pore_pressure_at(water, gravity, body.geostatic->surface - depth),
                        -water.largest_tension);
    }
    double unit_weight(double vertical) const {
        const WaterPlan& water = *body.water;
        const double e = void_ratio(vertical);
        return (water.grain_density + e * water.density) * gravity / (1.0 + e);
    }
    double void_ratio(double vertical) const {
        const auto* plan = std::get_if<SandPlan>(&body.material);
        if (!plan || !plan->at_zero_pressure) return void_ratio_of(body);
        const grit_sand law = prepared_sand(body, *plan);
        double at_rest[6] = {}, e = plan->void_ratio;
        grit_sand_stress_at_rest(&law, 0.0, 0.0, vertical, body.geostatic->K0.value_or(-1.0), 1,
                                 at_rest);
        const double p = -(at_rest[0] + at_rest[1] + at_rest[2]) / 3.0;
        grit_sand_void_ratio_at_pressure(&law, plan->void_ratio,
                                         p + plan->parameters.pressure_shift, &e);
        return e;
    }

    const BodyPlan& body;
    double gravity, spacing;
    std::vector<double> stress;
};

StressAtRest::StressAtRest(const BodyPlan& of, double gravity, std::span<const double> levels)
    : body(of), unit_weight(of.density * gravity) {
    if (const auto* plan = std::get_if<SandPlan>(&body.material)) sand = prepared_sand(body, *plan);
    if (!body.water) return;
    double deepest = 0.0;
    for (const double z : levels) deepest = std::max(deepest, depth(z));
    effective = std::make_unique<EffectiveWeight>(body, gravity, deepest);
}

StressAtRest::~StressAtRest() = default;

double StressAtRest::depth(double z) const { return std::max(0.0, body.geostatic->surface - z); }

void StressAtRest::find(double z, int vertical, double* stress) const {
    const Geostatic& rest = *body.geostatic;
    const double weight = effective ? 0.0 : unit_weight;
    const double surcharge = effective ? (*effective)(depth(z)) : rest.surcharge;
    if (sand) {
        if (grit_sand_stress_at_rest(&*sand, weight, depth(z), surcharge, rest.K0.value_or(-1.0),
                                     vertical, stress) != GRIT_OK)
            refuse(body, "no stress at rest for this unit weight, surcharge and K0");
        return;
    }
    std::fill_n(stress, 6, 0.0);
    const double upright = -(weight * depth(z) + surcharge);
    for (int k = 0; k < 3; ++k) stress[k] = k == vertical ? upright : K0_of(body, rest) * upright;
}

grit_sand prepared_sand(const BodyPlan& body, const SandPlan& plan) {
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&plan.parameters, &sand, &error) != GRIT_OK) refuse(body, error.message);
    return sand;
}

void find_start(const BodyPlan& body, const SandPlan& plan, const grit_sand& sand, double pressure,
                double z, double* state) {
    const double p = std::max(0.0, pressure) + plan.parameters.pressure_shift;
    double e = plan.void_ratio, limits[3];
    if (plan.at_zero_pressure) grit_sand_void_ratio_at_pressure(&sand, plan.void_ratio, p, &e);
    grit_sand_void_ratios(&sand, p, limits);
    if (!(e >= limits[2] && e <= limits[0]))
        refuse(body, "the void ratio must be in [e_d, e_i] = [" + std::to_string(limits[2]) + ", " +
                         std::to_string(limits[0]) + "] at z = " + std::to_string(z) + " m, got " +
                         std::to_string(e));
    std::fill_n(state, GRIT_SAND_STATE_SIZE, 0.0);
    if (plan.intergranular_rho > 0.0 &&
        grit_sand_mobilise(&sand, plan.intergranular_direction, plan.intergranular_rho, state) !=
            GRIT_OK)
        refuse(body, "this intergranular strain cannot be set");
    state[GRIT_SAND_VOID_RATIO] = e;
}

std::unique_ptr<Material> make_material(const BodyPlan& body) {
    if (const auto* sand = std::get_if<SandPlan>(&body.material))
        return std::make_unique<Sand>(prepared_sand(body, *sand), sand->options);
    const auto* elastic = std::get_if<ElasticPlan>(&body.material);
    if (!elastic) return nullptr;
    if (elastic->neo_hooke)
        return std::make_unique<NeoHooke>(elastic->youngs_modulus, elastic->poissons_ratio);
    return std::make_unique<LinearElastic>(elastic->youngs_modulus, elastic->poissons_ratio);
}

PoreWater make_water(const BodyPlan& body, int first_column, const Separation& separation) {
    const WaterPlan& plan = *body.water;
    PoreWater out;
    out.flows = plan.drainage == Drainage::flow;
    out.implicit = plan.implicit;
    out.bulk_modulus = plan.bulk_modulus;
    out.density = plan.density;
    out.largest_tension = plan.largest_tension;
    out.porosity = plan.porosity;
    out.conductivity = plan.conductivity;
    out.conductivity_at = conductivity_at(body);
    out.first = first_column;
    out.void_ratio_column = separation.void_ratio;
    if (out.void_ratio_column >= 0) out.opening_cap = separation.cap;
    return out;
}

PoreWater make_water(const BodyPlan& body, const Material& material) {
    return make_water(body, column::own + material.own_columns(), material.separation());
}

double pore_pressure_at(const WaterPlan& water, double gravity, double z) {
    return water.table ? water.density * gravity * (*water.table - z) : 0.0;
}

double conductivity_at(const BodyPlan& body) {
    const WaterPlan& water = *body.water;
    if (!water.kozeny_carman) return 0.0;
    return water.conductivity_at > 0.0 ? water.conductivity_at : void_ratio_of(body);
}

FullPores full_pores(const BodyPlan& body, double gravity, double e, double z) {
    const WaterPlan& plan = *body.water;
    const double n = PoreWater::porosity_of(e);
    const double carried = plan.drainage == Drainage::flow ? 0.0 : n * plan.density;
    const FullPores out{(1.0 - n) * plan.grain_density + carried,
                        pore_pressure_at(plan, gravity, z)};
    if (!(out.pressure < plan.bulk_modulus))
        refuse(body, "the bulk modulus of water, " + std::to_string(plan.bulk_modulus) +
                         " Pa, must be above the pressure that its table gives at z = " +
                         std::to_string(z) + " m, " + std::to_string(out.pressure) + " Pa");
    return out;
}

void fill_pores(const BodyPlan& body, double gravity, const PoreWater& water,
                Particles& particles) {
    const ParticleView q = particles.view();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const FullPores pores = full_pores(body, gravity, water.void_ratio(q, p), q[c::z][p]);
        q[c::mass][p] = pores.density * q[c::V0][p];
        q[water.first][p] = pores.pressure;
        if (water.flows) q[water.content_column()][p] = water.mass(q, p);
    }
}

void check_stress_at_rest(const BodyPlan& body) {
    const auto* elastic = std::get_if<ElasticPlan>(&body.material);
    if (body.geostatic && (body.rigid() || (elastic && elastic->neo_hooke)))
        refuse(body, "sand and linear elastic bodies alone start with a stress");
}

void set_initial_state(const BodyPlan& body, double gravity, Particles& particles) {
    check_stress_at_rest(body);
    if (body.geostatic) {
        set_geostatic(body, gravity, particles);
    }
    if (const auto* sand = std::get_if<SandPlan>(&body.material)) set_sand(body, *sand, particles);
}

}  // namespace grit::mpm
