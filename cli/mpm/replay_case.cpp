// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/replay_case.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <grit/sand_operators.h>

#include "cli/sand/parameter_units.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

namespace mpm = grit::mpm;

constexpr double pascal = 1e-3;  // [kPa]

// State before the increment in the axes after it: the library turns first, then strains.
struct Start {
    double stress[6];
    double state[GRIT_SAND_STATE_SIZE];
    grit_sand_invariants invariants{};
};

Start start_of(const mpm::SandUpdate& update, const grit_sand& sand) {
    Start out{};
    std::copy_n(update.stress, 6, out.stress);
    std::copy_n(update.state, GRIT_SAND_STATE_SIZE, out.state);
    // An improper rotation or a state that is not finite leaves them as they were.
    grit_sand_rotate(update.rotation, out.stress, out.state);
    out.invariants.struct_size = sizeof out.invariants;
    grit_sand_invariants_of(&sand, out.stress, out.state, &out.invariants);
    return out;
}

std::string sand_table(const grit_sand& sand) {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_parameters_of(&sand, &parameters);
    std::string out = "[sand]\n";
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        double value = 0.0;
        grit_sand_parameter_get(&parameters, i, &value);
        if (std::isnan(value)) continue;  // no intergranular strain
        const Unit unit = unit_of(info);
        value *= (unit.name == "kPa" ? pascal : 1.0) / unit.size;
        out +=
            fmt::format("{}{} = {}\n", info.name, unit.name == "-" ? "" : "_" + unit.name, value);
    }
    return out;
}

std::string start_table(const Start& start, bool intergranular) {
    std::string out = "\n[start]\n";
    if (start.state[GRIT_SAND_SEPARATION] > 0.0)
        out += fmt::format("# The particle was separated by {}; here it is not.\n",
                           start.state[GRIT_SAND_SEPARATION]);
    if (!(start.stress[0] + start.stress[1] + start.stress[2] < 0.0))
        out += "# The particle bore no pressure, where grit element does not start.\n";
    double stress_kPa[6];
    std::transform(start.stress, start.stress + 6, stress_kPa, [](double x) { return pascal * x; });
    out += fmt::format("stress_kPa = [{}]\nvoid_ratio = {}\n", fmt::join(stress_kPa, ", "),
                       start.state[GRIT_SAND_VOID_RATIO]);
    if (!intergranular) return out + "intergranular_strain = \"off\"\n";
    double direction[6], longest = 0.0;
    for (const double h : std::span(start.state, 6)) longest = std::max(longest, std::abs(h));
    if (!(longest > 0.0)) return out + "intergranular_strain = \"zero\"\n";
    std::transform(start.state, start.state + 6, direction, [&](double h) { return h / longest; });
    return out + fmt::format("intergranular_strain = \"mobilised\"\n"
                             "intergranular_direction = [{}]\nintergranular_rho = {}\n",
                             fmt::join(direction, ", "), std::min(start.invariants.rho, 1.0));
}

std::string stage_table(const mpm::SandUpdate& update) {
    const double* e = update.strain;
    const bool beyond = std::any_of(e, e + 6, [](double x) { return !(std::abs(x) <= 1.0); });
    return (beyond ? "\n# Strains beyond 1, which grit element takes for percent.\n" : "") +
           fmt::format("\n[[stage]]\ntest = \"components\"\nincrements = 1\nfirst_share = 1\n"
                       "strain = {{11 = {}, 22 = {}, 33 = {}, 12 = {}, 13 = {}, 23 = {}}}\n",
                       e[0], e[1], e[2], e[3], e[4], e[5]);
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

}  // namespace

ReplayedSand::ReplayedSand(const mpm::Sand& sand)
    : prepared(sand.prepared()), options(sand.update_options()), axes("11 = r, 22 = z, 33 = hoop") {
}

ReplayedSand::ReplayedSand(const mpm::space::Sand& sand)
    : prepared(sand.prepared()), options(sand.update_options()), axes("11 = x, 22 = y, 33 = z") {}

std::string replay_case(const mpm::SandUpdate& update, const ReplayedSand& sand,
                        const std::string& title) {
    const grit_sand_options& options = sand.options;
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_parameters_of(&sand.prepared, &parameters);
    const bool intergranular =
        !options.intergranular_off && !std::isnan(parameters.elastic_strain_radius);
    return fmt::format("# {}\n# One update of a material point, {}, in the "
                       "axes of its end.\n",
                       one_line(title), sand.axes) +
           sand_table(sand.prepared) + start_table(start_of(update, sand.prepared), intergranular) +
           stage_table(update) +
           fmt::format("\n[numerics]\ntolerance = {}\nevaluation_limit = {}\n"
                       "smallest_part = 1\n",
                       options.tolerance, options.evaluation_limit);
}

namespace {

template <class SandOf, class Simulated>
void write_replay(const std::filesystem::path& place, const mpm::MaterialFailure& failure,
                  Simulated& simulation) {
    const auto* sand = dynamic_cast<const SandOf*>(simulation.body(failure.body()).material.get());
    if (!sand) throw std::invalid_argument("the body that failed is not of sand");
    element::AtomicFile file(place);
    file.write(replay_case(failure.update(), *sand, failure.what()));
    file.complete();
}

}  // namespace

void write_replay_case(const std::filesystem::path& place, const mpm::MaterialFailure& failure,
                       mpm::Simulation& simulation) {
    write_replay<mpm::Sand>(place, failure, simulation);
}

void write_replay_case(const std::filesystem::path& place, const mpm::MaterialFailure& failure,
                       mpm::space::Simulation& simulation) {
    write_replay<mpm::space::Sand>(place, failure, simulation);
}

}  // namespace cli
