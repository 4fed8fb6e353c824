// SPDX-License-Identifier: GPL-2.0-only
// LAMMPS promises no layout of its classes from one release to the next: one release is the host, and no other.
#pragma once

#include <string>

namespace grit::lammps {

// 29 Sep 2021, Update 2: as lammps_version() says it.
inline constexpr int host_version = 20210929;

// Why a host of this version is refused; empty: it is not.
std::string refusal(int version);

}  // namespace grit::lammps
