// SPDX-License-Identifier: BSD-3-Clause
#include "umat/api/parameters.hpp"

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "support/call_checks.hpp"

namespace grit {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = pi / 180.0;

using Member = double grit_sand_parameters::*;

struct Entry {
    int place;
    grit_sand_parameter_info info;
    Member member;
    double Material::*prepared;
    double without = 0.0;  // prepared where there is no intergranular strain
};

using P = grit_sand_parameters;
constexpr Entry table[] = {
    {GRIT_SAND_CRITICAL_FRICTION_ANGLE,
     {"critical_friction_angle", "phi_c", "rad", 10 * degree, 60 * degree, 0},
     &P::critical_friction_angle,
     &Material::phi_c},
    {GRIT_SAND_GRANULATE_HARDNESS,
     {"granulate_hardness", "h_s", "stress", 1e-30, 1e30, 0},
     &P::granulate_hardness,
     &Material::h_s},
    {GRIT_SAND_STIFFNESS_EXPONENT,
     {"stiffness_exponent", "n", "-", 0.01, 0.99, 0},
     &P::stiffness_exponent,
     &Material::n},
    {GRIT_SAND_DENSEST_VOID_RATIO,
     {"densest_void_ratio", "e_d0", "-", 0.01, 5, 0},
     &P::densest_void_ratio,
     &Material::e_d0},
    {GRIT_SAND_CRITICAL_VOID_RATIO,
     {"critical_void_ratio", "e_c0", "-", 0.01, 5, 0},
     &P::critical_void_ratio,
     &Material::e_c0},
    {GRIT_SAND_LOOSEST_VOID_RATIO,
     {"loosest_void_ratio", "e_i0", "-", 0.01, 5, 0},
     &P::loosest_void_ratio,
     &Material::e_i0},
    {GRIT_SAND_PYKNOTROPY_EXPONENT,
     {"pyknotropy_exponent", "alpha", "-", 0.001, 2, 0},
     &P::pyknotropy_exponent,
     &Material::alpha},
    {GRIT_SAND_STIFFNESS_VOID_EXPONENT,
     {"stiffness_void_exponent", "beta", "-", 0, 5, 0},
     &P::stiffness_void_exponent,
     &Material::beta},
    {GRIT_SAND_PRESSURE_SHIFT,
     {"pressure_shift", "p_t", "stress", 0, infinite, 1},
     &P::pressure_shift,
     &Material::p_t},
    {GRIT_SAND_REVERSAL_STIFFNESS,
     {"reversal_stiffness", "m_R", "-", 1, 20, 2},
     &P::reversal_stiffness,
     &Material::m_R,
     1.0},
    {GRIT_SAND_TRANSVERSE_STIFFNESS,
     {"transverse_stiffness", "m_T", "-", 1, 20, 2},
     &P::transverse_stiffness,
     &Material::m_T,
     1.0},
    {GRIT_SAND_ELASTIC_STRAIN_RADIUS,
     {"elastic_strain_radius", "R", "-", 1e-6, 1e-2, 2},
     &P::elastic_strain_radius,
     &Material::R,
     1e-4},
    {GRIT_SAND_EVOLUTION_EXPONENT,
     {"evolution_exponent", "beta_r", "-", 0.01, 2, 2},
     &P::evolution_exponent,
     &Material::beta_r,
     1.0},
    {GRIT_SAND_STIFFNESS_INTERPOLATION_EXPONENT,
     {"stiffness_interpolation_exponent", "chi", "-", 0.5, 20, 2},
     &P::stiffness_interpolation_exponent,
     &Material::chi,
     1.0},
};
static_assert(std::size(table) == GRIT_SAND_PARAMETER_COUNT);
static_assert([] {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        if (table[i].place != i) return false;
    return true;
}());

grit_status check_range(const Entry& entry, double value, grit_error* error) {
    const grit_sand_parameter_info& i = entry.info;
    const char* unit = std::strcmp(i.unit, "-") == 0 ? "" : i.unit;
    if (std::isnan(value))
        return failure(error, GRIT_BAD_PARAMETER, -1, "%s (%s) is missing or not a number", i.name,
                       i.symbol);
    if (value >= i.lowest && value <= i.highest && std::isfinite(value)) return GRIT_OK;
    if (std::strcmp(i.unit, "rad") == 0)
        return failure(error, GRIT_BAD_PARAMETER, -1, "%s must be in [%.4g, %.4g] rad, got %g%s",
                       i.name, i.lowest, i.highest, value, value > i.highest ? ": degrees?" : "");
    return failure(error, GRIT_BAD_PARAMETER, -1, "%s (%s) must be in [%g, %g] %s, got %g", i.name,
                   i.symbol, i.lowest, i.highest, unit, value);
}

grit_status check_order(const char* low_name, double low, const char* high_name, double high,
                        bool may_be_equal, grit_error* error) {
    if (low < high || (may_be_equal && low == high)) return GRIT_OK;
    return failure(error, GRIT_BAD_PARAMETER, -1, "%s must be %s %s, got %g and %g", low_name,
                   may_be_equal ? "at most" : "below", high_name, low, high);
}

Exponent exponent(double q) {
    constexpr double most = 32.0;
    const bool is_exact = q >= 0.0 && q <= most && 4.0 * q == std::floor(4.0 * q);
    return {q, is_exact ? static_cast<std::int64_t>(4.0 * q) : -1};
}

}  // namespace

grit_status prepare(const grit_sand_parameters& p, Material& m, grit_error* error) {
    int given = 0;
    for (const Entry& entry : table) {
        const double value = p.*entry.member;
        if (entry.info.optional == 2 && std::isnan(value)) continue;
        given += entry.info.optional == 2;
        if (const grit_status s = check_range(entry, value, error)) return s;
    }
    if (given != 0 && given != 5)
        return failure(error, GRIT_BAD_PARAMETER, -1,
                       "intergranular strain needs m_R, m_T, R, beta_r and chi: %d of 5 are given",
                       given);
    if (const grit_status s =
            check_order("densest_void_ratio (e_d0)", p.densest_void_ratio,
                        "critical_void_ratio (e_c0)", p.critical_void_ratio, false, error))
        return s;
    if (const grit_status s =
            check_order("critical_void_ratio (e_c0)", p.critical_void_ratio,
                        "loosest_void_ratio (e_i0)", p.loosest_void_ratio, false, error))
        return s;
    if (given == 5)
        if (const grit_status s =
                check_order("transverse_stiffness (m_T)", p.transverse_stiffness,
                            "reversal_stiffness (m_R)", p.reversal_stiffness, true, error))
            return s;
    if (!(p.pressure_shift <= p.granulate_hardness))
        return failure(error, GRIT_BAD_PARAMETER, -1,
                       "pressure_shift (p_t) must be at most granulate_hardness %g, got %g: units?",
                       p.granulate_hardness, p.pressure_shift);

    Material r{};
    r.stamp = material_stamp;
    r.has_intergranular_strain = given == 5;
    for (const Entry& entry : table)
        r.*entry.prepared =
            entry.info.optional == 2 && given == 0 ? entry.without : p.*entry.member;

    const double sine = std::sin(r.phi_c);
    r.a = std::sqrt(3.0) * (3.0 - sine) / (2.0 * std::sqrt(2.0) * sine);  // (H4)
    const double looseness = std::pow((r.e_i0 - r.e_d0) / (r.e_c0 - r.e_d0), r.alpha);
    const double bracket = 3.0 + r.a * r.a - std::sqrt(3.0) * r.a * looseness;
    if (!(bracket > 0.0))
        return failure(
            error, GRIT_BAD_PARAMETER, -1,
            "isotropic stiffness is not positive: 3 + a^2 - sqrt(3) a "
            "((e_i0-e_d0)/(e_c0-e_d0))^alpha must be > 0, got %g; alpha (%g) is too large",
            bracket, r.alpha);
    r.stiffness = r.h_s / r.n * std::pow(r.e_i0 / r.e_c0, r.beta) / bracket;  // (H8)
    r.three_over_hs = 3.0 / r.h_s;
    r.inverse_e_range = 1.0 / (r.e_c0 - r.e_d0);
    r.inverse_e_i0 = 1.0 / r.e_i0;
    r.inverse_R = 1.0 / r.R;
    r.alpha_power = exponent(r.alpha);
    r.beta_power = exponent(r.beta);
    r.chi_power = exponent(r.chi);
    r.beta_r_power = exponent(r.beta_r);
    r.inverse_beta_r_power = exponent(1.0 / r.beta_r);
    r.p_floor = floor_per_hardness * r.h_s;
    m = r;
    return GRIT_OK;
}

}  // namespace grit

using namespace grit;

extern "C" {

grit_status grit_sand_parameters_init(grit_sand_parameters* parameters, size_t struct_size) {
    if (!parameters || !is_possible_size(struct_size)) return GRIT_BAD_CALL;
    std::memset(parameters, 0, struct_size);
    grit_sand_parameters ours;
    ours.struct_size = sizeof ours;
    for (const Entry& entry : table) ours.*entry.member = missing;
    ours.pressure_shift = 0.0;
    parameters->struct_size = struct_size;
    write_versioned(ours, parameters);
    return GRIT_OK;
}

const grit_sand_parameter_info* grit_sand_parameter_describe(int index) {
    return index >= 0 && index < GRIT_SAND_PARAMETER_COUNT ? &table[index].info : nullptr;
}

grit_status grit_sand_parameter_get(const grit_sand_parameters* parameters, int index,
                                    double* value) {
    if (!parameters || !value || !grit_sand_parameter_describe(index)) return GRIT_BAD_CALL;
    grit_sand_parameters ours;
    grit_sand_parameters_init(&ours, sizeof ours);
    if (!read_versioned(parameters, ours)) return GRIT_BAD_CALL;
    *value = ours.*table[index].member;
    return GRIT_OK;
}

grit_status grit_sand_parameter_set(grit_sand_parameters* parameters, int index, double value) {
    if (!parameters || !grit_sand_parameter_describe(index)) return GRIT_BAD_CALL;
    grit_sand_parameters ours;
    grit_sand_parameters_init(&ours, sizeof ours);
    if (!read_versioned(parameters, ours)) return GRIT_BAD_CALL;
    ours.*table[index].member = value;
    return write_versioned(ours, parameters) ? GRIT_OK : GRIT_BAD_CALL;
}

grit_status grit_sand_prepare(const grit_sand_parameters* parameters, grit_sand* sand,
                              grit_error* error) {
    GRIT_CHECK(check_given(parameters, {"grit_sand_prepare", "parameters"}, error));
    GRIT_CHECK(check_given(sand, {"grit_sand_prepare", "sand"}, error));
    grit_sand_parameters ours;
    grit_sand_parameters_init(&ours, sizeof ours);
    if (!read_versioned(parameters, ours))
        return failure(error, GRIT_BAD_CALL, -1,
                       "grit_sand_parameters.struct_size %zu is not understood (this version has "
                       "%zu bytes): call grit_sand_parameters_init first",
                       parameters->struct_size, sizeof ours);
    Material material;
    GRIT_CHECK(prepare(ours, material, error));
    std::memset(sand, 0, sizeof *sand);
    std::memcpy(sand->opaque, &material, sizeof material);
    return GRIT_OK;
}

grit_status grit_sand_parameters_of(const grit_sand* sand, grit_sand_parameters* parameters) {
    if (!sand || !parameters || material_of(*sand).stamp != material_stamp) return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    grit_sand_parameters ours;
    grit_sand_parameters_init(&ours, sizeof ours);
    for (const Entry& entry : table)
        if (entry.info.optional != 2 || m.has_intergranular_strain != 0.0)
            ours.*entry.member = m.*entry.prepared;
    return write_versioned(ours, parameters) ? GRIT_OK : GRIT_BAD_CALL;
}
}
