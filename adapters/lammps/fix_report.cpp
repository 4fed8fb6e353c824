// SPDX-License-Identifier: GPL-2.0-only
// fix grit/mpm: what a run has cost, after it.
#include <algorithm>
#include <cstdio>

#include "adapters/lammps/fix_grit_mpm.hpp"

namespace grit::lammps {

void FixGritMpm::report_traffic() {
    const Halo::Traffic& now = run->halo().traffic();
    const double steps = std::max(1.0, static_cast<double>(update->ntimestep - first_step));
    double mine[] = {static_cast<double>(now.messages - traffic_before.messages) / steps,
                     static_cast<double>(now.bytes - traffic_before.bytes) / steps,
                     static_cast<double>(now.reductions - traffic_before.reductions) / steps,
                     now.seconds - traffic_before.seconds, MPI_Wtime() - run_began};
    constexpr int count = sizeof mine / sizeof *mine;
    double most[count];
    MPI_Reduce(mine, most, count, MPI_DOUBLE, MPI_MAX, 0, world);
    if (comm->me != 0) return;
    char line[256];
    std::snprintf(
        line, sizeof line,
        "Grit: halo exchange %.3g s of %.3g s (%.1f %%); a step has up to %.4g messages of "
        "%.6g bytes together and %.4g reductions per process\n",
        most[3], most[4], 100.0 * most[3] / std::max(most[4], 1e-30), most[0], most[1], most[2]);
    LAMMPS_NS::utils::logmesg(lmp, std::string(line));
}

}  // namespace grit::lammps
