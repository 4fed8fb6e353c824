// SPDX-License-Identifier: BSD-3-Clause
// Prints what columns of saturated sand do and what is known of it: the tables of docs/saturated.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include <tests/mpm/support/mandel_slab.hpp>
#include <tests/mpm/support/saturated_column.hpp>
#include <tests/mpm/support/saturated_disk.hpp>

namespace {

using namespace mpm_test;
using Column = SaturatedColumn;

void row(const char* what, int cells, double found, double exact) {
    std::printf("| %s | %d | %.5g | %.5g | %+.3f %% |\n", what, cells, found, exact,
                100.0 * (found / exact - 1.0));
    std::fflush(stdout);
}

double ratio(double c) {
    return Column::K_w * (1.0 - Column::n) / Column::n / (c * c * Column::rho_w - Column::K_w);
}

void waves() {
    std::printf("| wave | cells | found [m/s] | exact [m/s] | error |\n|---|---|---|---|---|\n");
    for (const int cells : {16, 32, 64}) {
        row("undrained, c_u", cells, standing_wave({.cells = cells}, 1.0).speed, Column::c_u());
        row("k = 1e-9 m/s, c_u", cells,
            standing_wave({.cells = cells, .conductivity = 1e-9}, 1.0).speed, Column::c_u());
        row("k = 1e5 m/s, c_1", cells,
            standing_wave({.cells = cells, .conductivity = 1e5}, ratio(Column::c_1())).speed,
            Column::c_1());
        row("k = 1e5 m/s, c_2", cells,
            standing_wave({.cells = cells, .conductivity = 1e5}, ratio(Column::c_2())).speed,
            Column::c_2());
    }
}

// An error and its order against that of half as many cells, if there was one.
std::string with_order(double error, double of_half, const char* format) {
    char text[64], order[32] = "";
    std::snprintf(text, sizeof text, format, error);
    if (of_half > 0.0)
        std::snprintf(order, sizeof order, ", %.1f", observed_order(of_half, std::fabs(error)));
    return text + std::string(order);
}

// In water so slow that its mass delays nothing: with k = 1e-3 m/s T is 3e-4 behind, which is the error of 32 cells.
void terzaghi(bool implicit) {
    std::printf(
        "\n| cells | T | p/p_0, lowest cell | exact | error | U | exact | error, order | all "
        "cells, RMS of p/p_0, order "
        "| alternating p/p_0 | energy residual |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::vector<Consolidation> before;
    for (const int cells : {8, 16, 32}) {
        const std::vector<Consolidation> all = consolidate(
            {.cells = cells, .conductivity = 1e-4, .implicit = implicit}, {0.1, 0.2, 0.5, 1.0});
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Consolidation& c = all[i];
            const auto of_settlement = [](const Consolidation& x) {
                return 100.0 * (x.settlement / x.exact_settlement - 1.0);
            };
            std::printf(
                "| %d | %.1f | %.4f | %.4f | %+.2f %% | %.4f | %.4f | %s | %s | %.0e | %+.1e |\n",
                cells, c.T, c.pressure, c.exact_pressure,
                100.0 * (c.pressure / c.exact_pressure - 1.0), c.settlement, c.exact_settlement,
                with_order(of_settlement(c),
                           before.empty() ? 0.0 : std::fabs(of_settlement(before[i])), "%+.3f %%")
                    .c_str(),
                with_order(c.profile_error, before.empty() ? 0.0 : before[i].profile_error, "%.1e")
                    .c_str(),
                c.alternating, c.residual);
        }
        std::fflush(stdout);
        before = all;
    }
}

void disk() {
    std::printf("\n| cells | T | p/p_0 in the middle | exact | error | alternating p/p_0 | energy "
                "residual |\n"
                "|---|---|---|---|---|---|---|\n");
    for (const int cells : {8, 16, 32})
        for (const SaturatedDisk::Result& r :
             SaturatedDisk{.cells = cells}.run({0.05, 0.1, 0.2, 0.5})) {
            std::printf("| %d | %.2f | %.4f | %.4f | %+.2f %% | %.0e | %+.1e |\n", cells, r.T,
                        r.pressure, r.exact, 100.0 * (r.pressure / r.exact - 1.0), r.alternating,
                        r.residual);
            std::fflush(stdout);
        }
}

// The implicit pressure in slower water, beside whose flow nothing swings.
void mandel() {
    std::printf(
        "\n| pressure | k [m/s] | cells | T | p/p_0 in the middle | exact | error | all "
        "cells, RMS of p/p_0, order "
        "| alternating p/p_0 | energy residual |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const bool implicit : {false, true}) {
        std::vector<MandelSlab::Result> before;
        for (const int cells : {8, 16, 32}) {
            const MandelSlab slab{
                .cells = cells, .conductivity = implicit ? 2e-5 : 1e-4, .implicit = implicit};
            const std::vector<MandelSlab::Result> all = slab.run({0.1, 0.2, 0.5, 1.0});
            for (std::size_t i = 0; i < all.size(); ++i) {
                const MandelSlab::Result& r = all[i];
                std::printf(
                    "| %s | %.0e | %d | %.1f | %.4f | %.4f | %+.2f %% | %s | %.0e | %+.1e |\n",
                    implicit ? "implicit" : "explicit", slab.conductivity, cells, r.T, r.pressure,
                    r.exact, 100.0 * (r.pressure / r.exact - 1.0),
                    with_order(r.profile_error, before.empty() ? 0.0 : before[i].profile_error,
                               "%.1e")
                        .c_str(),
                    r.alternating, r.residual);
            }
            std::fflush(stdout);
            before = all;
        }
    }
}

// Of a column under a load that comes within 20 ms: after 30 ms.
void conductivities(bool implicit) {
    std::printf(
        "\n| k [m/s] | Δt [µs] | largest p/p_0 | settlement / load·L/E | alternating p/p_0 | "
        "energy residual |\n|---|---|---|---|---|---|\n");
    constexpr double load = 1e4;
    for (const double k : {0.0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
        const Column column{.conductivity = k, .implicit = implicit, .load = load, .ramp = 0.02};
        const Loaded now = after_a_load(column);
        std::printf("| %s%.0e | %.3f | %.4f | %.4f | %.0e | %+.1e |\n",
                    k > 0.0 ? "" : "undrained: ", k, 1e6 * now.dt,
                    now.largest_pressure / Column::p_0(load),
                    now.settlement / (load * column.height / column.E),
                    now.alternating / Column::p_0(load), now.residual);
        std::fflush(stdout);
    }
}

// The other limit: two seconds after that load, when water that flows bears nothing any more.
void drained(bool implicit) {
    std::printf("\n| k [m/s] | largest p/p_0 | settlement / load·L/E |\n|---|---|---|\n");
    constexpr double load = 1e3;
    for (const double k : {1e-3, 1e-2, 1e-1}) {
        const Column column{.conductivity = k, .implicit = implicit, .load = load, .ramp = 0.02};
        const Loaded now = after_a_load(column, 2.0);
        std::printf("| %.0e | %.4f | %.4f |\n", k, now.largest_pressure / Column::p_0(load),
                    now.settlement / (load * column.height / column.E));
        std::fflush(stdout);
    }
}

// A block on rollers, half of whose top is loaded within 20 ms, after 30 ms.
void block(bool implicit) {
    constexpr int cells = 24;
    constexpr double load = 1e4;
    std::printf(
        "\n| block of %d by %d cells | p [kPa] | checkerboard by the load, largest | RMS | energy "
        "residual |\n|---|---|---|---|---|\n",
        cells, cells);
    for (const bool axisymmetric : {false, true})
        for (const double k : {0.0, 1e-4}) {
            Column column{.cells = cells,
                          .conductivity = k,
                          .axisymmetric = axisymmetric,
                          .implicit = implicit,
                          .load = load,
                          .ramp = 0.02};
            Case plan = column.plan();
            plan.r = {0.0, {{column.height, cells, 1.0}}};
            plan.bodies[0].outlines[0].corners = {{0.0, 0.0},
                                                  {column.height, 0.0},
                                                  {column.height, column.height},
                                                  {0.0, column.height}};
            plan.bodies[0].material = ElasticPlan{Column::E, 0.3};
            plan.tractions[0].r[1] = 0.5 * column.height;
            BuiltCase built = build_case(plan);
            Simulation& simulation = *built.simulation;
            while (simulation.time() < 0.03) simulation.step();
            const std::vector<double> p = pore_pressures(simulation, cells, cells);
            constexpr double weight[] = {1.0, -4.0, 6.0, -4.0, 1.0};
            double largest = 0.0, squares = 0.0;
            int count = 0;
            for (int j = 2; j + 2 < cells; ++j)
                for (int i = 2; i + 2 < cells; ++i, ++count) {
                    double sum = 0.0;
                    for (int m = 0; m < 5; ++m)
                        for (int l = 0; l < 5; ++l)
                            sum += weight[m] * weight[l] / 256.0 *
                                   p[static_cast<std::size_t>((j + m - 2) * cells + i + l - 2)];
                    largest = std::max(largest, std::fabs(sum));
                    squares += sum * sum;
                }
            const Energy energy = simulation.energy();
            std::printf("| %s, %s | %.2f ... %.2f | %.2f %% | %.3f %% | %+.1e |\n",
                        axisymmetric ? "axisymmetric" : "plane strain",
                        k > 0.0 ? "k = 1e-4 m/s" : "undrained",
                        1e-3 * *std::min_element(p.begin(), p.end()),
                        1e-3 * *std::max_element(p.begin(), p.end()), 100.0 * largest / load,
                        100.0 * std::sqrt(squares / count) / load,
                        energy.residual() / energy.external_work);
            std::fflush(stdout);
        }
    const SaturatedCylinder cylinder = inflate_saturated_cylinder(implicit);
    std::printf(
        "\n| thick undrained cylinder | widening by Lamé's | largest error of p by the pressure "
        "inside |\n|---|---|---|\n| eight cells | %.4f | %.4f |\n",
        cylinder.widening, cylinder.pressure_error);
}

// Of 64 by 64 cells with four particles each, under their weight and a load.
class Cost {
  public:
    Cost(bool is_sand, double load, bool has_water, bool implicit, double conductivity) {
        constexpr int cells = 64;
        const Column column{.cells = cells,
                            .conductivity = conductivity,
                            .implicit = implicit,
                            .load = load,
                            .gravity = 9.81};
        Case plan = column.plan();
        plan.r = {0.0, {{column.height, cells, 1.0}}};
        plan.bodies[0].outlines[0].corners = {
            {0.0, 0.0}, {column.height, 0.0}, {column.height, column.height}, {0.0, column.height}};
        if (is_sand) plan = of_sand(plan);
        if (!has_water) plan.bodies[0].water.reset();
        built = build_case(plan);
        apply_stage(plan, plan.stages[0], *built.simulation);
        for (int i = 0; i < steps; ++i) built.simulation->step();
    }
    void measure() {
        const std::clock_t begin = std::clock();  // of this process, whoever else computes
        for (int i = 0; i < steps; ++i) built.simulation->step();
        const double spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        best = std::min(best, 1e6 * spent / steps);
    }
    double per_step() const { return best; }                           // [µs]
    double dt() const { return 1e6 * built.simulation->next_step(); }  // [µs]

  private:
    static constexpr int steps = 20;
    BuiltCase built;
    double best = 1e9;
};

// What a step costs beside that of the dry body, the best of many trials in turn, and how long it is.
void cost() {
    constexpr int trials = 15;
    std::printf("\n| processor's µs per step of 16384 particles, Δt [µs] | dry | undrained | flow "
                "| undrained, implicit | flow, implicit |\n|---|---|---|---|---|---|\n");
    struct Ground {
        const char* name;
        bool is_sand;
        double load;  // [Pa]
    };
    for (const Ground& ground : {Ground{"elastic", false, 0.0}, Ground{"Lausitz sand", true, 0.0},
                                 Ground{"... under 1 kPa", true, 1e3}}) {
        const auto& [name, is_sand, load] = ground;
        std::vector<Cost> costs;
        costs.emplace_back(is_sand, load, false, false, 0.0);
        for (const bool implicit : {false, true})
            for (const double k : {0.0, 1e-4}) costs.emplace_back(is_sand, load, true, implicit, k);
        for (int trial = 0; trial < trials; ++trial)
            for (Cost& of : costs) of.measure();
        const double dry = costs[0].per_step();
        std::printf("| %s | %.0f, %.1f |", name, dry, costs[0].dt());
        for (std::size_t i = 1; i < costs.size(); ++i)
            std::printf(" %.0f, ×%.2f, %.1f |", costs[i].per_step(), costs[i].per_step() / dry,
                        costs[i].dt());
        std::printf("\n");
        std::fflush(stdout);
    }
}

}  // namespace

// All of them, or those named.
int main(int argc, char** argv) {
    const auto wanted = [&](std::string_view name) {
        return argc == 1 || std::find(argv + 1, argv + argc, name) != argv + argc;
    };
    if (wanted("waves")) waves();
    if (wanted("disk")) disk();
    if (wanted("mandel")) mandel();
    for (const bool implicit : {false, true}) {
        if (!wanted("column") && !wanted("block")) continue;
        std::printf("\n%s pressure\n", implicit ? "Implicit" : "Explicit");
        if (wanted("column")) {
            terzaghi(implicit);
            conductivities(implicit);
            drained(implicit);
        }
        if (wanted("block")) block(implicit);
    }
    if (wanted("cost")) cost();
    return 0;
}
