/* SPDX-License-Identifier: BSD-3-Clause
 * Grit: hypoplastic sand for finite-element and material-point codes, behind a stable C ABI.
 *
 * Conventions, everywhere: tension and extension positive; Voigt order 11 22 33 12 13 23 with
 * engineering shear strain (the order of an Abaqus UMAT); angles in radians; any consistent set of
 * units (Pa, kPa, MPa), stress taking the unit of granulate_hardness. No function throws, prints,
 * aborts, allocates, starts a thread or keeps state; all are safe to call from several threads on
 * disjoint data. */
#pragma once

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>
#include <grit/contact_penalty.h>
#include <grit/contact_surface.h>
#include <grit/sand.h>
#include <grit/sand_catalogue.h>
#include <grit/sand_derivatives.h>
#include <grit/sand_operators.h>
#include <grit/sand_water.h>
#include <grit/status.h>
#include <grit/version.h>
#include <grit/view.h>
