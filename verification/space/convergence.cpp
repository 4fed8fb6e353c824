// SPDX-License-Identifier: BSD-3-Clause
// Prints the order of convergence in space: manufactured solution; and Hertz on three grids.
#include <cmath>
#include <cstdio>

#include <tests/space/support/manufactured.hpp>
#include <tests/space/support/meeting.hpp>

int main() {
    using namespace space_test;
    std::printf("| manufactured solution, cells | RMS [m] | order |\n|---|---|---|\n");
    double before = 0.0;
    for (const int cells : {8, 16, 32}) {
        const double now = Manufactured::run(cells, {});
        std::printf("| %d | %.2e |", cells, now);
        if (before > 0.0) std::printf(" %.2f |\n", std::log2(before / now));
        else std::printf(" |\n");
        std::fflush(stdout);
        before = now;
    }
    std::printf("\n| Hertz, cells in a | radius | pressure | askew |\n|---|---|---|---|\n");
    for (const int cells : {3, 5, 7}) {
        const Hertz::Result result = Hertz{.cells = cells}.run();
        std::printf("| %d | %+.1f %% | %+.1f %% | %.0e |\n", cells, 100.0 * result.radius_error,
                    100.0 * result.pressure_error, result.askew);
        std::fflush(stdout);
    }
    return 0;
}
