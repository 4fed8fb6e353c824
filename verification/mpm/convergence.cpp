// SPDX-License-Identifier: BSD-3-Clause
// Prints the order of convergence of the material-point driver: manufactured solution, confined bar, rolling
// disk; and Hertz on three grids.
#include <cmath>
#include <cstdio>
#include <vector>

#include <tests/mpm/support/confined_bar.hpp>
#include <tests/mpm/support/hertz.hpp>
#include <tests/mpm/support/manufactured.hpp>
#include <tests/mpm/support/rolling_disk.hpp>

namespace {

using namespace mpm_test;

template <class Error>
void print(const char* problem, const std::vector<int>& grids, const Error& error) {
    double before = 0.0;
    int cells_before = 0;
    for (const int cells : grids) {
        const double now = error(cells);
        std::printf("| %s | %d | %.2e |", problem, cells, now);
        if (before > 0.0)
            std::printf(" %.2f |\n", std::log(before / now) /
                                         std::log(static_cast<double>(cells) / cells_before));
        else std::printf(" |\n");
        std::fflush(stdout);
        before = now;
        cells_before = cells;
    }
}

}  // namespace

int main() {
    std::printf("| problem | cells | error | order |\n|---|---|---|---|\n");
    Settings manufactured;
    manufactured.cfl = 0.2;
    print("manufactured solution, RMS [m]", {8, 16, 32, 64},
          [&](int cells) { return Manufactured::run(cells, manufactured).rms; });
    print("... at the axis [m]", {8, 16, 32, 64},
          [&](int cells) { return Manufactured::run(cells, manufactured).axis; });
    print("confined bar, velocity [-]", {16, 32, 64},
          [](int cells) { return vibrate(cells, true).velocity; });
    print("rolling disk, way [-]", {4, 8, 16},
          [](int cells) { return std::fabs(RollingDisk().run(cells).way - 1.0); });
    std::printf("\n| Hertz, cells in a | radius | pressure |\n|---|---|---|\n");
    for (const int cells : {7, 11, 14}) {
        Hertz hertz;
        hertz.cells = cells;
        const Hertz::Result result = hertz.run();
        std::printf("| %.1f | %+.1f %% | %+.1f %% |\n", result.radius * cells / Hertz::a,
                    100.0 * result.radius_error, 100.0 * result.pressure_error);
        std::fflush(stdout);
    }
    return 0;
}
