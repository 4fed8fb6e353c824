// SPDX-License-Identifier: BSD-3-Clause
#include "cli/cycles.hpp"

#include <cmath>

namespace cli {
namespace {

constexpr double pi = 3.14159265358979323846;

// Rows of a stage where the shear strain turns, its last row included.
std::vector<std::size_t> turns(const std::vector<double>& gamma, std::size_t first,
                               std::size_t last) {
    std::vector<std::size_t> out;
    double direction = 0.0;
    for (std::size_t i = first + 1; i <= last; ++i) {
        const double step = gamma[i] - gamma[i - 1];
        if (step * direction < 0.0) out.push_back(i - 1);
        if (step != 0.0) direction = step;
    }
    if (!out.empty()) out.push_back(last);
    return out;
}

struct Loop {
    double area = 0.0, G = 0.0, amplitude = 0.0;
};

Loop loop_of(const std::vector<double>& tau, const std::vector<double>& gamma, std::size_t a,
             std::size_t b, std::size_t c) {
    Loop out;
    for (std::size_t i = a + 1; i <= c; ++i)
        out.area += 0.5 * (tau[i] + tau[i - 1]) * (gamma[i] - gamma[i - 1]);
    out.amplitude = 0.5 * std::abs(gamma[b] - gamma[a]);
    out.G = (tau[b] - tau[a]) / (gamma[b] - gamma[a]);
    return out;
}

}  // namespace

Table cycles_of(const Table& result, const std::vector<bool>& cyclic) {
    const auto& stage = result.at("stage");
    const auto& gamma = result.at("shear_strain");
    const auto& tau = result.at("shear_stress");
    Table out;
    out.columns = {{"stage", "", {}},        {"cycle", "", {}},  {"gamma_amplitude", "-", {}},
                   {"secant_G", "kPa", {}},  {"G/G_0", "-", {}}, {"damping", "-", {}},
                   {"shear_strain", "-", {}}};
    std::vector<const std::vector<double>*> state;
    for (const char* name :
         {"axial_strain", "volumetric_strain", "p", "void_ratio", "pore_pressure"})
        for (const Column& column : result.columns)
            if (column.name == name) {
                out.columns.push_back({column.name, column.unit, {}});
                state.push_back(&column.values);
            }
    const auto& G_0 = result.at("G_0");
    for (std::size_t number = 1; number <= cyclic.size(); ++number) {
        if (!cyclic[number - 1]) continue;
        std::size_t first = stage.size(), last = 0;
        for (std::size_t i = 0; i < stage.size(); ++i)
            if (stage[i] == static_cast<double>(number)) {
                first = std::min(first, i);
                last = i;
            }
        if (first >= last) continue;
        if (first > 0) --first;  // the stage begins where the one before ended
        const std::vector<std::size_t> at = turns(gamma, first, last);
        double cycle = 0.0;
        for (std::size_t k = 0; k + 2 < at.size(); k += 2) {
            const Loop loop = loop_of(tau, gamma, at[k], at[k + 1], at[k + 2]);
            const double values[] = {static_cast<double>(number),
                                     ++cycle,
                                     loop.amplitude,
                                     loop.G,
                                     loop.G / G_0[at[k]],
                                     loop.area /
                                         (2.0 * pi * loop.G * loop.amplitude * loop.amplitude),
                                     gamma[at[k + 2]]};
            for (std::size_t c = 0; c < std::size(values); ++c)
                out.columns[c].values.push_back(values[c]);
            for (std::size_t c = 0; c < state.size(); ++c)
                out.columns[std::size(values) + c].values.push_back((*state[c])[at[k + 2]]);
        }
    }
    if (out.rows() == 0) return {};
    out.comments = {
        "a cycle: from a reversal of shear_strain to the second after it; secant_G from "
        "tip to tip; G_0 at the first; damping = loop area/(2 pi G gamma_amplitude^2); "
        "the state at its end"};
    return out;
}

}  // namespace cli
