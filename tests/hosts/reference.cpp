// SPDX-License-Identifier: BSD-3-Clause
// The cases of the hosts, through the C ABI and the library of element tests: a line for each with its
// end, stress [kPa, tension +], void ratio, pore pressure [kPa].
#include <cstdio>

#include <element/grit_law.hpp>
#include <element/laboratory.hpp>
#include <element/simulate.hpp>

namespace {

using element::Program;
using element::Step;

Step with_increments(Step step, int increments) {
    step.increments = increments;
    return step;
}

int run(const element::GritLaw& law, const char* name, double pressure, double void_ratio,
        const Program& program) {
    const element::Vector6 isotropic = element::unit_tensor();
    element::Sample sample;
    sample.point = law.start(-pressure * isotropic, void_ratio);
    law.mobilise(sample.point, -isotropic, 1.0);
    const element::History history = element::simulate(law, sample, program);
    if (history.failure) {
        std::fprintf(stderr, "%s: %s\n", name, history.failure->message.c_str());
        return 1;
    }
    const element::Record& end = history.records.back();
    std::printf("%-10s %.16e %.16e %.16e %.16e\n", name, end.effective_stress[0],
                end.effective_stress[1], end.void_ratio, end.pore_pressure);
    return 0;
}

}  // namespace

int main() {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &parameters);
    const element::GritLaw law(parameters);
    Program cycles;
    for (const double strain : {-1e-3, 2e-3, -2e-3, 2e-3, -2e-3, 2e-3})
        cycles.push_back(with_increments(element::triaxial_drained(strain), 200));
    return run(law, "oedometer", 10, 0.7,
               {with_increments(element::oedometer_strain(-0.02), 200),
                with_increments(element::oedometer_strain(0.002), 200),
                with_increments(element::oedometer_strain(-0.01), 200)}) +
           run(law, "drained", 100, 0.55, {with_increments(element::triaxial_drained(-0.2), 400)}) +
           run(law, "undrained", 100, 0.7,
               {with_increments(element::triaxial_undrained(-0.1), 400)}) +
           run(law, "cyclic", 100, 0.6, cycles);
}
