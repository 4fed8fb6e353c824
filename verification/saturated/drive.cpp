// SPDX-License-Identifier: BSD-3-Clause
// saturated_drive FILE...: runs cases of piles in sand whose water flows, and prints what of the water's mass is missing: what
// particles have less of than at the start and has not crossed surfaces or sides. A table of docs/saturated.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <adapters/mpm/run/measures.hpp>
#include <adapters/mpm/run/run.hpp>
#include <tests/mpm/support/leaving_water.hpp>

#include "cli/mpm/case_file.hpp"

namespace {

using namespace mpm_test;

// Of the mass at the start, per radian.
struct Ledger {
    double start, gone = 0.0, turned_over = 0.0, worst = 0.0;
    void take(double left, double now) {
        gone += left;
        turned_over += std::fabs(left);
        const double missing = std::fabs(start - gone - now) / start;
        if (!std::isfinite(missing)) throw std::runtime_error("its water's mass is no number");
        worst = std::max(worst, missing);
    }
};

std::size_t body_with_water(const Simulation& simulation) {
    std::size_t found = simulation.bodies();
    for (std::size_t i = 0; i < simulation.bodies(); ++i) {
        if (!simulation.body(i).water || !simulation.body(i).water->flows) continue;
        if (found < simulation.bodies()) throw std::invalid_argument("water flows in two bodies");
        found = i;
    }
    if (found == simulation.bodies()) throw std::invalid_argument("no body has water that flows");
    return found;
}

void drive(const std::filesystem::path& file) {
    Runner runner(cli::read_mpm_case(file).plan);
    if (runner.space()) throw std::invalid_argument("a case in space: none has water");
    Simulation& simulation = runner.simulation();
    const std::size_t body = body_with_water(simulation);
    Ledger ledger{water_mass(simulation)};
    while (!runner.finished()) {
        const std::vector<NodeRecord> surface = areas(simulation, body);
        runner.step();
        ledger.take(left(simulation, body, surface, runner.state().last_dt),
                    water_mass(simulation));
        if (runner.row_is_due()) runner.row();
    }
    std::printf("| %s | %ld | %.0f | %.4g | %.2g | %.1e |\n", file.stem().c_str(),
                simulation.steps(), 1e3 * runner.depth(), ledger.start,
                ledger.turned_over / ledger.start, ledger.worst);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** files) {
    if (count < 2) {
        std::fprintf(stderr, "usage: saturated_drive FILE...\n");
        return 2;
    }
    std::printf("| case | steps | driven by [mm] | water [kg/rad] | net across surfaces in each "
                "step, sum of sizes, by that "
                "| most that was missing, by that |\n|---|---|---|---|---|---|\n");
    for (int i = 1; i < count; ++i) try {
            drive(files[i]);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "saturated_drive: %s: %s\n", files[i], error.what());
            return 1;
        }
}
