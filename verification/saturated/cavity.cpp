// SPDX-License-Identifier: BSD-3-Clause
// Prints the table of an undrained cavity in docs/saturated.md.
#include <cmath>
#include <cstdio>
#include <limits>

#include <tests/mpm/support/undrained_cavity.hpp>

namespace {

using namespace mpm_test;

enum class Inside { wall, wall_implicit, pressure, nodal_contact };

void row(CavityByPoints points, Inside inside, const UndrainedCavity& exact) {
    points.implicit = inside != Inside::wall;
    if (inside == Inside::nodal_contact) {
        points.kind = ContactKind::geo_ungated;
        points.pic_rate = 50.0;  // as driven piles have it
    }
    if (inside == Inside::pressure)
        points.pressure = [&](double t) { return exact.at(CavityProblem::a, t).total; };
    const CavityErrors seen = compare(points, exact);
    constexpr const char* name[] = {"wall, surface contact", "... implicit", "pressure, implicit",
                                    "wall, GCA, implicit, PIC 50 1/s"};
    const double unit = points.pressure ? 1e3 : 1e-3;
    std::printf("| %.2f | %s | a/%d | %.1f (%.1f) %s | %.1f | %+.1f | %.1f (%.1f) | %.1f (%.1f) | "
                "%.1f, %.1f | %.1f, %.2f |\n",
                points.void_ratio, name[static_cast<int>(inside)], points.cells, unit * seen.wall,
                unit * seen.exact_wall, points.pressure ? "mm" : "kPa", 100.0 * seen.wall_most,
                100.0 * seen.wall_mean, -1e-3 * seen.innermost.sigma_rr,
                1e-3 * seen.exact_innermost.effective, 1e-3 * seen.innermost.p_w,
                1e-3 * seen.exact_innermost.pore, 100.0 * seen.effective_most,
                100.0 * seen.pore_most, 1e-3 * seen.alternating,
                100.0 * seen.alternating / std::fabs(seen.exact_innermost.pore));
    std::fflush(stdout);
}

}  // namespace

int main() {
    std::printf(
        "| e | inside | h | pressure of the wall, or way of the face, at the end | worst "
        "[%%] | mean [%%] | innermost particle, effective [kPa] | p_w [kPa] | worst of the "
        "two up to 2 a [%%] | alternating p_w [kPa], by that of the innermost particle [%%] "
        "|\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const double e : {0.55, 0.75}) {
        CavityByPoints points = undrained_cavity(e, 6);
        const UndrainedCavity exact(points, points.bulk_modulus);
        for (const Inside inside :
             {Inside::wall, Inside::wall_implicit, Inside::pressure, Inside::nodal_contact}) {
            if (inside == Inside::pressure && e > 0.6) continue;  // it has a largest one
            for (const int cells : {6, 12}) {
                points.cells = cells;
                row(points, inside, exact);
            }
        }
        const UndrainedCavity stiff(points, std::numeric_limits<double>::infinity());
        const double end = 0.5 * points.ramp + 0.075 / points.speed;
        std::printf(
            "| %.2f | wall, balance, at 75.0 mm; with incompressible water | – | %.1f; %.1f "
            "kPa | | | | | | |\n",
            e, 1e-3 * exact.at(CavityProblem::a, end).total,
            1e-3 * stiff.at(CavityProblem::a, end).total);
    }
    return 0;
}
