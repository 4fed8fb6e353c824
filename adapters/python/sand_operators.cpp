// SPDX-License-Identifier: BSD-3-Clause
// One point at a time: for insight and set-up.
#include <cmath>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"

namespace grit_python {
namespace {

py::tuple stiffness(const Sand& sand, const py::object& stress, double void_ratio) {
    Numbers L({6, 6}), N(6);
    check(grit_sand_stiffness(&sand.prepared, few("stress", stress, 6).data(), void_ratio,
                              L.mutable_data(), N.mutable_data()),
          "stiffness: stress and void_ratio > 0 must be finite");
    return py::make_tuple(L, N);
}

py::tuple rate(const Sand& sand, const py::object& stress, const py::object& state,
               const py::object& D, bool intergranular_strain) {
    Numbers stress_rate(6), state_rate(GRIT_SAND_STATE_SIZE);
    check(grit_sand_rate(&sand.prepared, !intergranular_strain, few("stress", stress, 6).data(),
                         few("state", state, GRIT_SAND_STATE_SIZE).data(), few("D", D, 6).data(),
                         stress_rate.mutable_data(), state_rate.mutable_data()),
          "rate: stress, state and D must be finite, e > 0, |h| at most 1.01 R");
    return py::make_tuple(stress_rate, state_rate);
}

py::dict invariants(const Sand& sand, const py::object& stress, const py::object& state) {
    grit_sand_invariants v{};
    v.struct_size = sizeof v;
    check(grit_sand_invariants_of(&sand.prepared, few("stress", stress, 6).data(),
                                  few("state", state, GRIT_SAND_STATE_SIZE).data(), &v),
          "invariants: stress and state must be finite, e > 0");
    py::dict out;
    out["p"] = v.p;
    out["q"] = v.q;
    out["lode_angle"] = v.lode_angle;
    out["tan_psi"] = v.tan_psi;
    out["mobilised_friction_angle"] = v.mobilised_friction_angle;
    out["rho"] = v.rho;
    out["relative_density"] = v.relative_density;
    return out;
}

py::tuple void_ratios(const Sand& sand, double p) {
    double e[3];
    check(grit_sand_void_ratios(&sand.prepared, p, e), "void_ratios: p must be finite, >= 0");
    return py::make_tuple(e[0], e[1], e[2]);
}

double void_ratio_at_pressure(const Sand& sand, double e_0, double p) {
    double e = 0.0;
    check(grit_sand_void_ratio_at_pressure(&sand.prepared, e_0, p, &e),
          "void_ratio_at_pressure: e_0 must be > 0 [-], p >= 0 [stress]");
    return e;
}

double wave_modulus(const Sand& sand, const py::object& stress, double void_ratio,
                    bool intergranular_strain) {
    double modulus = 0.0;
    check(grit_sand_wave_modulus(&sand.prepared, !intergranular_strain,
                                 few("stress", stress, 6).data(), void_ratio, &modulus),
          "wave_modulus: stress and void_ratio > 0 must be finite");
    return modulus;
}

Numbers stress_at_rest(const Sand& sand, double unit_weight, double depth, double surcharge,
                       double K0, int axis) {
    const auto check_positive = [](const char* name, double value, const char* unit) {
        if (!(value >= 0.0) || !std::isfinite(value))
            refuse("%s must be >= 0 and finite [%s], got %g", name, unit, value);
    };
    check_positive("unit_weight", unit_weight, "stress/length");
    check_positive("depth", depth, "length");
    check_positive("surcharge", surcharge, "stress");
    if (!std::isfinite(K0)) refuse("K0 must be finite, got %g", K0);
    if (axis < 0 || axis > 2) refuse("axis must be 0, 1 or 2, got %d", axis);
    Numbers stress(6);
    check(grit_sand_stress_at_rest(&sand.prepared, unit_weight, depth, surcharge, K0, axis,
                                   stress.mutable_data()),
          "stress_at_rest: the vertical stress must be finite");
    return stress;
}

Numbers new_state(const Sand& sand, double void_ratio, const py::object& direction, double rho) {
    Numbers state(GRIT_SAND_STATE_SIZE);
    std::fill_n(state.mutable_data(), GRIT_SAND_STATE_SIZE, 0.0);
    if (!(void_ratio > 0.0 && void_ratio < 1e300))
        refuse("void_ratio must be > 0, got %g", void_ratio);
    state.mutable_at(GRIT_SAND_VOID_RATIO) = void_ratio;
    if (direction.is_none() && rho != 1.0)
        refuse("rho is of a direction: give one, got rho = %g", rho);
    if (!direction.is_none())
        check(grit_sand_mobilise(&sand.prepared, few("direction", direction, 6).data(), rho,
                                 state.mutable_data()),
              "state: direction must be finite and not zero, rho in [0, 1], for a sand with "
              "intergranular strain");
    return state;
}

}  // namespace

void add_sand_operators(py::class_<Sand>& sand) {
    using py::arg;
    sand.def("state", &new_state, arg("void_ratio"), arg("direction") = py::none(),
             arg("rho") = 1.0,
             "State (8,) of a new point: h = rho R along a strain direction (6,), e.g. "
             "[-1, -1, -1, 0, 0, 0] after isotropic compression; without direction h = 0.");
    sand.def(
        "stiffness", &stiffness, arg("stress"), arg("void_ratio"),
        "L (6, 6) and N (6,) [stress]: stress rate = L D + N |D| in Voigt components, at a stress "
        "(6,), tension +, and a void ratio [-]. |D| is the tensor's: |D|^2 = D11^2 + D22^2 + D33^2 "
        "+ (D12^2 + D13^2 + D23^2)/2 with shears that are twice the tensor's.");
    sand.def("rate", &rate, arg("stress"), arg("state"), arg("D"),
             arg("intergranular_strain") = true,
             "Rates of stress (6,) and state (8,) for the strain rate D (6,), extension +.");
    sand.def("invariants", &invariants, arg("stress"), arg("state"),
             "p, q [stress, compression +], lode_angle [rad], tan_psi, mobilised_friction_angle "
             "[rad], rho = |h|/R, relative_density.");
    sand.def("void_ratios", &void_ratios, arg("p"),
             "(e_i, e_c, e_d) at the pressure p [stress, compression +].");
    sand.def("void_ratio_at_pressure", &void_ratio_at_pressure, arg("e_0"), arg("p"),
             "e at the pressure p [stress, compression +] from e_0 at zero pressure.");
    sand.def("wave_modulus", &wave_modulus, arg("stress"), arg("void_ratio"),
             arg("intergranular_strain") = true,
             "Upper bound of the P-wave modulus [stress], for an explicit time step.");
    sand.def("stress_at_rest", &stress_at_rest, arg("unit_weight"), arg("depth"),
             arg("surcharge") = 0.0, arg("K0") = -1.0, arg("axis") = 2,
             "Stress (6,), tension +, under unit_weight [stress/length] at depth [length]; K0 < 0: "
             "1 - sin phi_c.");
}

}  // namespace grit_python
