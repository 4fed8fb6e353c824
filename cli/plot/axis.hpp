// SPDX-License-Identifier: BSD-3-Clause
// How a column of results is drawn: as a laboratory does, compression positive, strains in percent.
#pragma once

#include <string>

namespace cli {

// Values times factor; the label is marked up as gnuplot's enhanced text: a_{11}.
struct Axis {
    const char* column;
    double factor;
    const char* label;
    bool from_zero = false;
    bool log = false;
};

namespace axis {
constexpr Axis eps_a = {"axial_strain", -100.0, "axial compression −ε_{11} [%]"};
constexpr Axis eps_v = {"volumetric_strain", -100.0, "volumetric compression −ε_v [%]"};
constexpr Axis q = {"axial_deviator", 1.0, "q = σ_a − σ_r [kPa]"};
constexpr Axis p = {"p", 1.0, "effective mean pressure p [kPa]"};
constexpr Axis log_p = {"p", 1.0, "effective mean pressure p [kPa]", false, true};
constexpr Axis e = {"void_ratio", 1.0, "void ratio e [–]"};
constexpr Axis pw = {"pore_pressure", 1.0, "excess pore pressure [kPa]"};
constexpr Axis phi = {"mobilised_friction", 1.0, "mobilised friction [°]"};
constexpr Axis log_sigma_a = {"stress_11", -1.0, "axial stress −σ_{11} [kPa]", false, true};
constexpr Axis sigma_a = {"stress_11", -1.0, "axial stress −σ_{11} [kPa]"};
constexpr Axis gamma_12 = {"gamma_12", 100.0, "shear strain γ [%]"};
constexpr Axis tau_12 = {"stress_12", 1.0, "shear stress τ [kPa]"};
constexpr Axis sigma_n = {"stress_22", -1.0, "normal stress −σ_{22} [kPa]"};
constexpr Axis gamma = {"shear_strain", 100.0, "shear strain γ [%]"};
constexpr Axis tau = {"shear_stress", 1.0, "shear stress τ [kPa]"};
constexpr Axis amplitude = {"gamma_amplitude", 1.0, "shear strain amplitude [–]", false, true};
constexpr Axis ratio = {"G/G_0", 1.0, "G/G_0 [–]", true};
constexpr Axis damping = {"damping", 1.0, "damping ratio [–]", true};
// Over the cycles, the state at the end of each.
constexpr Axis cycle = {"cycle", 1.0, "cycle N [–]"};
constexpr Axis pore_ratio = {"u/p0", 1.0, "excess pore pressure u/p_0 [–]", true};
constexpr Axis amplitude_of_cycle = {"gamma_amplitude", 100.0, "shear strain amplitude [%]", true};
constexpr Axis secant = {"secant_G", 1.0, "secant shear modulus G [kPa]", true};
}  // namespace axis

// The column's axis without a logarithm; null: none of the above.
const Axis* axis_of(const std::string& column);

}  // namespace cli
