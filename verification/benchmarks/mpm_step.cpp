// SPDX-License-Identifier: BSD-3-Clause
// What a material point costs per step, in the column of mpm_column.hpp: laws, shape functions, schemes, two
// threads, 10^3 to 10^6 particles. A pass is the same steps from the same start.
#include "measure.hpp"
#include "mpm_column.hpp"

namespace {

using namespace benchmarks;
using grit::mpm::Scheme;
using grit::mpm::Shape;

void steps(benchmark::State& state, const ColumnPlan& plan) {
    const double particles = 16.0 * plan.cells_r * plan.cells_r;
    const int count = particles < 3e4 ? 50 : 5;
    grit::mpm::BuiltCase built;
    const auto prepare = [&] {
        built = column(plan);
        built.simulation->step();
    };
    const auto pass = [&] {
        for (int i = 0; i < count; ++i) built.simulation->step();
    };
    best_of(state, particles * count, prepare, pass,
            plan.threads > 1 ? Threads::several : Threads::one);
    state.counters["particles"] = particles;
    state.counters["sand"] = plan.sand ? 1.0 : 0.0;
    state.counters["threads_used"] = plan.threads;
}

void add(const std::string& name, const ColumnPlan& plan) {
    add_benchmark(name, [plan](benchmark::State& state) { steps(state, plan); });
}

void register_all() {
    constexpr int paper = 20;  // cells: 6 400 particles
    add("elastic", {paper});
    add("sand", {paper, true});
    add("elastic, two threads", {.cells_r = paper, .threads = 2});
    add("sand, two threads", {paper, true, 2});
    add("elastic, MUSL", {.cells_r = paper, .scheme = Scheme::musl});
    add("elastic, stress first", {.cells_r = paper, .scheme = Scheme::usf});
    add("elastic, uGIMP", {.cells_r = paper, .shape = Shape::ugimp});
    add("elastic, points", {.cells_r = paper, .shape = Shape::point});
    for (const int cells : {8, 14, 25, 43, 79, 137, 250}) {
        add("growth/elastic/" + std::to_string(cells), {cells});
        add("growth/sand/" + std::to_string(cells), {cells, true});
    }
}

}  // namespace

int main(int argc, char** argv) { return run_beside_exp(argc, argv, register_all); }
