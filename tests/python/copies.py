# SPDX-License-Identifier: BSD-3-Clause
"""A copied or pickled sand is the same sand, in another process too."""
import copy
import multiprocessing
import pickle
import unittest

import numpy as np

import grit
from samples import N, state, strain, stress

SANDS = {
    "published": grit.Sand("lausitz"),
    "in Pa": grit.Sand("lausitz", stress_scale=1000),
    "changed": grit.Sand("lausitz", critical_friction_angle=1 / 1.7, pressure_shift=0.1 + 0.2),
    "without intergranular strain": grit.Sand(**{
        name: value for name, value in grit.Sand("lausitz").parameters.items() if name not in (
            "reversal_stiffness", "transverse_stiffness", "elastic_strain_radius",
            "evolution_exponent", "stiffness_interpolation_exponent")}),
}


def update(sand):
    s, z, tangent = stress(), state(), np.empty((N, 6, 6))
    if "elastic_strain_radius" not in sand.parameters:
        z[:, :6] = 0
    sand.update(strain(), s, z, tangent=tangent)
    return s, z, tangent


class Copies(unittest.TestCase):
    def same(self, sand, other, name):
        self.assertIsInstance(other, grit.Sand)
        self.assertIsNot(other, sand)
        self.assertEqual(other.parameters, sand.parameters, name)
        for a, b in zip(update(sand), update(other)):
            self.assertEqual(a.tobytes(), b.tobytes(), name)

    def test_update_to_the_same_bits(self):
        for name, sand in SANDS.items():
            self.same(sand, copy.copy(sand), name)
            self.same(sand, copy.deepcopy({"sand": [sand]})["sand"][0], name)
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                self.same(sand, pickle.loads(pickle.dumps(sand, protocol)), name)

    def test_update_to_the_same_bits_in_another_process(self):
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            for (name, sand), ends in zip(SANDS.items(), pool.map(update, SANDS.values())):
                for a, b in zip(update(sand), ends):
                    self.assertEqual(a.tobytes(), b.tobytes(), name)

    def test_of_what_is_not_copied_are_refused(self):
        for other in grit.stage.oedometer(-0.01), grit.ContactSurfaces(np.zeros((1, 2)), np.zeros((1, 2))):
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.assertRaises(TypeError):
                    pickle.dumps(other, protocol)

    def test_of_what_is_no_sand_are_refused(self):
        parts = grit.Sand("lausitz").parameters
        with self.assertRaises(grit.BadParameter):
            grit.Sand.__new__(grit.Sand).__setstate__({**parts, "granulate_hardness": -1.0})
        with self.assertRaises(grit.BadParameter):
            grit.Sand.__new__(grit.Sand).__setstate__({})


class Repr(unittest.TestCase):
    def test_makes_the_sand_anew(self):
        for sand in SANDS.values():
            self.assertTrue(repr(sand).startswith("grit.Sand(critical_friction_angle="), repr(sand))
            self.assertEqual(eval(repr(sand)).parameters, sand.parameters)


if __name__ == "__main__":
    unittest.main()
