// SPDX-License-Identifier: BSD-3-Clause
// Every text about views, strides, lists, masks, switches, counts, structs and workspaces, of every entry, word for
// word: hosts print them and look for them.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>
#include <grit/contact_penalty.h>
#include <gtest/gtest.h>

namespace {

constexpr std::ptrdiff_t points = 4;

struct Memory {
    std::vector<double> number = std::vector<double>(200, 0.0);
    grit_view in(std::ptrdiff_t components = 1) const {
        return grit_view_of(number.data(), components, 1);
    }
    grit_mutable_view out(std::ptrdiff_t components = 1) {
        return grit_mutable_view_of(number.data(), components, 1);
    }
};

// What a call says: its status, the point it names if it names one, its text.
std::string said(grit_status status, const grit_error& error) {
    EXPECT_EQ(status, error.status) << error.message;
    return (status == GRIT_BAD_CALL    ? std::string()
            : status == GRIT_BAD_STATE ? std::string("state, ")
                                       : "status " + std::to_string(status) + ", ") +
           (error.point < 0 ? "" : "at " + std::to_string(error.point) + ", ") + error.message;
}

template <class Call> struct Bad {
    std::function<void(Call&)> spoil;
    std::string text;
};

template <class Call> void expect_texts(const std::vector<Bad<Call>>& all) {
    for (const auto& bad : all) {
        Call call;
        call.error = {GRIT_OK, 0, -7, "nothing"};
        bad.spoil(call);
        const grit_status status = call.run();
        EXPECT_EQ(said(status, call.error), bad.text);
    }
}

struct Pair {
    Memory memory, velocity_a, velocity_b, accelerations;
    grit_contact_options o{};
    grit_contact_nodes q{};
    std::ptrdiff_t n = points;
    bool has_nodes = true;
    grit_error error{};

    Pair() {
        grit_contact_options_init(&o, sizeof o);
        q.struct_size = sizeof q;
        for (grit_view* view : {&q.mass_a, &q.mass_b, &q.distance, &q.cell_size, &q.contact_area})
            *view = memory.in();
        q.normal = memory.in(3);
        q.velocity_a = velocity_a.out(3);
        q.velocity_b = velocity_b.out(3);
    }
    grit_status run() {
        return grit_contact_correct(&o, n, has_nodes ? &q : nullptr, nullptr, nullptr, &error);
    }
};

TEST(CallTexts, OfAPairAreTheSame) {
    expect_texts<Pair>({
        {[](Pair& c) { c.has_nodes = false; }, "grit_contact_correct: nodes is null"},
        {[](Pair& c) { c.n = -2; }, "grit_contact_correct: n must be >= 0, got -2"},
        {[](Pair& c) { c.o.struct_size = 5; },
         "grit_contact_options.struct_size 5 is not understood: call grit_contact_options_init "
         "first"},
        {[](Pair& c) { c.q.struct_size = 5000; },
         "grit_contact_nodes.struct_size 5000 is not understood: set it to sizeof"},
        {[](Pair& c) { c.o.components = 4; }, "components must be 2 or 3, got 4"},
        {[](Pair& c) { c.o.allow_zero_normal = 2; }, "allow_zero_normal must be 0 or 1, got 2"},
        {[](Pair& c) { c.o.validate_only = -1; }, "validate_only must be 0 or 1, got -1"},
        {[](Pair& c) { c.q.mass_a.base = nullptr; }, "mass_a has no base pointer"},
        {[](Pair& c) { c.q.mass_b.base = nullptr; }, "mass_b has no base pointer"},
        {[](Pair& c) { c.q.normal.base = nullptr; }, "normal has no base pointer"},
        {[](Pair& c) { c.q.distance.base = nullptr; }, "distance has no base pointer"},
        {[](Pair& c) {
             c.o.adhesion = c.o.time_step = 1.0;
             c.q.contact_area.base = nullptr;
         },
         "contact_area has no base pointer"},
        {[](Pair& c) { c.q.normal.component_stride = 0; },
         "normal has 3 components: component_stride must not be 0"},
        {[](Pair& c) {
             c.q.spacing = {c.q.mass_a.base, 3, 0};
         },
         "spacing has 3 components: component_stride must not be 0"},
        {[](Pair& c) {
             c.q.previous_velocity_a = {c.q.mass_a.base, 3, 0};
         },
         "previous_velocity_a has 3 components: component_stride must not be 0"},
        {[](Pair& c) {
             c.q.previous_velocity_b = {c.q.mass_a.base, 3, 0};
         },
         "previous_velocity_b has 3 components: component_stride must not be 0"},
        {[](Pair& c) {
             c.o.components = 2;
             c.q.position = {c.q.mass_a.base, 3, 0};
         },
         "position has 2 components: component_stride must not be 0"},
        {[](Pair& c) { c.q.cell_size.base = nullptr; },
         "Geo-contact needs cell_size or spacing: neither has a base pointer"},
        {[](Pair& c) { c.q.velocity_a.base = nullptr; }, "velocity_a has no base pointer"},
        {[](Pair& c) { c.q.velocity_b.base = nullptr; }, "velocity_b has no base pointer"},
        {[](Pair& c) { c.q.acceleration_a = c.accelerations.out(3); },
         "acceleration_a is to be corrected: needs time_step > 0 [time], got 0"},
        {[](Pair& c) {
             c.o.time_step = 1.0;
             c.q.acceleration_b = {c.accelerations.number.data(), 3, 0};
         },
         "acceleration_b has 3 components: component_stride must not be 0"},
        {[](Pair& c) { c.q.velocity_b.component_stride = 0; },
         "velocity_b has 3 components: component_stride must not be 0"},
        {[](Pair& c) { c.q.velocity_a.point_stride = 0; },
         "velocity_a is written: strides of 0 (nodes) and 1 (components) put two of its numbers in "
         "one place"},
        {[](Pair& c) { c.q.velocity_b.point_stride = -2; },
         "velocity_b is written: strides of -2 (nodes) and 1 (components) put two of its numbers "
         "in one place"},
    });
}

struct Many {
    Memory memory, velocity;
    grit_view mass[3], previous[3];
    grit_mutable_view v[3];
    grit_contact_bodies b{};
    grit_contact_pair pair[2]{};
    grit_contact_options o{};
    int pairs = 2;
    std::ptrdiff_t n = points;
    bool has_bodies = true, has_pairs = true;
    grit_error error{};

    Many() {
        grit_contact_options_init(&o, sizeof o);
        b.struct_size = sizeof b;
        b.components = 3;
        b.count = 3;
        for (int i = 0; i < 3; ++i) {
            mass[i] = memory.in();
            previous[i] = memory.in(3);
            v[i] = grit_mutable_view_of(velocity.number.data() + 20 * i, 3, 1);
        }
        b.mass = mass;
        b.velocity = v;
        for (int i = 0; i < 2; ++i) {
            pair[i].struct_size = sizeof pair[i];
            pair[i].a = 0;
            pair[i].b = i + 1;
            pair[i].options = &o;
            pair[i].normal = memory.in(3);
            pair[i].distance = pair[i].cell_size = memory.in();
        }
    }
    grit_status run() {
        return grit_contact_correct_many(has_bodies ? &b : nullptr, pairs,
                                         has_pairs ? pair : nullptr, n, nullptr, nullptr, &error);
    }
};

TEST(CallTexts, OfManyBodiesAreTheSame) {
    expect_texts<Many>({
        {[](Many& c) { c.has_bodies = false; }, "grit_contact_correct_many: bodies is null"},
        {[](Many& c) { c.n = -1; }, "grit_contact_correct_many: n must be >= 0, got -1"},
        {[](Many& c) { c.b.struct_size = 1; },
         "grit_contact_bodies.struct_size 1 is not understood: set it to sizeof"},
        {[](Many& c) { c.b.components = 1; }, "components must be 2 or 3, got 1"},
        {[](Many& c) { c.b.count = 1; }, "count must be in [2, 8] bodies, got 1"},
        {[](Many& c) { c.b.mass = nullptr; }, "mass and velocity need one view per body, got null"},
        {[](Many& c) { c.b.sweep_limit = -3; }, "sweep_limit must be >= 0, got -3"},
        {[](Many& c) { c.b.reserved = 4; }, "grit_contact_bodies.reserved must be 0, got 4"},
        {[](Many& c) { c.b.validate_only = 2; }, "validate_only must be 0 or 1, got 2"},
        {[](Many& c) { c.mass[1].base = nullptr; }, "body 1: mass has no base pointer"},
        {[](Many& c) { c.v[2].base = nullptr; }, "body 2: velocity has no base pointer"},
        {[](Many& c) {
             c.b.previous_velocity = c.previous;
             c.previous[0].base = nullptr;
         },
         "body 0: previous_velocity has no base pointer"},
        {[](Many& c) { c.pairs = 4; }, "pair_count must be in [0, 3] for 3 bodies, got 4"},
        {[](Many& c) { c.has_pairs = false; }, "grit_contact_correct_many: pairs is null"},
        {[](Many& c) { c.pair[0].struct_size = 13; },
         "grit_contact_pair.struct_size 13 is not understood: set it to sizeof"},
        {[](Many& c) { c.pair[0].struct_size = 8000; },
         "pair 0, grit_contact_pair.struct_size 8000 is not understood: set it to sizeof"},
        {[](Many& c) { c.pair[1].struct_size -= 8; },
         "pair 1, grit_contact_pair.struct_size " + std::to_string(sizeof(grit_contact_pair) - 8) +
             " is not understood: set it to sizeof"},
        {[](Many& c) { c.pair[1].b = 0; },
         "pair 1, a and b must be two different bodies of 0 ... 2, got 0 and 0"},
        {[](Many& c) { c.pair[1].a = -1; },
         "pair 1, a and b must be two different bodies of 0 ... 2, got -1 and 2"},
        {[](Many& c) { c.o.struct_size = 3; },
         "pair 0, grit_contact_options.struct_size 3 is not understood: call "
         "grit_contact_options_init first"},
        {[](Many& c) { c.pair[1].normal.base = nullptr; }, "pair 1, normal has no base pointer"},
        {[](Many& c) { c.v[1].point_stride = 1; },
         "pair 0, velocity_b is written: strides of 1 (nodes) and 1 (components) put two of its "
         "numbers in one place"},
        {[](Many& c) { c.pair[1].b = 1; }, "pair 1: bodies 0 and 1 have a pair already"},
        {[](Many& c) { c.pair[1].a = 1, c.pair[1].b = 0; },
         "pair 1: bodies 1 and 0 have a pair already"},
    });
}

struct Gradients {
    Memory memory, normal;
    std::vector<int> fixed = std::vector<int>(points, 0);
    grit_contact_gradients q{};
    grit_contact_normal_counts counts{sizeof counts, 0, 0, 0};
    std::ptrdiff_t n = points;
    bool has_gradients = true;
    grit_error error{};

    Gradients() {
        q.struct_size = sizeof q;
        q.components = 3;
        q.source = GRIT_CONTACT_NORMAL_AVERAGE;
        q.gradient_a = q.gradient_b = q.given = memory.in(3);
        q.scale = memory.in();
        q.fixed = fixed.data();
        q.normal = normal.out(3);
    }
    grit_status run() {
        return grit_contact_normals_from_gradients(n, has_gradients ? &q : nullptr, &counts,
                                                   &error);
    }
};

TEST(CallTexts, OfNormalsFromGradientsAreTheSame) {
    expect_texts<Gradients>({
        {[](Gradients& c) { c.has_gradients = false; },
         "grit_contact_normals_from_gradients: gradients is null"},
        {[](Gradients& c) { c.n = -1; },
         "grit_contact_normals_from_gradients: n must be >= 0, got -1"},
        {[](Gradients& c) { c.q.struct_size = 7; },
         "grit_contact_gradients.struct_size 7 is not understood: set it to sizeof"},
        {[](Gradients& c) { c.counts.struct_size = 7; },
         "grit_contact_normal_counts.struct_size 7 is not understood: set it to sizeof"},
        {[](Gradients& c) { c.q.components = 0; }, "components must be 2 or 3, got 0"},
        {[](Gradients& c) { c.q.gradient_a.base = nullptr; },
         "gradient_a needs a base pointer and a component_stride for source 2"},
        {[](Gradients& c) { c.q.gradient_a.component_stride = 0; },
         "gradient_a needs a base pointer and a component_stride for source 2"},
        {[](Gradients& c) {
             c.q.source = GRIT_CONTACT_NORMAL_OF_B;
             c.q.gradient_b.base = nullptr;
         },
         "gradient_b needs a base pointer and a component_stride for source 1"},
        {[](Gradients& c) {
             c.q.source = GRIT_CONTACT_NORMAL_GIVEN;
             c.q.given.component_stride = 0;
         },
         "given needs a base pointer and a component_stride for source 3"},
        {[](Gradients& c) { c.q.normal.base = nullptr; },
         "normal needs a base pointer and a component_stride"},
        {[](Gradients& c) { c.q.normal.component_stride = 0; },
         "normal needs a base pointer and a component_stride"},
        {[](Gradients& c) { c.q.normal.point_stride = 0; },
         "normal is written: point_stride must not be 0 for 4 nodes"},
        {[](Gradients& c) { c.fixed[2] = 8; },
         "at 2, node 2: fixed must be bits of 3 components in [0, 7], got 8"},
        {[](Gradients& c) {
             c.q.components = 2;
             c.fixed[1] = -1;
         },
         "at 1, node 1: fixed must be bits of 2 components in [0, 3], got -1"},
        {[](Gradients& c) { c.memory.number[5] = HUGE_VAL; },
         "state, at 1, node 1: gradient_a component 2 must be finite, got inf"},
        {[](Gradients& c) {
             c.q.scale.point_stride = 60;
             c.memory.number[60] = HUGE_VAL;
         },
         "state, at 1, node 1: scale must be finite and >= 0, got inf"},
    });
}

struct Cloud {
    Memory memory, normal;
    std::vector<int> body = {0, 1, 0, 1}, fixed = {0, 0};
    std::vector<std::ptrdiff_t> offset = {0, 2, 4}, particle = {0, 1, 2, 3};
    std::vector<double> workspace = std::vector<double>(200);
    std::size_t workspace_size = 1600;
    grit_contact_clouds q{};
    grit_contact_normal_counts counts{sizeof counts, 0, 0, 0};
    std::ptrdiff_t n = 2;
    bool has_clouds = true, has_workspace = true;
    grit_error error{};

    Cloud() {
        q.struct_size = sizeof q;
        q.components = 2;
        q.particles = 4;
        q.length = 1.0;
        for (std::size_t i = 0; i < 8; ++i) memory.number[i] = 0.1 * static_cast<double>(i * i);
        q.position = memory.in(2);
        q.body = body.data();
        q.offset = offset.data();
        q.particle = particle.data();
        q.fixed = fixed.data();
        q.normal = normal.out(2);
    }
    grit_status run() {
        return grit_contact_normals_by_regression(n, has_clouds ? &q : nullptr,
                                                  has_workspace ? workspace.data() : nullptr,
                                                  workspace_size, &counts, &error);
    }
};

TEST(CallTexts, OfNormalsByRegressionAreTheSame) {
    expect_texts<Cloud>({
        {[](Cloud& c) { c.has_clouds = false; },
         "grit_contact_normals_by_regression: clouds is null"},
        {[](Cloud& c) { c.n = -1; }, "grit_contact_normals_by_regression: n must be >= 0, got -1"},
        {[](Cloud& c) { c.q.struct_size = 2; },
         "grit_contact_clouds.struct_size 2 is not understood: set it to sizeof"},
        {[](Cloud& c) { c.counts.struct_size = 4097; },
         "grit_contact_normal_counts.struct_size 4097 is not understood: set it to sizeof"},
        {[](Cloud& c) { c.q.components = 5; }, "components must be 2 or 3, got 5"},
        {[](Cloud& c) { c.q.reserved = -1; }, "grit_contact_clouds.reserved must be 0, got -1"},
        {[](Cloud& c) { c.q.length = HUGE_VAL; },
         "length must be finite and > 0 [length], got inf"},
        {[](Cloud& c) { c.q.iteration_limit = -4; }, "iteration_limit must be >= 0, got -4"},
        {[](Cloud& c) { c.q.particles = -5; }, "particles must be >= 0, got -5"},
        {[](Cloud& c) { c.q.offset = nullptr; }, "offset is null"},
        {[](Cloud& c) { c.q.position.base = nullptr; },
         "position needs a base pointer and a component_stride"},
        {[](Cloud& c) { c.q.body = nullptr; }, "body is null"},
        {[](Cloud& c) { c.q.normal.component_stride = 0; },
         "normal needs a base pointer and a component_stride"},
        {[](Cloud& c) { c.q.normal.point_stride = 0; },
         "normal is written: point_stride must not be 0 for 2 nodes"},
        {[](Cloud& c) { c.has_workspace = false; },
         "grit_contact_normals_by_regression: workspace is null"},
        {[](Cloud& c) { c.workspace_size = 10; },
         "workspace holds 0 particles per node, node 0 has 2: see "
         "grit_contact_regression_workspace_size"},
        {[](Cloud& c) { c.offset[0] = -1, c.offset[1] = 0; },
         "at 0, node 0: offset must start at >= 0 and not decrease, got -1 and 0"},
        {[](Cloud& c) { c.offset[2] = 1; },
         "at 1, node 1: offset must start at >= 0 and not decrease, got 2 and 1"},
        {[](Cloud& c) { c.particle[3] = 4; }, "at 1, node 1: particle id must be in [0, 4), got 4"},
        {[](Cloud& c) { c.particle[2] = -1; },
         "at 1, node 1: particle id must be in [0, 4), got -1"},
        {[](Cloud& c) { c.body[1] = 3; },
         "at 0, node 0: body of particle 1 must be 0 (A) or 1 (B), got 3"},
        {[](Cloud& c) { c.memory.number[5] = -HUGE_VAL; },
         "state, at 1, node 1: position component 1 of particle 2 must be finite, got -inf"},
        {[](Cloud& c) { c.fixed[1] = 4; },
         "at 1, node 1: fixed must be bits of 2 components in [0, 3], got 4"},
    });
}

struct Distance {
    Memory memory, surface, centre, distance, gap;
    std::vector<std::ptrdiff_t> node = {0, 1, 2, 3}, index = {0, 1, 2, 3}, offset = {0, 1, 2, 3, 4};
    grit_contact_surfaces s{};
    grit_contact_domains d{};
    grit_contact_distances q{};
    std::ptrdiff_t n = points;
    bool has_surfaces = true, has_domains = true, finishes = false;
    grit_error error{};

    Distance() {
        s.struct_size = sizeof s;
        s.components = 2;
        s.nodes = points;
        s.position = s.normal = memory.in(2);
        s.surface = surface.out(2);
        s.centre = centre.out(2);
        d.struct_size = sizeof d;
        d.sides = 2;
        d.nodes_each = 1;
        d.node = node.data();
        d.position = memory.in(2);
        d.side = grit_matrix_view_of(memory.number.data(), 4, 2, 1);
        q.struct_size = sizeof q;
        q.distance = distance.out();
        q.gap = gap.out();
        q.index = index.data();
    }
    grit_status run() {
        const grit_contact_surfaces* surfaces = has_surfaces ? &s : nullptr;
        return finishes
                   ? grit_contact_surfaces_finish(surfaces, n, has_domains ? &q : nullptr, &error)
                   : grit_contact_surfaces_add(surfaces, n, has_domains ? &d : nullptr, &error);
    }
};

TEST(CallTexts, OfDistancesAreTheSame) {
    const auto finishing = [](const std::function<void(Distance&)>& spoil) {
        return [=](Distance& c) {
            c.finishes = true;
            spoil(c);
        };
    };
    expect_texts<Distance>({
        {[](Distance& c) { c.has_domains = false; }, "grit_contact_surfaces_add: domains is null"},
        {[](Distance& c) { c.n = -1; }, "grit_contact_surfaces_add: n must be >= 0, got -1"},
        {[](Distance& c) { c.has_surfaces = false; }, "surfaces is null"},
        {[](Distance& c) { c.s.struct_size = 0; },
         "grit_contact_surfaces.struct_size 0 is not understood: set it to sizeof"},
        {[](Distance& c) { c.d.struct_size = 6; },
         "grit_contact_domains.struct_size 6 is not understood: set it to sizeof"},
        {[](Distance& c) { c.s.components = 1; }, "components must be 2 or 3, got 1"},
        {[](Distance& c) { c.s.reserved = 1; }, "grit_contact_surfaces.reserved must be 0, got 1"},
        {[](Distance& c) { c.s.nodes = -1; }, "nodes must be >= 0, got -1"},
        {[](Distance& c) { c.s.surface.component_stride = 0; },
         "surface needs a base pointer and a component_stride"},
        {[](Distance& c) { c.s.surface.point_stride = 0; },
         "surface is written: point_stride must not be 0 for 4 nodes"},
        {[](Distance& c) { c.s.centre.component_stride = 0; },
         "component_stride of centre must not be 0"},
        {[](Distance& c) { c.s.centre.point_stride = 0; },
         "centre is written: point_stride must not be 0 for 4 nodes"},
        {[](Distance& c) { c.d.body = 2; }, "body must be 0 (A) or 1 (B), got 2"},
        {[](Distance& c) { c.d.sides = -1; }, "sides must be in [0, 3], got -1"},
        {[](Distance& c) { c.d.nodes_each = -2; }, "nodes_each must be >= 0, got -2"},
        {[](Distance& c) { c.d.node = nullptr; }, "node is null"},
        {[](Distance& c) { c.s.position.base = nullptr; },
         "position of the nodes needs a base pointer and a component_stride"},
        {[](Distance& c) { c.s.normal.component_stride = 0; },
         "normal needs a base pointer and a component_stride"},
        {[](Distance& c) { c.d.position.component_stride = 0; },
         "position of the particles needs a base pointer and a component_stride"},
        {[](Distance& c) { c.d.side.base = nullptr; },
         "side needs a base pointer, a row_stride and a column_stride"},
        {[](Distance& c) { c.d.side.row_stride = 0; },
         "side needs a base pointer, a row_stride and a column_stride"},
        {[](Distance& c) { c.d.side.column_stride = 0; },
         "side needs a base pointer, a row_stride and a column_stride"},
        {[](Distance& c) { c.node[2] = 4; },
         "at 2, particle 2: node id must be in [0, 4), or -1, got 4"},
        {[](Distance& c) { c.node[3] = -2; },
         "at 3, particle 3: node id must be in [0, 4), or -1, got -2"},
        {[](Distance& c) {
             c.d.offset = c.offset.data();
             c.offset[2] = 0;
         },
         "at 1, particle 1: offset must start at >= 0 and not decrease, got 1 and 0"},
        {finishing([](Distance& c) { c.has_domains = false; }),
         "grit_contact_surfaces_finish: distances is null"},
        {finishing([](Distance& c) { c.n = -1; }),
         "grit_contact_surfaces_finish: n must be >= 0, got -1"},
        {finishing([](Distance& c) { c.q.struct_size = 1; }),
         "grit_contact_distances.struct_size 1 is not understood: set it to sizeof"},
        {finishing([](Distance& c) { c.q.distance.base = c.q.gap.base = nullptr; }),
         "neither distance nor gap has a base pointer"},
        {finishing([](Distance& c) { c.q.distance.point_stride = 0; }),
         "distance is written: point_stride must not be 0 for 4 nodes"},
        {finishing([](Distance& c) { c.q.gap.point_stride = 0; }),
         "gap is written: point_stride must not be 0 for 4 nodes"},
        {finishing([](Distance& c) { c.q.stiffer = -1; }),
         "stiffer must be 0 (A) or 1 (B), got -1"},
        {finishing([](Distance& c) { c.index[1] = 4; }),
         "at 1, entry 1 of index must be in [0, 4), got 4"},
        {finishing([](Distance& c) { c.index[3] = -1; }),
         "at 3, entry 3 of index must be in [0, 4), got -1"},
    });
}

enum class Entry { forces, flush, step, remesh };

struct Penalty {
    Memory force, history, stiffness;
    std::vector<double> position = {0.0, 0.0, 1.0, 0.0, 2.0, 0.0}, workspace;
    std::vector<std::ptrdiff_t> parents = std::vector<std::ptrdiff_t>(40);
    grit_penalty_options o{};
    grit_penalty_surface a{}, b{};
    grit_penalty_totals totals{};
    grit_penalty_remeshing r{};
    grit_view mass{}, k{};
    std::size_t workspace_size;
    std::ptrdiff_t n = 1, new_count = 0;
    void* memory;
    bool has_a = true, has_options = true, has_mass = true, has_out = true;
    Entry entry = Entry::forces;
    grit_error error{};

    Penalty() : workspace(1000) {
        memory = workspace.data();
        workspace_size = 8000;
        grit_penalty_options_init(&o, sizeof o);
        o.normal_stiffness = o.depth_max = o.time_step = 1.0;
        o.friction_coefficient = 0.5;
        for (grit_penalty_surface* s : {&a, &b}) {
            s->struct_size = sizeof *s;
            s->count = 3;
            s->position = s->velocity = grit_view_of(position.data(), 2, 1);
            s->force = force.out(2);
            s->history = history.out(GRIT_PENALTY_HISTORY_SIZE);
            s->stiffness = stiffness.out();
        }
        totals.struct_size = sizeof totals;
        r.struct_size = sizeof r;
        r.count = 3;
        r.longest = 0.5;
        r.capacity = 20;
        r.position = a.position;
        r.parents = parents.data();
        r.weight = force.number.data();
        r.new_position = history.out(2);
        mass = k = grit_view_of(position.data() + 2, 0, 1);
    }
    grit_status run() {
        const grit_penalty_options* options = has_options ? &o : nullptr;
        const grit_penalty_surface* surface = has_a ? &a : nullptr;
        switch (entry) {
            case Entry::flush: return grit_penalty_flush_stiffness(options, surface, &error);
            case Entry::step: {
                double step = 0.0;
                return grit_penalty_stable_step(0, nullptr, nullptr, n, has_mass ? &mass : nullptr,
                                                &k, has_out ? &step : nullptr, &error);
            }
            case Entry::remesh:
                return grit_penalty_remesh(has_a ? &r : nullptr, memory, workspace_size,
                                           has_out ? &new_count : nullptr, &error);
            case Entry::forces: break;
        }
        return grit_penalty_forces(options, surface, &b, memory, workspace_size, &totals, &error);
    }
};

TEST(CallTexts, OfPenaltyContactAreTheSame) {
    const std::string needed = std::to_string(grit_penalty_workspace_size(3, 3));
    const std::string no_workspace = "workspace is null: " + needed + " bytes are needed",
                      small = "workspace must have at least " + needed + " bytes, got 9";
    expect_texts<Penalty>({
        {[](Penalty& c) { c.has_options = false; },
         "options is null: normal_stiffness and depth_max have no default"},
        {[](Penalty& c) { c.o.struct_size = 4; },
         "grit_penalty_options.struct_size 4 is not understood: call grit_penalty_options_init "
         "first"},
        {[](Penalty& c) { c.o.axisymmetric = 3; }, "axisymmetric must be 0 or 1, got 3"},
        {[](Penalty& c) { c.o.validate_only = 3; }, "validate_only must be 0 or 1, got 3"},
        {[](Penalty& c) { c.has_a = false; }, "surface a is null"},
        {[](Penalty& c) { c.b.struct_size = 4; },
         "surface b: grit_penalty_surface.struct_size 4 is not understood: set it to sizeof"},
        {[](Penalty& c) { c.a.closed = -1; }, "surface a: closed must be 0 or 1, got -1"},
        {[](Penalty& c) { c.b.reserved = 9; }, "surface b: reserved must be 0, got 9"},
        {[](Penalty& c) { c.a.count = 1; },
         "surface a: count must be at least 2 vertices for an open line, got 1"},
        {[](Penalty& c) { c.b.closed = 1, c.b.count = 2; },
         "surface b: count must be at least 3 vertices for a closed line, got 2"},
        {[](Penalty& c) { c.b.position.base = nullptr; },
         "surface b: position has no base pointer"},
        {[](Penalty& c) { c.totals.struct_size = 4097; },
         "grit_penalty_totals.struct_size 4097 is not understood: set it to sizeof"},
        {[](Penalty& c) { c.memory = nullptr; }, no_workspace},
        {[](Penalty& c) { c.memory = static_cast<char*>(c.memory) + 4; },
         "workspace must be aligned to 8 bytes"},
        {[](Penalty& c) { c.workspace_size = 9; }, small},
        {[](Penalty& c) { c.a.force.base = nullptr; }, "surface a: force has no base pointer"},
        {[](Penalty& c) { c.b.force.point_stride = 0; },
         "surface b: force is written: point_stride must not be 0"},
        {[](Penalty& c) { c.b.force.component_stride = 0; },
         "surface b: force is written: component_stride must not be 0"},
        {[](Penalty& c) { c.a.stiffness.point_stride = 0; },
         "surface a: stiffness is written: point_stride must not be 0"},
        {[](Penalty& c) { c.a.history.base = nullptr; }, "surface a: history has no base pointer"},
        {[](Penalty& c) { c.b.history.component_stride = 0; },
         "surface b: history is written: component_stride must not be 0"},
        {[](Penalty& c) { c.b.velocity.base = nullptr; },
         "surface b: velocity has no base pointer: friction needs it"},
        {[](Penalty& c) { c.entry = Entry::flush, c.has_a = false; }, "surface is null"},
        {[](Penalty& c) { c.entry = Entry::flush, c.a.stiffness.base = nullptr; },
         "surface: stiffness has no base pointer"},
        {[](Penalty& c) { c.entry = Entry::flush, c.a.stiffness.point_stride = 0; },
         "surface: stiffness is written: point_stride must not be 0"},
        {[](Penalty& c) { c.entry = Entry::step, c.has_out = false; }, "step is null"},
        {[](Penalty& c) { c.entry = Entry::step, c.n = -1; },
         "body b: n must be >= 0 nodes, got -1"},
        {[](Penalty& c) { c.entry = Entry::step, c.has_mass = false; },
         "body b: mass has no base pointer"},
        {[](Penalty& c) { c.entry = Entry::step, c.mass.base = nullptr; },
         "body b: mass has no base pointer"},
        {[](Penalty& c) { c.entry = Entry::step, c.k.base = nullptr; },
         "body b: stiffness has no base pointer"},
        {[](Penalty& c) { c.entry = Entry::step, c.position[2] = HUGE_VAL; },
         "state, at 0, body b node 0: stiffness must be >= 0 and finite (force / length), got inf"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.has_a = false; }, "remeshing is null"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.has_out = false; }, "new_count is null"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.struct_size = 4; },
         "grit_penalty_remeshing.struct_size 4 is not understood: set it to sizeof"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.closed = 2; },
         "closed must be 0 or 1, got 2"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.reserved = 2; },
         "reserved must be 0, got 2"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.closed = 1, c.r.count = 2; },
         "count must be at least 3 vertices for a closed line, got 2"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.position.base = nullptr; },
         "position has no base pointer"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.parents = nullptr; }, "parents is null"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.weight = nullptr; }, "weight is null"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.r.new_position.point_stride = 0; },
         "line: new_position is written: point_stride must not be 0"},
        {[](Penalty& c) {
             c.entry = Entry::remesh;
             c.r.history = c.a.velocity;
         },
         "line: new_history has no base pointer"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.memory = nullptr; },
         "workspace is null: 24 bytes are needed"},
        {[](Penalty& c) {
             c.entry = Entry::remesh;
             c.memory = static_cast<char*>(c.memory) + 1;
         },
         "workspace must be aligned to 8 bytes"},
        {[](Penalty& c) { c.entry = Entry::remesh, c.workspace_size = 23; },
         "workspace must have at least 24 bytes, got 23"},
    });
}

}  // namespace
