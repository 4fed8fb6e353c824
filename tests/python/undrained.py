# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import grit
from samples import N, sand, state, strain, stress, updated

K_w = 2.2e6
NORMAL = np.array([1.0, 1, 1, 0, 0, 0])


def increments():
    d = strain()
    d[-1, 0] = 5e-3  # cavitates
    return d


def undrained(**options):
    s, z, p_w, total = stress(), state(), np.full(N, 50.0), np.empty((N, 6))
    options = {"bulk_modulus": K_w, "largest_tension": 100.0, "total_stress": total, **options}
    reports = sand.update_undrained(increments(), s, z, p_w, **options)
    return s, z, p_w, total, reports


class Undrained(unittest.TestCase):
    def test_is_the_update_of_the_sand_and_its_water(self):
        drained_tangent, tangent = np.empty((N, 6, 6)), np.empty((N, 6, 6))
        drained, drained_state = stress(), state()
        sand.update(increments(), drained, drained_state, tangent=drained_tangent)
        s, z, p_w, total, reports = undrained(tangent=tangent)
        self.assertTrue(np.array_equal(s, drained) and np.array_equal(z, drained_state))
        e = z[:, grit.VOID_RATIO]
        np.testing.assert_allclose(p_w, 50 - K_w * np.log(e / 0.62), rtol=0, atol=1e-6)
        np.testing.assert_allclose(s - total, np.maximum(p_w, -100)[:, None] * NORMAL, atol=1e-9)
        bears = p_w > -100
        self.assertEqual(bears.tolist(), [True] * (N - 1) + [False])
        self.assertTrue(np.array_equal((reports["flags"] & grit.CAVITATED) == 0, bears))
        K = np.where(bears, K_w * (1 + e) / e, 0)
        np.testing.assert_allclose(tangent - drained_tangent,
                                   K[:, None, None] * np.outer(NORMAL, NORMAL), atol=1e-6)

    def test_gives_each_point_the_same_bits_alone(self):
        s, z, p_w, total, _ = undrained()
        for i in range(N):
            s_i, z_i, p_i, total_i = stress()[i], state()[i], np.array([50.0]), np.empty(6)
            sand.update_undrained(increments()[i], s_i, z_i, p_i, bulk_modulus=K_w,
                                  largest_tension=100.0, total_stress=total_i)
            self.assertTrue(np.array_equal(s_i, s[i]) and np.array_equal(z_i, z[i]))
            self.assertTrue(p_i[0] == p_w[i] and np.array_equal(total_i, total[i]))

    def test_knows_a_constant_porosity(self):
        p_w = undrained(porosity=0.5)[2]
        np.testing.assert_allclose(p_w, 50 - 2 * K_w * increments()[:, :3].sum(1), rtol=1e-12)

    def test_of_drained_water_is_the_update(self):
        s, z, p_w, total, _ = undrained(bulk_modulus=0)
        self.assertTrue(np.array_equal(s[:-1], updated()[0][:-1]) and (p_w == 50).all())

    def test_takes_the_points_of_an_index(self):
        _, _, p_w, _, reports = undrained(index=np.array([3, 1]))
        self.assertEqual((len(reports), (p_w == 50).tolist()), (2, [True, False, True, False, True]))

    def test_refuses_and_changes_nothing(self):
        for error, words, options in (
                (grit.BadParameter, "bulk_modulus must be >= 0 and finite", {"bulk_modulus": -1}),
                (grit.BadParameter, "porosity must be 0", {"porosity": 2}),
                (grit.BadParameter, "largest_tension must be >= 0", {"largest_tension": -1}),
                (grit.BadCall, r"total_stress must be \(5, 6\), got \(5, 4\)",
                 {"total_stress": np.empty((N, 4))})):
            s, z, p_w = stress(), state(), np.full(N, 50.0)
            with self.assertRaisesRegex(error, words):
                sand.update_undrained(increments(), s, z, p_w, **{"bulk_modulus": K_w, **options})
            self.assertTrue(np.array_equal(s, stress()) and (p_w == 50).all())
        s, p_w = stress(), np.full(N, 50.0)
        with self.assertRaisesRegex(grit.BadCall, r"pore_pressure must be \(5,\), got \(4,\)"):
            sand.update_undrained(increments(), s, state(), p_w[:4], bulk_modulus=K_w)
        with self.assertRaisesRegex(grit.BadCall, "pore_pressure must be a NumPy array"):
            sand.update_undrained(increments(), s, state(), None, bulk_modulus=K_w)
        with self.assertRaisesRegex(grit.BadCall, "memory|overlap"):
            sand.update_undrained(increments(), s, state(), s[:, 0], bulk_modulus=K_w)
        p_w[2] = np.nan
        with self.assertRaisesRegex(grit.BadState, "point 2: pore_pressure must be finite, got nan"):
            sand.update_undrained(increments(), s, state(), p_w, bulk_modulus=K_w)
        self.assertTrue(np.array_equal(s, stress()))


if __name__ == "__main__":
    unittest.main()
