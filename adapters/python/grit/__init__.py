# SPDX-License-Identifier: BSD-3-Clause
"""Grit: hypoplastic sand and contact at grid nodes, on NumPy arrays.

A sand with published parameters, and a sample at 100 kPa that is sheared in a triaxial test:

>>> import numpy, grit
>>> sand = grit.Sand("lausitz")
>>> test = grit.element_test(sand, [grit.stage.triaxial_drained(-0.1)],
...                          stress=[-100, -100, -100, 0, 0, 0], void_ratio=0.6)
>>> test["stress"][-1].round(1)          # a row per increment
array([-406.3, -100. , -100. ,    0. ,    0. ,    0. ])

Tension and extension are positive; components 11 22 33 12 13 23 with engineering shear; logarithmic
strain; angles in radians; any consistent units, stress in that of the sand's granulate hardness
(kPa for the sands of sands()). help() of each of these gives shapes, units, signs and errors:

    sands, Sand            published sands; a sand, and its update of many points (with water, with derivatives)
    element_test, stage    laboratory tests of one sample, stage after stage
    contact_normals, contact_normals_by_regression, ContactSurfaces, contact_correct    contact at grid nodes
    penalty_forces         contact between boundary lines
    Error                  above all exceptions: BadCall, BadParameter, BadState, NotConverged, InternalError

Points of a host, two of them, over one strain increment each: arrays are changed in place.

>>> stress = numpy.tile([-100.0, -100, -100, 0, 0, 0], (2, 1))
>>> state = numpy.tile(sand.state(0.6, direction=[-1, -1, -1, 0, 0, 0]), (2, 1))
>>> strain_increment = numpy.array([[-1e-3, 5e-4, 5e-4, 0, 0, 0], [0.0, 0, 0, 1e-3, 0, 0]])
>>> reports = sand.update(strain_increment, stress, state)
>>> stress[0].round(2)
array([-98.14, -80.37, -80.37,   0.  ,   0.  ,   0.  ])
>>> reports["status"]
array([0, 0], dtype=int32)

Contact of two bodies at grid nodes, here two nodes with A below B: normals from gradients, distances from particles,
one of each body, and one call that corrects the velocities.

>>> normal = grit.contact_normals("a", gradient_a=numpy.array([[0.0, 2], [0.0, 3]]))
>>> surfaces = grit.ContactSurfaces(numpy.array([[0.0, 0], [1, 0]]), normal)
>>> half_sides = numpy.array([[[0.25, 0], [0, 0.25]]])
>>> surfaces.add("a", numpy.array([[0.5, -0.25]]), node=numpy.array([[0, 1]]), side=half_sides)
>>> surfaces.add("b", numpy.array([[0.5, 0.5]]), node=numpy.array([[0, 1]]), side=half_sides)
>>> surfaces.distance(stiffer="a"), surfaces.gap()
(array([0., 0.]), array([0.25, 0.25]))
>>> velocity_a, velocity_b = numpy.array([[0.0, 1], [0, 1]]), numpy.zeros((2, 2))
>>> reports = grit.contact_correct(numpy.ones(2), numpy.ones(2), normal, velocity_a, velocity_b,
...                                distance=surfaces.distance("a"), cell_size=numpy.ones(2))
>>> velocity_a[:, 1], velocity_b[:, 1]
(array([0.5, 0.5]), array([0.5, 0.5]))

A call that raises BadCall or BadState has changed nothing:

>>> sand.update(strain_increment[:, :5], stress, state)
Traceback (most recent call last):
grit.BadCall: strain_increment must be (n, 6) or (n, 4), without n for one point, got (2, 5)
"""

import sys

from grit._grit import (
    BadCall, BadParameter, BadState, CAVITATED, ContactSurfaces, Error, H_CLAMPED, INACTIVE, InternalError,
    NotConverged, OPEN, OUTSIDE_CONE, PENALTY_OPEN, PENALTY_SLIP, PENALTY_STICK, SEPARATION, SLIP, STATE_SIZE,
    STICK, STRESS_FREE, Sand, VOID_CLAMPED, VOID_RATIO, __commit__, __version__, contact_correct,
    contact_normals, contact_normals_by_regression, element_test, penalty_factor, penalty_flush_stiffness,
    penalty_forces, penalty_remesh, penalty_stable_step, penalty_stiffness, sands, stage)

sys.modules["grit.stage"] = stage  # so that "import grit.stage" finds it


def _stage(name, arguments):
    """A stage by the name of its function: what copies and pickles of one call."""
    return getattr(stage, name)(*arguments)


__all__ = [
    "BadCall", "BadParameter", "BadState", "CAVITATED", "ContactSurfaces", "Error", "H_CLAMPED", "INACTIVE",
    "InternalError", "NotConverged", "OPEN", "OUTSIDE_CONE", "PENALTY_OPEN", "PENALTY_SLIP", "PENALTY_STICK",
    "SEPARATION", "SLIP", "STATE_SIZE", "STICK", "STRESS_FREE", "Sand", "VOID_CLAMPED", "VOID_RATIO",
    "__commit__", "__version__", "contact_correct", "contact_normals", "contact_normals_by_regression",
    "element_test", "penalty_factor", "penalty_flush_stiffness", "penalty_forces", "penalty_remesh",
    "penalty_stable_step", "penalty_stiffness", "sands", "stage"]
