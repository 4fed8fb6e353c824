# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import grit
from samples import N, sand, state, strain, stress


class Refusals(unittest.TestCase):
    def refused(self, message, kind=grit.BadCall, **changes):
        """The update with these arguments raises this message and changes no array."""
        arguments = {"strain_increment": strain(), "stress": stress(), "state": state(), **changes}
        before = {name: np.copy(a) for name, a in arguments.items() if isinstance(a, np.ndarray)}
        with self.assertRaises(kind) as caught:
            sand.update(**arguments)
        self.assertEqual(str(caught.exception), message)
        self.assertIsInstance(caught.exception, ValueError)
        for name, a in before.items():
            np.testing.assert_array_equal(arguments[name], a, name)
        return caught.exception

    def test_wrong_shapes(self):
        self.refused("strain_increment must be (n, 6) or (n, 4), without n for one point, got (5, 5)",
                     strain_increment=strain()[:, :5].copy())
        self.refused("stress must be (5, 6), got (4, 6)", stress=stress()[:4])
        self.refused("stress must be (5, 6), got (6, 5)", stress=stress().T.copy())
        self.refused("state must be (5, 8), got (5, 7)", state=state()[:, :7])
        self.refused("state must be (5, 8), got (40,)", state=state().ravel())
        self.refused("tangent must be (5, 6, 6), got (5, 36)", tangent=np.zeros((N, 36)))
        self.refused("rotation_increment must be (5, 3, 3), got (3, 3)", rotation_increment=np.eye(3))
        self.refused("substep must be (5,), got (5, 1)", substep=np.zeros((N, 1)))
        self.refused("stress must be (6,), got (5, 6)", strain_increment=strain()[0])

    def test_wrong_types(self):
        self.refused("stress must be an array of float64, got float32",
                     stress=stress().astype(np.float32))
        self.refused("stress must be an array of float64, got >f8", stress=stress().astype(">f8"))
        self.refused("state must be an array of float64, got int64", state=state().astype(int))
        self.refused("stress must be a NumPy array of float64, got list", stress=stress().tolist())
        self.refused("stress must be a NumPy array of float64, got None", stress=None)
        self.refused("index must be an array of int64, got float64", index=np.zeros(2))
        self.refused("index must be an array of int64, got list", index=[0])

    def test_memory_that_cannot_be_viewed(self):
        packed = np.zeros(N, dtype=[("gap", "i4"), ("stress", "f8", 6)])
        packed["stress"] = stress()
        self.refused("stress must be aligned, with strides that are multiples of 8 bytes: pass a copy",
                     stress=packed["stress"])

    def test_read_only_arrays(self):
        for name, array in (("stress", stress()), ("state", state()), ("substep", np.zeros(N)),
                            ("tangent", np.zeros((N, 6, 6)))):
            array.flags.writeable = False
            self.refused(f"{name} is written to, but is read-only", **{name: array})
        fixed = strain()
        fixed.flags.writeable = False
        sand.update(fixed, stress(), state())  # what is only read may be

    def test_memory_that_is_used_twice(self):
        same = np.zeros((N, 8))
        same[:, 6] = 0.62
        self.refused("stress and state share memory, and one of them is written to",
                     stress=same[:, :6], state=same)
        both = strain()
        self.refused("strain_increment and stress share memory, and one of them is written to",
                     strain_increment=both, stress=both)
        rolled = np.lib.stride_tricks.as_strided(np.zeros(2 * N + 6), (N, 6), (16, 8))
        self.refused("stress is written to, but its elements overlap in memory", stress=rolled)

    def test_numbers_that_are_not_finite(self):
        d = strain()
        d[3, 4] = np.nan
        error = self.refused("point 3: strain_increment 13 must be finite, got nan", strain_increment=d)
        self.assertEqual((error.point, error.status), (3, 1))
        s = stress()
        s[2, 0] = np.inf
        error = self.refused("point 2: stress 11 must be finite, got inf", grit.BadState, stress=s)
        self.assertEqual(error.point, 2)
        self.assertEqual(error.reports["status"].tolist(), [0, 0, 3, 0, 0])
        z = state()
        z[4, grit.VOID_RATIO] = -0.1
        self.refused("point 4: void ratio must be in (0, 1e+09], got -0.1", grit.BadState, state=z)

    def test_the_point_of_an_index_is_named(self):
        bad = strain()
        bad[3, 4] = np.nan
        error = self.refused("point 3: strain_increment 13 must be finite, got nan", strain_increment=bad, index=np.array([4, 3]))
        self.assertEqual(error.point, 3)

    def test_an_index_that_leaves_the_arrays(self):
        self.refused("index[1] must be in [0, 5), got 5", index=np.array([0, 5]))
        self.refused("index[0] must be in [0, 5), got -1", index=np.array([-1]))
        self.refused("index[2] = 1 is there twice", index=np.array([1, 0, 1]))
        self.refused("index must be (m,), got (1, 1)", index=np.array([[0]]))

    def test_masks_that_would_be_ignored(self):
        for name, array in (("stress", stress()), ("state", state()), ("strain_increment", strain())):
            self.refused(name + " must have no mask, got a MaskedArray: an index tells which points are taken",
                         **{name: np.ma.masked_array(array, np.zeros_like(array))})
        self.refused("index must have no mask, got a MaskedArray: an index tells which points are taken",
                     index=np.ma.masked_array([0, 1], [1, 0]))

    def test_arguments_of_one_point(self):
        for message, call in (
                ("stress_scale is that of a published sand, and no name was given; got 1000",
                 lambda: grit.Sand(stress_scale=1000, **sand.parameters)),
                ("critical_friction_angle must be a number, got str",
                 lambda: grit.Sand("lausitz", critical_friction_angle="33")),
                ("name must be a string, got int", lambda: grit.Sand(5)),
                ("unit_weight must be >= 0 and finite [stress/length], got -10", lambda: sand.stress_at_rest(-10, 5)),
                ("depth must be >= 0 and finite [length], got -5", lambda: sand.stress_at_rest(10, -5)),
                ("axis must be 0, 1 or 2, got 3", lambda: sand.stress_at_rest(10, 5, axis=3)),
                ("K0 must be finite, got nan", lambda: sand.stress_at_rest(10, 5, K0=np.nan)),
                ("mass_b is missing: body B has both, or none of them",
                 lambda: grit.penalty_stable_step(np.ones(2), np.ones(2), stiffness_b=np.ones(2)))):
            with self.assertRaises(grit.BadCall) as caught:
                call()
            self.assertEqual(str(caught.exception), message)

    def test_options_out_of_range(self):
        self.refused("tolerance must be in [1e-12, 0.1], got 0", tolerance=0.0)

    def test_an_increment_that_is_too_large_keeps_the_point_and_does_the_others(self):
        d, s, z = strain(), stress(), state()
        d[1] *= 30
        with self.assertRaises(grit.NotConverged) as caught:
            sand.update(d, s, z, evaluation_limit=12, tolerance=1e-9)
        reports = caught.exception.reports
        for i in range(N):
            failed = reports["status"][i] != 0
            self.assertEqual(np.array_equal(s[i], stress()[i]), failed)
            self.assertEqual(reports["step_reduction"][i] < 1, failed)
        self.assertTrue(reports["status"][1] == 4)
        self.assertTrue(isinstance(caught.exception, (grit.Error, ArithmeticError)))

    def test_sands_that_do_not_exist(self):
        for message, kind, make in (
                ("there is no sand \"lausit\"; nearest: lausitz", grit.BadCall, lambda: grit.Sand("lausit")),
                ("there is no sand \"hostn\"; nearest: hostun", grit.BadCall, lambda: grit.Sand("hostn")),
                ("there is no sand \"clay\"; known here: " + ", ".join(grit.sands()), grit.BadCall, lambda: grit.Sand("clay")),
                ("a sand has no parameter \"granulate_hardnes\"; nearest: granulate_hardness", grit.BadCall,
                 lambda: grit.Sand("lausitz", granulate_hardnes=1)),
                ("a sand has no parameter \"phi\": help(grit.Sand) tells them", grit.BadCall, lambda: grit.Sand("lausitz", phi=1)),
                ("stress_scale must be > 0, got -1", grit.BadCall,
                 lambda: grit.Sand("lausitz", stress_scale=-1)),
                ("critical_friction_angle must be in [0.1745, 1.047] rad, got 33: degrees?",
                 grit.BadParameter, lambda: grit.Sand("lausitz", critical_friction_angle=33)),
                ("void_ratio must be > 0, got nan", grit.BadCall, lambda: sand.state(np.nan))):
            with self.assertRaises(kind) as caught:
                make()
            self.assertEqual(str(caught.exception), message)


if __name__ == "__main__":
    unittest.main()
