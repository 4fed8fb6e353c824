// SPDX-License-Identifier: BSD-3-Clause
// The contacts at nodes, called with structs of any size, strides, lists and numbers, in memory that ends where it must.
#include <algorithm>
#include <vector>

#include <grit/grit.h>

#include "robustness/fuzz/bytes.hpp"
#include "robustness/fuzz/refusal.hpp"

namespace {

using fuzz::Bytes;
using fuzz::demand;

// Whoever leaves out what says how many gets the default, three.
constexpr int most_components = 3;

struct Column {
    std::vector<double> memory;
    std::ptrdiff_t size;
    Column(Bytes& in, std::ptrdiff_t nodes, std::ptrdiff_t components, double usual)
        : memory(static_cast<std::size_t>(nodes * components)), size(components) {
        for (double& each : memory) each = in.number(usual);
    }
    grit_view in() const { return grit_view_of(memory.data(), size, 1); }
    grit_mutable_view out() { return grit_mutable_view_of(memory.data(), size, 1); }
};

fuzz::Padded<grit_contact_options> any_options(Bytes& in, int components) {
    fuzz::Padded<grit_contact_options> later;
    grit_contact_options& out = later.here;
    grit_contact_options_init(&out, sizeof out);
    out.components = in.one_in(16) ? in.below(components + 1) : components;
    out.law = in.one_in(16) ? in.raw<int>() : in.below(2);
    if (in.one_in(4)) out.penalty_power = in.number(6.0);
    out.friction_coefficient = in.number(0.3);
    if (in.one_in(3)) out.adhesion = in.number(1e3);
    if (!in.one_in(4)) out.time_step = in.number(1e-5);
    if (in.one_in(8)) out.mass_tolerance = in.number(1e-10);
    if (in.one_in(8)) out.gap_tolerance = in.number(1e-3);
    out.rigid = in.one_in(16) ? in.raw<int>() : in.below(3);
    out.allow_zero_normal = in.one_in(16) ? in.raw<int>() : in.below(2);
    if (in.one_in(16)) out.instruction_set = in.raw<int>();
    out.validate_only = in.one_in(16) ? in.raw<int>() : 0;
    if (in.one_in(4)) out.relaxation_time = in.number(1e-4);
    if (in.one_in(6)) out.contact_stiffness = in.number(1e9);
    if (in.one_in(16)) out.struct_size = static_cast<std::size_t>(in.byte());
    return later;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes in(data, size);
    const int c = in.below(2) + 2;
    const std::ptrdiff_t n = 1 + in.below(9);
    const fuzz::Padded<grit_contact_options> later_options = any_options(in, c);
    const grit_contact_options& options = later_options.here;
    Column mass_a(in, n, 1, 2.0), mass_b(in, n, 1, 3.0), normal(in, n, most_components, 0.1),
        distance(in, n, 1, 0.2), cell(in, n, 1, 1.0), spacing(in, n, most_components, 1.0),
        gap(in, n, 1, -1e-3), area(in, n, 1, 0.5), v_a(in, n, most_components, 1.0),
        v_b(in, n, most_components, -1.0), a_a(in, n, most_components, 10.0),
        a_b(in, n, most_components, -5.0), old_a(in, n, most_components, 0.9),
        old_b(in, n, most_components, -0.9), place(in, n, most_components, 3.0),
        pore(in, n, 1, 0.1);
    if (!in.one_in(8))
        for (std::ptrdiff_t i = 0; i < n; ++i)
            for (int k = 0; k < c; ++k)
                normal.memory[static_cast<std::size_t>(i * most_components + k)] =
                    k == i % c ? 1.0 : 0.0;
    std::vector<std::ptrdiff_t> index(static_cast<std::size_t>(n));
    for (std::ptrdiff_t i = 0; i < n; ++i)
        index[static_cast<std::size_t>(i)] =
            in.one_in(40) ? in.below(static_cast<int>(n)) : n - 1 - i;
    std::vector<grit_contact_sums> sums(3);
    grit_error error{};
    const auto optional = [&in](const Column& column) {
        return in.one_in(2) ? column.in() : grit_view{};
    };
    if (in.one_in(3)) {
        const int count = 2 + in.below(2);
        Column mass_c(in, n, 1, 1.0), v_c(in, n, most_components, 0.5);
        const grit_view masses[] = {mass_a.in(), mass_b.in(), mass_c.in()};
        const grit_mutable_view velocities[] = {v_a.out(), v_b.out(), v_c.out()};
        fuzz::Padded<grit_contact_bodies> later;
        grit_contact_bodies& bodies = later.here;
        bodies.struct_size = in.one_in(16) ? static_cast<std::size_t>(in.byte()) : sizeof bodies;
        bodies.components = c;
        bodies.count = in.one_in(16) ? in.raw<int>() % (count + 1) : count;
        bodies.mass = masses;
        bodies.velocity = velocities;
        if (in.one_in(8)) bodies.sweep_tolerance = in.number(1e-3);
        bodies.sweep_limit = in.one_in(8) ? in.raw<int>() % 1000 : 0;
        if (in.one_in(4)) bodies.index = index.data();
        if (in.one_in(4)) bodies.position = place.in();
        std::vector<grit_contact_pair> pairs(3);
        for (std::size_t k = 0; k < 3; ++k) {
            pairs[k].struct_size = sizeof pairs[k];
            pairs[k].a = in.one_in(16) ? in.raw<int>() : static_cast<int>(k) == 2 ? 1 : 0;
            pairs[k].b = in.one_in(16) ? in.raw<int>() : static_cast<int>(k) == 0 ? 1 : 2;
            pairs[k].options = in.one_in(4) ? nullptr : &options;
            pairs[k].normal = normal.in();
            pairs[k].distance = distance.in();
            pairs[k].cell_size = cell.in();
            pairs[k].gap = optional(gap);
            pairs[k].contact_area = area.in();
            pairs[k].pore_impulse = optional(pore);
        }
        const int pair_count = in.one_in(16) ? in.below(4) : count == 2 ? 1 : 3;
        std::vector<grit_contact_report> reports(static_cast<std::size_t>(3 * n));
        const grit_status status =
            grit_contact_correct_many(&bodies, pair_count, pairs.data(), n, reports.data(),
                                      in.one_in(2) ? sums.data() : nullptr, &error);
        demand(status >= GRIT_OK && status <= GRIT_NOT_CONVERGED);
        if (status != GRIT_OK) fuzz::refusal = grit_status_name(status);
        return 0;
    }
    fuzz::Padded<grit_contact_nodes> later_nodes;
    grit_contact_nodes& nodes = later_nodes.here;
    nodes.struct_size = in.one_in(16) ? static_cast<std::size_t>(in.byte()) : sizeof nodes;
    if (in.one_in(3)) nodes.index = index.data();
    if (!in.one_in(32)) nodes.mass_a = mass_a.in();
    if (!in.one_in(32)) nodes.mass_b = mass_b.in();
    if (!in.one_in(32)) nodes.normal = normal.in();
    if (!in.one_in(16)) nodes.distance = distance.in();
    if (!in.one_in(4)) nodes.cell_size = cell.in();
    else nodes.spacing = spacing.in();
    nodes.gap = optional(gap);
    if (!in.one_in(4)) nodes.contact_area = area.in();
    nodes.velocity_a = v_a.out();
    nodes.velocity_b = in.one_in(32) ? v_a.out() : v_b.out();
    if (in.one_in(3)) nodes.acceleration_a = a_a.out(), nodes.acceleration_b = a_b.out();
    if (in.one_in(3))
        nodes.previous_velocity_a = old_a.in(), nodes.previous_velocity_b = old_b.in();
    nodes.position = optional(place);
    if (in.one_in(4)) nodes.pore_impulse = pore.in();
    std::vector<grit_contact_report> reports(static_cast<std::size_t>(n));
    const std::ptrdiff_t count = in.one_in(16) ? -static_cast<std::ptrdiff_t>(in.byte()) : n;
    const grit_status status = grit_contact_correct(
        in.one_in(16) ? nullptr : &options, count, in.one_in(64) ? nullptr : &nodes,
        in.one_in(4) ? nullptr : reports.data(), in.one_in(2) ? sums.data() : nullptr,
        in.one_in(4) ? nullptr : &error);
    demand(status >= GRIT_OK && status <= GRIT_BAD_STATE);
    if (status != GRIT_OK) fuzz::refusal = grit_status_name(status);
    fuzz::Padded<grit_contact_totals> later_totals;
    grit_contact_totals& totals = later_totals.here;
    totals.struct_size = in.one_in(8) ? static_cast<std::size_t>(in.byte()) : sizeof totals;
    grit_contact_sums_add(sums.data() + 1, sums.data());
    grit_contact_sums_read(sums.data() + 1, &totals);
    return 0;
}
