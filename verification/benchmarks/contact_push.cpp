// SPDX-License-Identifier: BSD-3-Clause
// What a step of a pile push costs with each contact: a rigid pile of radius 0.15 m in 1.5 m x 1.5 m of dense Lausitz
// sand, four cells in the radius, pushed 0.1 m at 1 m/s before the first pass. Passes of all contacts take turns.
#include <memory>

#include "measure.hpp"
#include "mpm_column.hpp"

namespace {

using namespace benchmarks;
using namespace grit::mpm;

constexpr double radius = 0.15, embedded = 0.15, extent = 1.5, cell = 0.0375;  // [m]

Outline box(double r0, double r1, double z0, double z1) {
    return {{{r0, z0}, {r1, z0}, {r1, z1}, {r0, z1}}};
}

Case pile_push(const ContactPlan& contact) {
    const auto axis = [](double from, double to) {
        return AxisPlan{from, {{to, static_cast<int>(std::lround((to - from) / cell))}}};
    };
    Case out{};
    out.r = axis(0.0, extent);
    out.z = axis(-extent, 0.75);
    out.settings.pic_rate = 50.0;
    out.settings.cell_mean = true;
    out.settings.gravity_z = -out.gravity;
    out.boundary[static_cast<int>(Side::right)] = Boundary::roller;
    out.boundary[static_cast<int>(Side::bottom)] = Boundary::roller;
    BodyPlan pile{}, sand{};
    pile.name = "pile";
    pile.outlines = {box(0.0, radius, -embedded, 0.6)};
    pile.density = 1.0;  // moves nothing
    pile.material = RigidPlan{{{0.0}, {0.0}}, {{0.0, 0.02}, {0.0, -1.0}}};
    sand.name = "sand";
    sand.outlines = {box(0.0, extent, -extent, -embedded), box(radius, extent, -embedded, 0.0)};
    sand.density = 2650.0 / 1.55;
    SandPlan material = lausitz_plan();
    material.void_ratio = 0.55;
    sand.material = material;
    sand.geostatic = Geostatic{};
    out.bodies = {pile, sand};
    out.contacts = {contact};
    return out;
}

ContactPlan nodal(int law) {
    ContactPlan out{"pile", "sand"};
    out.law = law;
    out.friction_coefficient = 0.3;
    return out;
}

void steps(benchmark::State& state, BuiltCase& built) {
    constexpr int count = 50;
    Simulation& simulation = *built.simulation;
    while (simulation.time() < 0.11) simulation.step();
    best_of(
        state, count, [] {},
        [&] {
            for (int i = 0; i < count; ++i) simulation.step();
        });
    state.counters["steps"] = count;
}

void add(const std::string& name, const ContactPlan& contact) {
    const auto built = std::make_shared<BuiltCase>(build_case(pile_push(contact)));
    add_benchmark(name, [built](benchmark::State& state) { steps(state, *built); });
}

void register_all() {
    ContactPlan ungated = nodal(GRIT_CONTACT_GEO), penalty = nodal(0), surface = nodal(0);
    ungated.gated = false;
    penalty.penalty =
        PenaltyPlan{5e7,
                    1.0,
                    {{{0.0, -embedded}, {radius, -embedded}, {radius, 0.6}}},
                    {{{extent, 0.0}, {radius, 0.0}, {radius, -embedded}, {0.0, -embedded}}}};
    surface.at_surfaces = true;
    add("GCA, gated", nodal(GRIT_CONTACT_GEO));
    add("GCA, as published", ungated);
    add("FCA, gated", nodal(GRIT_CONTACT_FRICTIONAL));
    add("PCA", penalty);
    add("surface", surface);
}

}  // namespace

int main(int argc, char** argv) { return run_beside_exp(argc, argv, register_all); }
