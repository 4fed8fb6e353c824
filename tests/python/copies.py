# SPDX-License-Identifier: BSD-3-Clause
"""A copied or pickled sand is the same sand, in another process too."""
import copy
import multiprocessing
import os
import pickle
import re
import subprocess
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

    def test_of_stages_do_the_same(self):
        stage = grit.stage.triaxial_drained(-0.01, increments=7, first_share=1e-2)
        self.assertEqual(repr(stage), "grit.stage.triaxial_drained(-0.01, 7, 0.01)")
        test = lambda each: grit.element_test(SANDS["published"], each, [-100.0, -100, -100, 0, 0, 0], 0.6)["stress"]
        copies = [pickle.loads(pickle.dumps(stage, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        for other in [*copies, copy.copy(stage), copy.deepcopy(stage)]:
            np.testing.assert_array_equal(test(other), test(stage))
        self.assertEqual(repr(pickle.loads(pickle.dumps(grit.stage.drain(3)))), "grit.stage.drain(3, 0.0)")

    def test_of_what_is_not_copied_are_refused(self):
        other = grit.ContactSurfaces(np.zeros((1, 2)), np.zeros((1, 2)))
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with self.assertRaises(TypeError):
                pickle.dumps(other, protocol)

    def test_that_nobody_has_made_are_refused(self):
        with self.assertRaisesRegex(TypeError, "a Stage is made by the functions of grit.stage"):
            grit.stage.Stage()
        with self.assertRaises(TypeError):
            grit.stage.Stage.__new__(grit.stage.Stage)
        none = grit.ContactSurfaces.__new__(grit.ContactSurfaces)
        for call in (none.gap, lambda: none.surface, lambda: none.merge(none),
                     lambda: none.add("a", np.zeros((1, 2)), np.zeros((1, 1), int)), lambda: none.distance("a")):
            with self.assertRaisesRegex(grit.BadCall, "were never made"):
                call()

    def test_of_props_are_the_same_sand(self):
        published = SANDS["published"].parameters
        for layout in "classic", "radian":
            said = subprocess.run([os.environ["GRIT_CLI"], "sand", "show", "lausitz", "--props", layout, "--void-ratio", "0.6"],
                                  capture_output=True, text=True, check=True).stdout
            props = [float(word) for line in said.splitlines() if not line.startswith("#") for word in re.split("[, ]+", line.strip(" ,")) if word]
            ours = grit.Sand.from_props(props, layout).parameters
            self.assertEqual(ours.keys(), published.keys())
            for name, value in published.items():
                self.assertAlmostEqual(ours[name], value, delta=1e-14 * abs(value), msg=name)
        self.assertEqual(grit.Sand("lausitz", phi_c=0.5).parameters["critical_friction_angle"], 0.5)
        for props, layout, message in (([1.0] * 13, "classic", "props must have 14 numbers at least, got 13"),
                                       ([1.0] * 16, "old", 'layout must be "classic" or "radian", got "old"')):
            with self.assertRaises(grit.BadCall) as caught:
                grit.Sand.from_props(props, layout)
            self.assertEqual(str(caught.exception), message)

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
