// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/tables/rows.hpp"

#include <algorithm>
#include <cstdio>

#include <grit/radian_layout.h>
#include <grit/sand.h>

#define WRITTEN(number) #number
#define AS_WRITTEN(macro) WRITTEN(macro)

namespace grit::abaqus {
namespace {

std::string number(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", x);
    return buffer;
}

// Limits of a parameter of the library, by its symbol there, in a unit.
std::string limits(const char* symbol, double unit = 1.0) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        if (std::string(info.symbol) == symbol)
            return number(info.lowest / unit) + " … " + number(info.highest / unit);
    }
    return "?";
}

Row parameter(const char* symbol, const char* plain, const char* unit, const char* meaning,
              std::string range) {
    Row row{};
    row.symbol = symbol;
    row.plain_symbol = plain;
    row.unit = unit;
    row.meaning = meaning;
    row.range = std::move(range);
    return row;
}

// In the order of the classic PROPS.
std::vector<Row> parameters(bool radian) {
    return {
        parameter("φ_c", "phi_c", radian ? "radian" : "degree", "critical friction angle",
                  limits("phi_c", radian ? 1.0 : GRIT_DEGREE)),
        parameter("p_t", "p_t", "stress", "shift of the mean pressure; 0 for none", "≥ 0"),
        parameter("h_s", "h_s", "stress", "granulate hardness", "> 0"),
        parameter("n", "n", "–", "exponent of compression", limits("n")),
        parameter("e_d0", "e_d0", "–", "densest void ratio at zero pressure", "< e_c0"),
        parameter("e_c0", "e_c0", "–", "critical void ratio at zero pressure", "< e_i0"),
        parameter("e_i0", "e_i0", "–", "loosest void ratio at zero pressure", "≤ 5"),
        parameter("α", "alpha", "–", "pyknotropy exponent", limits("alpha")),
        parameter("β", "beta", "–", "stiffness exponent of the void ratio", limits("beta")),
        parameter(
            "m_R", "m_R", "–",
            "stiffness after reversal; ≤ 0.5: intergranular strain off, the other four not read",
            limits("m_R")),
        parameter("m_T", "m_T", "–", "stiffness after a turn by 90°", "1 … m_R"),
        parameter("R", "R", "–", "radius of the elastic strain range", limits("R")),
        parameter("β_r", "beta_r", "–", "evolution of the intergranular strain", limits("beta_r")),
        parameter("χ", "chi", "–", "interpolation of the stiffness", limits("chi")),
        parameter("K_w", "K_w", "stress",
                  "bulk stiffness of the pore water in the mixture, K_water/n_porosity; 0: drained",
                  "≥ 0"),
        parameter("e_0", "e_0", "–", "initial void ratio, see docs/umat.md", "> 0 if used"),
        parameter(
            "tol", "tol", "–",
            "tolerance of the stress; may be missing; 0: " AS_WRITTEN(GRIT_SAND_DEFAULT_TOLERANCE),
            "0 or " AS_WRITTEN(GRIT_SAND_LEAST_TOLERANCE) " … " AS_WRITTEN(
                GRIT_SAND_LARGEST_TOLERANCE)),
        parameter("p_cav", "p_cav", "stress",
                  "largest tension of the pore water; may be missing; 0: it never cavitates",
                  "≥ 0"),
        parameter("", "K_w itself", "–",
                  "may be missing; 1: K_w is that of the water itself, in the pores as they are",
                  "0, 1")};
}

Row state(int first, int last, const char* symbol, const char* plain, const char* meaning,
          const char* in, const char* out) {
    Row row{};
    row.first = first + 1;
    row.last = last + 1;
    row.symbol = symbol;
    row.plain_symbol = plain;
    row.meaning = meaning;
    row.in = in;
    row.out = out;
    return row;
}

}  // namespace

std::vector<Row> props_rows(LayoutName layout) {
    const bool radian = layout == LayoutName::radian;
    std::vector<Row> rows = parameters(radian);
    if (radian) {
        // Where the conversion that the library uses puts each of the classic places.
        double numbered[GRIT_CLASSIC_NPROPS], placed[GRIT_CLASSIC_NPROPS];
        for (int i = 0; i < GRIT_CLASSIC_NPROPS; ++i) numbered[i] = i == 1 ? 0.0 : i;
        grit_radian_of_classic(numbered, placed);
        const std::vector<Row> classic = rows;
        for (int i = 0; i < GRIT_CLASSIC_NPROPS; ++i)
            rows[static_cast<std::size_t>(i)] = classic[static_cast<std::size_t>(placed[i])];
        rows[GRIT_RADIAN_POISSON_RATIO] = parameter(
            "ν", "nu", "–", "Poisson's ratio of other laws of the family: not used", "0 … 0.5");
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].first = rows[i].last = static_cast<int>(i) + 1;
    return rows;
}

std::vector<Row> statev_rows(LayoutName layout) {
    const bool radian = layout == LayoutName::radian;
    const int e = radian ? int{GRIT_RADIAN_VOID_RATIO} : int{GRIT_CLASSIC_VOID_RATIO};
    const int h = radian ? int{GRIT_RADIAN_INTERGRANULAR_STRAIN} : 0;
    std::vector<Row> rows = {
        state(h, h + 5, "h", "h",
              "intergranular strain, 11 22 33 12 13 23, engineering shear; ‖h‖ ≤ R", "h", "h"),
        state(e, e, "e", "e", "void ratio, or below 0.001: from e_0", "e", "e"),
        state(GRIT_CLASSIC_PORE_STRESS, GRIT_CLASSIC_PORE_STRESS, "−p_w", "-p_w",
              "minus the excess pore pressure (compression positive)", "−p_w", "−p_w"),
        state(GRIT_CLASSIC_PRESSURE, GRIT_CLASSIC_PRESSURE, "p′", "p'",
              "effective mean pressure, compression positive", "–", "p′"),
        state(GRIT_CLASSIC_EVALUATIONS, GRIT_CLASSIC_EVALUATIONS, "", "evaluations",
              "evaluations of the stress rate in this call; −1: a point of a VUMAT that failed",
              "–", "count"),
        state(GRIT_CLASSIC_MOBILISED_ANGLE, GRIT_CLASSIC_MOBILISED_ANGLE, "φ_mob", "phi_mob",
              radian ? "mobilised friction angle, radian" : "mobilised friction angle, degree", "–",
              "φ_mob"),
        state(GRIT_CLASSIC_RHO, GRIT_CLASSIC_RHO, "ρ", "rho", "‖h‖/R", "–", "ρ"),
        state(GRIT_CLASSIC_SUBSTEP, GRIT_CLASSIC_SUBSTEP, "", "substep",
              "length of the first substep to try [strain], 0: none", "advice",
              "for the next call"),
        state(GRIT_CLASSIC_SEPARATION, GRIT_CLASSIC_SEPARATION, "w", "w",
              "volumetric strain by which a stress-free point has opened, ≥ 0", "w", "w")};
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return a.first < b.first; });
    return rows;
}

}  // namespace grit::abaqus
