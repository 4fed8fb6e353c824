// SPDX-License-Identifier: BSD-3-Clause
// A step in space takes no memory from the heap.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "../counted_allocations.hpp"
#include "support/loose_cube.hpp"

namespace {

using namespace space_test;

enum class Contact { nodes, gated_nodes, free_body, surfaces, given_surface };

// A slab that slides on sand.
void add_slab_on_sand(Simulation& to, Contact contact) {
    to.set_gravity({0.0, 0.0, -9.81});
    constexpr double top = 0.87;
    Body sand = wet(loose_cube_of_sand()), slab = slab_above();
    sand.water->bulk_modulus = 1e7;  // as long a step as of dry sand
    const ParticleView grains = sand.particles.view(), q = slab.particles.view();
    for (std::ptrdiff_t p = 0; p < sand.particles.size(); ++p) {
        for (int k = 0; k < 3; ++k) grains[column::v_x + k][p] = 0.0;
        for (int k = 0; k < 6; ++k) grains[column::S_xx + k][p] = k < 3 ? -1e4 : 0.0;
    }
    const auto count = static_cast<int>(slab.particles.size());
    for (std::ptrdiff_t p = 0; p < count; ++p) {
        q[column::z][p] += top - 0.9;
        q[column::v_x][p] = 1.0;
    }
    if (contact == Contact::free_body) {
        slab.material.reset();
        slab.make_rigid({.free = {true, true, true, true, true, true}, .start = {{1.0, 0.0, 0.0}}});
    }
    to.add_body(std::move(sand));
    to.add_body(std::move(slab));
    to.fix_below(2, 0.27);
    for (int id = count - 144; contact != Contact::free_body && id < count; ++id)
        to.add_traction({1, id, {2, true}, [](double) { return Vector3{0.0, 0.0, -1e4}; }});
    if (contact == Contact::surfaces || contact == Contact::given_surface) {
        SurfaceLaw law = surface_law(0.3);
        law.a = 1;
        law.b = 0;
        if (contact == Contact::given_surface) {
            law.mesh_a.position = {0.3, 0.3, top, 0.3, 0.9, top, 0.9, 0.9, top, 0.9, 0.3, top};
            law.mesh_a.facet = {0, 1, 2, 0, 2, 3};
        }
        to.add_contact(law);
    } else {
        ContactLaw law = not_gated();
        law.gated = contact == Contact::gated_nodes;
        to.add_contact(law);
    }
}

class SpaceStep : public testing::TestWithParam<std::tuple<Contact, bool>> {};
TEST_P(SpaceStep, AllocatesNothing) {
    const auto [contact, fixed_point] = GetParam();
    Simulation simulation(cube_of_cells(1.3, 13), {.pic_rate = 20.0,
                                                   .local_damping = 0.1,
                                                   .linear_viscosity = 0.1,
                                                   .cell_mean = true,
                                                   .fixed_point = fixed_point,
                                                   .threads = 2});
    add_slab_on_sand(simulation, contact);
    const bool at_nodes = contact < Contact::surfaces;
    double pressed = 0.0;
    const auto go_on = [&] {
        for (int i = 0; i < 60; ++i) {
            simulation.step();
            pressed +=
                std::fabs(at_nodes ? simulation.contact(0).totals().impulse_on_b[2]
                                   : simulation.surface_contact(0).totals().impulse.along[2]);
        }
    };
    go_on();  // what is near later has been as much before
    const long before = allocations;
    pressed = 0.0;
    go_on();
    EXPECT_EQ(allocations, before);
    EXPECT_GT(pressed, 0.1);  // [N s]; the free body: its weight alone
}

INSTANTIATE_TEST_SUITE_P(Contacts, SpaceStep,
                         testing::Combine(testing::Values(Contact::nodes, Contact::gated_nodes,
                                                          Contact::free_body, Contact::surfaces,
                                                          Contact::given_surface),
                                          testing::Bool()));

}  // namespace
