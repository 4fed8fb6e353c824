// SPDX-License-Identifier: GPL-2.0-only
// How the fix comes into a LAMMPS: from a program around it, from Python, or as a plugin.
#pragma once

extern "C" {

// Adds fix grit/mpm, and the command grit, which adds the fix again after a clear, to the LAMMPS behind a
// handle of lammps_open(). 0: done; 1: another LAMMPS, said on standard error, and nothing was touched.
__attribute__((visibility("default"))) int grit_lammps_add(void* lammps);

// For "plugin load", in a LAMMPS with the package PLUGIN.
__attribute__((visibility("default"))) void lammpsplugin_init(void* lammps, void* handle,
                                                              void* register_plugin);
}
