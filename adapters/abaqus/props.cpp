// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/props.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "adapters/abaqus/layout.hpp"
#include "adapters/host/failure.hpp"

namespace grit::abaqus {
namespace {

constexpr int props_read = GRIT_CLASSIC_PROPS_READ;

// phi_c in the layout's own unit: the library would speak of radians whatever PROPS are.
grit_status check_angle(double phi_c, grit_error& error) {
    const grit_sand_parameter_info& known = *grit_sand_parameter_describe(0);
    const double low = known.lowest / layout.angle, high = known.highest / layout.angle;
    if (phi_c * layout.angle >= known.lowest && phi_c * layout.angle <= known.highest)
        return GRIT_OK;
    const double other = layout.angle == 1.0 ? phi_c * GRIT_DEGREE : phi_c / GRIT_DEGREE;
    return failure(error, GRIT_BAD_PARAMETER,
                   "PROPS(1) (phi_c) must be in [%.6g, %.6g] %s, got %g%s%s%s", low, high,
                   layout.angle_unit, phi_c, other >= low && other <= high ? ": " : "",
                   other >= low && other <= high ? layout.other_unit : "",
                   other >= low && other <= high ? "?" : "");
}

grit_status read_water(const double* props, double K_w, grit_sand_water& out, grit_error& error) {
    const double tension = props[GRIT_CLASSIC_LARGEST_TENSION];
    const double itself = props[GRIT_CLASSIC_WATER_ITSELF];
    int bad = 0;
    if (grit_classic_water(K_w, tension, itself, &out, &bad) == GRIT_OK) return GRIT_OK;
    if (bad == GRIT_CLASSIC_WATER_ITSELF)
        return failure(error, GRIT_BAD_PARAMETER,
                       "PROPS(19) must be 1, where K_w is that of the water itself, or 0, got %g",
                       itself);
    return failure(error, GRIT_BAD_PARAMETER, "PROPS(%d) (%s) must be >= 0 and finite, got %g",
                   bad + 1, bad == GRIT_CLASSIC_WATER_STIFFNESS ? "K_w" : "largest tension",
                   bad == GRIT_CLASSIC_WATER_STIFFNESS ? K_w : tension);
}

grit_status prepare(const double* props, Material& out, grit_error& error) {
    if (const grit_status s = check_angle(props[0], error)) return s;
    double classic[GRIT_CLASSIC_NPROPS];
    if (const grit_status s = layout.classic(props, classic, error)) return s;
    grit_sand_parameters parameters;
    grit_classic_parameters(classic, &parameters);
    parameters.critical_friction_angle = props[0] * layout.angle;  // without a way there and back
    out.e_0 = classic[GRIT_CLASSIC_VOID_RATIO_AT_ZERO_PRESSURE];
    if (const grit_status s =
            read_water(props, classic[GRIT_CLASSIC_WATER_STIFFNESS], out.water, error))
        return s;
    const double tolerance = props[GRIT_CLASSIC_TOLERANCE];
    grit_sand_options_init(&out.options, sizeof out.options);
    if (tolerance != 0.0) out.options.tolerance = tolerance;
    if (!(out.options.tolerance >= GRIT_SAND_LEAST_TOLERANCE &&
          out.options.tolerance <= GRIT_SAND_LARGEST_TOLERANCE))
        return failure(error, GRIT_BAD_PARAMETER,
                       "PROPS(17) (tolerance) must be 0 or in [%g, %g], got %g",
                       GRIT_SAND_LEAST_TOLERANCE, GRIT_SAND_LARGEST_TOLERANCE, tolerance);
    return grit_sand_prepare(&parameters, &out.sand, &error);
}

struct Known {
    int nprops;  // 0: none yet
    double props[props_read];
    Material material;
};

}  // namespace

grit_status read_props(const double* props, int nprops, const Material*& out, grit_error& error) {
    static constinit thread_local Known known{};  // no guard is asked at each call
    out = &known.material;
    const int n = std::min(nprops, props_read);
    const auto size = static_cast<std::size_t>(n) * sizeof(double);
    if (known.nprops == n && std::memcmp(known.props, props, size) == 0) return GRIT_OK;
    known.nprops = 0;
    std::memcpy(known.props, props, size);
    std::fill(known.props + n, known.props + props_read, 0.0);
    if (const grit_status s = prepare(known.props, known.material, error)) return s;
    known.nprops = n;
    return GRIT_OK;
}

grit_status initial_void_ratio(const Material& material, double p, double& void_ratio,
                               grit_error& error) {
    const grit_status status =
        grit_classic_void_ratio(&material.sand, material.e_0, p, &void_ratio);
    if (status != GRIT_BAD_STATE) return status;
    return failure(error, status,
                   "no void ratio: STATEV(%d) is below 0.001 and PROPS(16) (e_0) is %g",
                   layout.void_ratio + 1, material.e_0);
}

}  // namespace grit::abaqus
