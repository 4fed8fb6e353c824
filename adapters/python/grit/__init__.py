# SPDX-License-Identifier: BSD-3-Clause
"""Grit: hypoplastic sand and contact at grid nodes, on NumPy arrays.

Tension and extension are positive; components 11 22 33 12 13 23 with engineering shear; logarithmic
strain; angles in radians; any consistent units, stress in the unit of the sand's granulate hardness
(kPa for the sands of sands()).

    sand = grit.Sand("lausitz")
    sand.update(strain_increment, stress, state)     # (n, 6), (n, 6), (n, 8), in place
    sand.update_undrained(strain_increment, stress, state, pore_pressure, bulk_modulus=2.2e6)
    grit.contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b, ...)
    grit.element_test(sand, [grit.stage.triaxial_drained(-0.2)], stress, void_ratio)

Errors are exceptions below grit.Error; a call that raises BadCall or BadState has changed nothing.
"""

from grit._grit import (
    BadCall, BadParameter, BadState, CAVITATED, Error, H_CLAMPED, INACTIVE, InternalError, NotConverged,
    OPEN, OUTSIDE_CONE, SEPARATION, SLIP, STATE_SIZE, STICK, STRESS_FREE, Sand, VOID_CLAMPED, VOID_RATIO,
    __commit__, __version__, contact_correct, element_test, penalty_factor, sands, stage)

__all__ = [
    "BadCall", "BadParameter", "BadState", "CAVITATED", "Error", "H_CLAMPED", "INACTIVE",
    "InternalError", "NotConverged", "OPEN", "OUTSIDE_CONE", "SEPARATION", "SLIP", "STATE_SIZE", "STICK",
    "STRESS_FREE", "Sand", "VOID_CLAMPED", "VOID_RATIO", "__commit__", "__version__",
    "contact_correct", "element_test", "penalty_factor", "sands", "stage"]
