// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_update and its relatives, called with structs of any size, strides, lists and numbers. Memory that a call may
// touch is exactly as long as it must be: what reads or writes beyond is seen by the sanitizer.
#include <algorithm>
#include <vector>

#include <grit/grit.h>

#include "robustness/fuzz/bytes.hpp"
#include "robustness/fuzz/refusal.hpp"

namespace {

using fuzz::Bytes;
using fuzz::demand;

// Numbers of points in memory that ends where the last of them does.
struct Column {
    std::vector<double> memory;
    double* first = nullptr;
    std::ptrdiff_t point = 0, component = 0;

    Column(Bytes& in, std::ptrdiff_t points, std::ptrdiff_t components, bool is_output) {
        constexpr std::ptrdiff_t strides[] = {1, -1, 2, 7, -3};
        component = strides[in.below(5)];
        const std::ptrdiff_t whole = components * std::abs(component);
        point = in.one_in(4) && !is_output ? 0 : in.one_in(3) ? -whole : whole + in.below(3);
        const std::ptrdiff_t a = (points - 1) * point, b = (components - 1) * component;
        const std::ptrdiff_t low = std::min<std::ptrdiff_t>(0, a) + std::min<std::ptrdiff_t>(0, b);
        const std::ptrdiff_t high = std::max<std::ptrdiff_t>(0, a) + std::max<std::ptrdiff_t>(0, b);
        memory.assign(static_cast<std::size_t>(high - low + 1), 0.0);
        first = memory.data() - low;
    }
    double& at(std::ptrdiff_t i, std::ptrdiff_t c) { return first[i * point + c * component]; }
    grit_view in() const { return grit_view_of(first, point, component); }
    grit_mutable_view out() const { return grit_mutable_view_of(first, point, component); }
};

// Whoever leaves out what says how many gets the default, six.
constexpr int most_components = 6;

std::size_t any_size(Bytes& in, std::size_t right) {
    switch (in.below(8)) {
        case 0: return in.raw<std::size_t>();
        case 1: return right + static_cast<std::size_t>(in.byte());
        case 2: return static_cast<std::size_t>(in.byte());
        default: return right;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes in(data, size);
    grit_sand_parameters parameters;
    if (in.one_in(16))
        grit_sand_parameters_init(&parameters, in.raw<std::size_t>() % sizeof parameters);
    grit_sand_parameters_init(&parameters, sizeof parameters);
    constexpr double usual[] = {0.576, 1.6e6, 0.19, 0.44, 0.85, 1.0, 0.25,
                                1.0,   0.0,   5.0,  2.0,  1e-4, 0.5, 6.0};
    static_assert(std::size(usual) == GRIT_SAND_PARAMETER_COUNT);
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        grit_sand_parameter_set(&parameters, i, in.one_in(8) ? in.number(usual[i]) : usual[i]);
    grit_sand_parameter_describe(in.raw<int>());
    grit_error error{};
    grit_sand sand{};
    if (grit_sand_prepare(&parameters, &sand, &error) != GRIT_OK) {
        demand(std::find(std::begin(error.message), std::end(error.message), '\0') !=
               std::end(error.message));
        fuzz::refusal = error.message;
        if (!in.one_in(4)) return 0;
    }
    fuzz::Padded<grit_sand_options> later_options;
    grit_sand_options& options = later_options.here;
    grit_sand_options_init(&options, sizeof options);
    if (in.one_in(16)) later_options.behind[in.byte()] = 1;
    options.evaluation_limit = in.one_in(8) ? in.raw<int>() : 400;
    if (options.evaluation_limit > 2000) options.evaluation_limit = 2000;
    if (in.one_in(4)) options.tolerance = in.number(1e-3);
    options.intergranular_off = in.one_in(8) ? in.raw<int>() : in.below(2);
    options.tangent = in.one_in(8) ? in.raw<int>() : in.below(3);
    options.instruction_set = in.one_in(8) ? in.raw<int>() : 0;
    options.stress_is_rotated = in.below(2);
    options.validate_only = in.one_in(8) ? in.raw<int>() : 0;
    if (in.one_in(8)) options.struct_size = any_size(in, sizeof options);

    const std::ptrdiff_t n = 1 + in.below(12);
    const int components = in.below(4) == 0 ? 4 : 6;
    Column strain(in, n, most_components, false), rotation(in, n, 9, false),
        stress(in, n, GRIT_SAND_STATE_SIZE, true),  // is given as the state, too
        state(in, n, GRIT_SAND_STATE_SIZE, true), substep(in, n, 1, true);
    std::vector<double> tangent(static_cast<std::size_t>(n * most_components * most_components));
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        for (int c = 0; c < components; ++c) {
            strain.at(i, c) = in.number(c == 0 ? -1e-3 : 1e-4);
            stress.at(i, c) = in.number(c < 3 ? -100.0 : 1.0);
        }
        for (int c = 0; c < 9; ++c) rotation.at(i, c) = c % 4 == 0 ? 1.0 : 0.0;
        if (in.one_in(8)) rotation.at(i, in.below(9)) = in.number(0.0);
        for (int c = 0; c < GRIT_SAND_STATE_SIZE; ++c)
            state.at(i, c) = c == GRIT_SAND_VOID_RATIO ? in.number(0.6)
                             : in.one_in(4)            ? in.number(1e-5)
                                                       : 0.0;
        if (in.one_in(4)) substep.at(i, 0) = in.number(1e-4);
    }
    std::vector<std::ptrdiff_t> index(static_cast<std::size_t>(n));
    for (std::ptrdiff_t i = 0; i < n; ++i)
        index[static_cast<std::size_t>(i)] =
            in.one_in(40) ? in.below(static_cast<int>(n)) : n - 1 - i;
    fuzz::Padded<grit_sand_points> later_points;
    grit_sand_points& points = later_points.here;
    if (in.one_in(16)) later_points.behind[in.byte()] = 1;
    points.struct_size = in.one_in(8) ? any_size(in, sizeof points) : sizeof points;
    points.components = in.one_in(16) ? in.raw<int>() : components;
    if (points.components != components && points.components != 0)
        points.components %= components + 1;
    if (points.components == 0 && components == 4) points.components = 4;
    points.reserved = in.one_in(32) ? in.raw<int>() : 0;
    if (in.one_in(3)) points.index = index.data();
    if (!in.one_in(32)) points.strain_increment = strain.in();
    if (in.one_in(3)) points.rotation_increment = rotation.in();
    if (!in.one_in(32)) points.stress = stress.out();
    if (!in.one_in(32)) points.state = state.out();
    if (!in.one_in(16))
        points.tangent =
            grit_mutable_matrix_view_of(tangent.data(), components * components, components, 1);
    if (in.one_in(2)) points.substep = substep.out();
    // Of the widest kinds of misuse that can be judged without touching the memory.
    if (in.one_in(24)) points.stress.point_stride = in.one_in(2) ? 0 : points.stress.point_stride;
    if (in.one_in(24)) points.state = points.stress;
    const std::ptrdiff_t count = in.one_in(16)   ? -static_cast<std::ptrdiff_t>(in.byte())
                                 : in.one_in(16) ? 0
                                                 : n;
    std::vector<grit_sand_report> reports(static_cast<std::size_t>(n));
    const int how = in.below(4);
    const bool with_reports = !in.one_in(4), with_error = !in.one_in(4);
    grit_sand_report* told = with_reports ? reports.data() : nullptr;
    grit_error* why = with_error ? &error : nullptr;
    if (how == 0) {
        Column pressure(in, n, 1, true), total(in, n, most_components, true);
        fuzz::Padded<grit_sand_water> later_water;
        grit_sand_water& water = later_water.here;
        grit_sand_water_init(&water, sizeof water);
        water.bulk_modulus = in.number(2e6);
        if (in.one_in(3)) water.largest_tension = in.number(90.0);
        if (!in.one_in(16)) water.pore_pressure = pressure.out();
        if (in.one_in(2)) water.total_stress = total.out();
        if (in.one_in(16)) water.struct_size = any_size(in, sizeof water);
        for (std::ptrdiff_t i = 0; i < n; ++i) pressure.at(i, 0) = in.number(10.0);
        const grit_status status =
            grit_sand_update_undrained(&sand, &options, &water, count, &points, told, why);
        if (status != GRIT_OK) fuzz::refusal = grit_status_name(status);
        return 0;
    }
    const grit_status status =
        grit_sand_update(in.one_in(64) ? nullptr : &sand, in.one_in(16) ? nullptr : &options, count,
                         in.one_in(64) ? nullptr : &points, told, why);
    demand(status >= GRIT_OK && status <= GRIT_NOT_CONVERGED);
    if (status != GRIT_OK) fuzz::refusal = grit_status_name(status);
    return 0;
}
