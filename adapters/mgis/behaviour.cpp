// SPDX-License-Identifier: BSD-3-Clause
// The behaviour: one point per call, the material prepared from its properties every time, nothing kept
// between calls but the parameters a user has set.
#include <grit/sand_operators.h>

#include <cmath>

#include "adapters/host/failure.hpp"
#include "adapters/mgis/complaint.hpp"
#include "adapters/mgis/material.hpp"
#include "adapters/mgis/parameters.hpp"
#include "adapters/mgis/request.hpp"
#include "adapters/mgis/state_variables.hpp"

namespace grit::mgis {
namespace {

struct Hypothesis {
    const char* name;
    int components;
};

// Everything a call returns, before any of it is given to the host.
struct Results {
    Point end;
    double C[36];  // d stress / d strain, Voigt, row-major
    double speed_of_sound;
    double reduction;  // of the time step, if there is no result
};

int library_tangent(Operator wanted) {
    switch (wanted) {
        case Operator::secant:
        case Operator::tangent: return GRIT_TANGENT_CONTINUUM;
        case Operator::consistent: return GRIT_TANGENT_CONSISTENT;
        default: return GRIT_TANGENT_NONE;
    }
}

// A prediction is the update by no strain.
grit_status update(const Material& material, const Request& request, const Parameters& parameters,
                   Results& results, grit_error& error) {
    constexpr double no_strain[6] = {};
    Point& end = results.end;
    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    options.tolerance = parameters.tolerance;
    options.evaluation_limit = parameters.evaluation_limit;
    options.tangent = library_tangent(request.wanted);
    grit_sand_points views{};
    views.struct_size = sizeof views;
    views.components = 6;
    views.strain_increment =
        grit_view_of(request.prediction ? no_strain : end.strain_increment, 6, 1);
    views.stress = grit_mutable_view_of(end.stress, 6, 1);
    views.state = grit_mutable_view_of(end.state, GRIT_SAND_STATE_SIZE, 1);
    views.tangent = grit_mutable_matrix_view_of(results.C, 36, 6, 1);
    views.substep = grit_mutable_view_of(&end.substep, 1, 1);
    grit_sand_water water = material.water;
    water.pore_pressure = grit_mutable_view_of(&end.pore_pressure, 1, 1);
    water.total_stress = grit_mutable_view_of(end.total, 6, 1);
    grit_sand_report report{};
    report.step_reduction = 1.0;
    const grit_status status =
        grit_sand_update_undrained(&material.sand, &options, &water, 1, &views, &report, &error);
    if (status != GRIT_OK && report.step_reduction < 1.0)
        results.reduction = std::fmax(report.step_reduction, parameters.smallest_reduction);
    return status;
}

grit_status water_stiffness(const Material& material, const Point& point, double& K) {
    return grit_sand_water_stiffness(&material.water, point.pore_pressure,
                                     point.state[GRIT_SAND_VOID_RATIO], &K);
}

// m_R L of (H2), the stiffness inside the range of the intergranular strain, and the water's.
grit_status elastic_operator(const Material& material, Results& results) {
    const Point& end = results.end;
    grit_status status = grit_sand_stiffness(&material.sand, end.stress,
                                             end.state[GRIT_SAND_VOID_RATIO], results.C, nullptr);
    for (double& entry : results.C) entry *= material.elastic_factor;
    double K = 0.0;
    if (status == GRIT_OK) status = water_stiffness(material, end, K);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) results.C[6 * r + c] += K;
    return status;
}

grit_status find_speed_of_sound(const mfront_gb_BehaviourData& call, const Material& material,
                                Results& results, grit_error& error) {
    const double density = *call.s1.mass_density;
    if (!(density > 0.0 && std::isfinite(density)))
        return failure(error, GRIT_BAD_STATE,
                       "mass_density must be > 0 and finite for the speed of sound, got %g",
                       density);
    double modulus = 0.0;
    if (const grit_status s =
            grit_sand_wave_modulus(&material.sand, 0, results.end.stress,
                                   results.end.state[GRIT_SAND_VOID_RATIO], &modulus))
        return failure(error, s, "no wave modulus for this state: %s", grit_status_name(s));
    double K = 0.0;
    if (const grit_status s = water_stiffness(material, results.end, K))
        return failure(error, s, "no stiffness of the water for this state: %s",
                       grit_status_name(s));
    results.speed_of_sound = std::sqrt((modulus + K) / density);
    return GRIT_OK;
}

// Work of the effective stress, per volume. A host that keeps no energies passes null.
void write_energies(const mfront_gb_BehaviourData& call, const Point& start, const Point& end) {
    if (call.s0.stored_energy && call.s1.stored_energy)
        *call.s1.stored_energy = *call.s0.stored_energy;
    if (!call.s0.dissipated_energy || !call.s1.dissipated_energy) return;
    double work = 0.0;
    for (int c = 0; c < 6; ++c)
        work += 0.5 * (start.stress[c] + end.stress[c]) * start.strain_increment[c];
    *call.s1.dissipated_energy = *call.s0.dissipated_energy + work;
}

grit_status compute(const mfront_gb_BehaviourData& call, int n, const Request& request,
                    Point& start, Results& results, grit_error& error) {
    const Parameters parameters = current_parameters();
    results.reduction = parameters.smallest_reduction;
    if (const grit_status s = check_pointers(call, request, error)) return s;
    Material material;
    if (const grit_status s =
            read_material(call.s1.material_properties, parameters, material, error))
        return s;
    start = read_point(call, n, material);
    if (!std::isfinite(start.pore_pressure))
        return failure(error, GRIT_BAD_STATE, "ExcessPorePressure must be finite, got %g",
                       start.pore_pressure);
    const double p = -(start.stress[0] + start.stress[1] + start.stress[2]) / 3.0;
    if (const grit_status s =
            complete_void_ratio(material, p, start.state[GRIT_SAND_VOID_RATIO], error))
        return s;
    results.end = start;
    if (const grit_status s = update(material, request, parameters, results, error)) return s;
    if (request.wanted == Operator::elastic)
        if (const grit_status s = elastic_operator(material, results))
            return failure(error, s, "no elastic operator for this state: %s", grit_status_name(s));
    if (request.speed_of_sound)
        if (const grit_status s = find_speed_of_sound(call, material, results, error)) return s;
    return GRIT_OK;
}

int integrate(const mfront_gb_BehaviourData* call, const Hypothesis& hypothesis) {
    if (!call) return failed;
    grit_error error{};
    Point start{};
    Results results{};
    Request request{};
    grit_status status = call->K ? read_request(call->K[0], request, error)
                                 : failure(error, GRIT_BAD_CALL, "K is a null pointer");
    results.reduction = current_parameters().smallest_reduction;
    if (status == GRIT_OK)
        status = compute(*call, hypothesis.components, request, start, results, error);
    if (status != GRIT_OK) {
        report(*call, hypothesis.name, error, results.reduction);
        return failed;
    }
    if (!request.prediction) {
        write_point(*call, hypothesis.components, start, results.end);
        write_energies(*call, start, results.end);
    }
    // Without an operator K is a scratch of the host, with room for little more than K[0].
    if (request.wanted != Operator::none) write_operator(results.C, hypothesis.components, call->K);
    if (request.speed_of_sound) *call->speed_of_sound = results.speed_of_sound;
    return reliable;
}

}  // namespace
}  // namespace grit::mgis

extern "C" {

// 11 22 33 12 13 23.
__attribute__((visibility("default"))) int GritSand_Tridimensional(mfront_gb_BehaviourData* call) {
    return grit::mgis::integrate(call, {"Tridimensional", 6});
}

// rr zz tt rz.
__attribute__((visibility("default"))) int GritSand_Axisymmetrical(mfront_gb_BehaviourData* call) {
    return grit::mgis::integrate(call, {"Axisymmetrical", 4});
}

// 11 22 33 12, the host keeps strain 33 at zero.
__attribute__((visibility("default"))) int GritSand_PlaneStrain(mfront_gb_BehaviourData* call) {
    return grit::mgis::integrate(call, {"PlaneStrain", 4});
}

// 11 22 33 12, the host finds strain 33.
__attribute__((visibility("default"))) int
GritSand_GeneralisedPlaneStrain(mfront_gb_BehaviourData* call) {
    return grit::mgis::integrate(call, {"GeneralisedPlaneStrain", 4});
}
}
