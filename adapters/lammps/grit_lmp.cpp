// SPDX-License-Identifier: GPL-2.0-only
// grit-lmp: LAMMPS with fix grit/mpm, and else as lmp.
#define LAMMPS_LIB_MPI 1
#include <library.h>

#include "adapters/lammps/registration.hpp"
#include "adapters/lammps/shim/host.hpp"

int main(int argc, char** argv) {
    MPI_Init(&argc, &argv);
    void* host = lammps_open(argc, argv, MPI_COMM_WORLD, nullptr);
    const int refused = grit_lammps_add(host);
    if (!refused) static_cast<LAMMPS_NS::LAMMPS*>(host)->input->file();
    lammps_close(host);
    MPI_Finalize();
    return refused;
}
