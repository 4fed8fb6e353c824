// SPDX-License-Identifier: BSD-3-Clause
// saturated_drive FILE...: runs cases of piles and prints what of the water's mass is missing: what particles have less of than
// at the start and has not crossed surfaces or sides. A table of docs/saturated.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>

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
        worst = std::max(worst, std::fabs(start - gone - now) / start);
    }
};

std::size_t body_with_water(const Simulation& simulation) {
    std::size_t i = 0;
    while (!simulation.body(i).water || !simulation.body(i).water->flows) ++i;
    return i;
}

void drive(const std::filesystem::path& file) {
    Runner runner(cli::read_mpm_case(file).plan);
    Simulation& simulation = runner.simulation();
    const std::size_t body = body_with_water(simulation);
    Ledger ledger{water_mass(simulation)};
    long steps = 0;
    while (!runner.finished()) {
        const std::vector<NodeRecord> surface = areas(simulation, body);
        const double t = simulation.time();
        runner.step();
        ledger.take(left(simulation, body, surface, simulation.time() - t), water_mass(simulation));
        if (runner.row_is_due()) runner.row();
        ++steps;
    }
    std::printf("| %s | %ld | %.0f | %.3g | %.2g | %.1e |\n", file.stem().c_str(), steps,
                1e3 * runner.depth(), ledger.start, ledger.turned_over / ledger.start,
                ledger.worst);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** files) {
    std::printf("| case | steps | driven by [mm] | water [kg/rad] | crossed surfaces, in and out, "
                "by that | most that is "
                "missing, by that |\n|---|---|---|---|---|---|\n");
    try {
        for (int i = 1; i < count; ++i) drive(files[i]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "saturated_drive: %s\n", error.what());
        return 1;
    }
}
