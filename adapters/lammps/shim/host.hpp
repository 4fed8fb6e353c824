// SPDX-License-Identifier: GPL-2.0-only
// The headers of LAMMPS, as Debian installs them, and what is missing there.
#pragma once

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <error.h>
#include <fix.h>
#include <group.h>
#include <input.h>
#include <modify.h>
#include <neighbor.h>
#include <output.h>
#include <timer.h>
#include <update.h>
#include <variable.h>

namespace LAMMPS_NS {

// command.h is not installed.
class Command : protected Pointers {
  public:
    explicit Command(LAMMPS* host) : Pointers(host) {}
    virtual void command(int, char**) = 0;
};

}  // namespace LAMMPS_NS
