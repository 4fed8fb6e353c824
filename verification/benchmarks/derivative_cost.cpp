// SPDX-License-Identifier: BSD-3-Clause
// What derivatives by all 13 parameters and the initial void ratio cost beside the plain run: CPU time of this thread,
// the shortest of many passes that take turns. Whole element tests, and single updates.
#include <array>
#include <cstdio>

#include "element/laboratory.hpp"
#include "element/simulate.hpp"
#include "element/start.hpp"
#include "measure.hpp"

namespace {

using namespace benchmarks;
using namespace element;

constexpr int of_p_t = 8;

Directions all_directions() {
    Directions by;
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        if (i != of_p_t) by.push_back(i);
    by.push_back(by_void_ratio);
    return by;
}

template <class Pass> void keep_shortest(double& best, const Pass& pass) {
    const double start = cpu_seconds();
    pass();
    best = std::fmin(best, cpu_seconds() - start);
}

void print(const char* name, double plain, double with) {
    std::printf("| %-30s | %10.2f | %10.2f | %5.2f |\n", name, 1e6 * plain, 1e6 * with,
                with / plain);
}

struct Test {
    const char* name;
    Program program;
};

void time_test(const GritLaw& law, const Test& test) {
    Start start;
    start.stress = -100.0 * unit_tensor();
    start.void_ratio = 0.65;
    const Directions by = all_directions();
    double plain = 1e300, with = 1e300;
    for (int pass = 0; pass < 30; ++pass)
        for (const bool differentiated : {false, true})
            keep_shortest(differentiated ? with : plain, [&] {
                Sample sample;
                sample.point = start_point(law, start);
                if (differentiated) sample.slopes = start_slopes(law, start, by);
                benchmark::DoNotOptimize(simulate(law, sample, test.program).records.size());
            });
    print(test.name, plain, with);
}

void time_updates(const GritLaw& law, double length) {
    constexpr int directions = 14, points = 200;
    const Directions by = all_directions();
    grit_sand_options options{};
    grit_sand_options_init(&options, sizeof options);
    double plain = 1e300, with = 1e300;
    for (int pass = 0; pass < 100; ++pass)
        for (const bool differentiated : {false, true})
            keep_shortest(differentiated ? with : plain, [&] {
                for (int i = 0; i < points; ++i) {
                    const double q = 30.0 * std::sin(i), h = 7e-5 * std::cos(3.0 * i);
                    std::array<double, 6> stress = {-100.0 - q, -100.0 + q, -100.0,
                                                    0.3 * q,    0.0,        0.0};
                    std::array<double, 8> state = {h, -h, 0.5 * h, 0.0, 0.0, 0.0, 0.65, 0.0};
                    const double angle = 0.1 * i;
                    const std::array<double, 6> strain = {length * std::cos(angle),
                                                          length * std::sin(angle),
                                                          0.0,
                                                          0.3 * length,
                                                          0.0,
                                                          0.0};
                    grit_sand_points q_points{};
                    q_points.struct_size = sizeof q_points;
                    q_points.strain_increment = grit_view_of(strain.data(), 6, 1);
                    q_points.stress = grit_mutable_view_of(stress.data(), 6, 1);
                    q_points.state = grit_mutable_view_of(state.data(), 8, 1);
                    if (!differentiated) {
                        grit_sand_update(&law.sand(), &options, 1, &q_points, nullptr, nullptr);
                    } else {
                        std::array<double, 6 * directions> T{};
                        std::array<double, 8 * directions> S{};
                        S[GRIT_SAND_VOID_RATIO * directions + directions - 1] = 1.0;
                        grit_sand_derivatives d{};
                        d.struct_size = sizeof d;
                        d.count = directions;
                        d.parameters = by.data();
                        d.stress = grit_mutable_matrix_view_of(T.data(), 0, directions, 1);
                        d.state = grit_mutable_matrix_view_of(S.data(), 0, directions, 1);
                        grit_sand_update_differentiated(&law.sand(), &options, &d, 1, &q_points,
                                                        nullptr, nullptr);
                        benchmark::DoNotOptimize(T[0]);
                    }
                    benchmark::DoNotOptimize(stress[0]);
                }
            });
    char name[40];
    std::snprintf(name, sizeof name, "single update of %.0e", length);
    print(name, plain / points, with / points);
}

Step of(Step step, int increments, double first_share) {
    step.increments = increments;
    step.first_share = first_share;
    return step;
}

}  // namespace

int main() {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &p);
    const GritLaw law(p);
    std::printf(
        "| %-30s | plain [us] | with [us]  | times |\n|%s|------------|------------|-------|\n",
        "Lausitz sand", "--------------------------------");
    Repetition cycles;
    cycles.times = 5;
    cycles.steps = {of(triaxial_drained(-1e-3), 20, 1e-2), of(triaxial_drained(1e-3), 20, 1e-2)};
    Step cyclic;
    cyclic.kind = cycles;
    for (const Test& test :
         {Test{"drained triaxial", {of(triaxial_drained(-0.1), 100, 1e-4)}},
          Test{"undrained triaxial", {of(triaxial_undrained(-0.1), 100, 1e-4)}},
          Test{"oedometer", {of(oedometer_strain(-0.03), 100, 1e-4)}},
          Test{"oedometer by stress", {of(oedometer_stress(-900.0), 100, 1e-4)}},
          Test{"isotropic by stress", {of(isotropic_stress(-900.0), 100, 1e-4)}},
          Test{"simple shear, constant stress", {of(simple_shear_constant_stress(0.1), 100, 1e-4)}},
          Test{"drained cycles", {cyclic}}})
        time_test(law, test);
    for (const double length : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) time_updates(law, length);
    return 0;
}
