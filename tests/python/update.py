# SPDX-License-Identifier: BSD-3-Clause
import threading
import unittest

import numpy as np

import grit
from samples import N, sand, state, strain, stress, updated


class Update(unittest.TestCase):
    def same(self, a, b):
        self.assertTrue(np.array_equal(a, b))

    def test_follows_the_rate_where_the_increment_is_small(self):
        d, s, z = strain()[0] * 1e-4, stress()[0], state()[0]
        rate, state_rate = sand.rate(s, z, d)
        sand.update(d, s, z, tolerance=1e-9)
        np.testing.assert_allclose(s - stress()[0], rate, rtol=1e-3, atol=1e-7)
        np.testing.assert_allclose(z - state()[0], state_rate, rtol=1e-3, atol=1e-12)

    def test_gives_each_point_the_same_bits_alone(self):
        tangent = np.empty((N, 6, 6))
        s, z = updated(tangent=tangent)
        for i in range(N):
            s_i, z_i, tangent_i = stress()[i], state()[i], np.empty((6, 6))
            sand.update(strain()[i], s_i, z_i, tangent=tangent_i)
            self.same(s_i, s[i])
            self.same(z_i, z[i])
            self.same(tangent_i, tangent[i])

    def test_gives_a_tangent_whose_rows_are_stress(self):
        d, tangent = strain()[3], np.empty((6, 6))
        sand.update(d, stress()[3], state()[3], tangent=tangent, tolerance=1e-10)
        for j in range(6):
            ends = []
            for sign in (1, -1):
                step, s = d.copy(), stress()[3]
                step[j] += sign * 1e-9
                sand.update(step, s, state()[3], tolerance=1e-10)
                ends.append(s)
            np.testing.assert_allclose((ends[0] - ends[1]) / 2e-9, tangent[:, j], rtol=1e-3, atol=20)
        self.assertGreater(abs(tangent - tangent.T).max(), 100)

    def test_writes_to_arrays_with_gaps_and_leaves_the_gaps(self):
        s, z = updated()
        wide, columns = np.full((2 * N, 9), 7.0), np.asfortranarray(state())
        wide[::2, 1:7] = stress()
        backwards = strain()[::-1].copy()[::-1]
        sand.update(backwards, wide[::2, 1:7], columns)
        self.same(wide[::2, 1:7], s)
        self.same(columns, z)
        self.assertTrue((wide[1::2] == 7).all() and (wide[:, [0, 7, 8]] == 7).all())

    def test_takes_the_fields_of_a_structured_array(self):
        points = np.zeros(N, dtype=[("stress", "f8", 6), ("id", "i8"), ("state", "f8", 8)])
        points["stress"], points["state"], points["id"] = stress(), state(), 3
        sand.update(strain(), points["stress"], points["state"])
        s, z = updated()
        self.same(points["stress"], s)
        self.same(points["state"], z)
        self.assertTrue((points["id"] == 3).all())

    def test_takes_the_points_of_an_index_only(self):
        s, z = stress(), state()
        reports = sand.update(strain(), s, z, index=np.array([3, 1]))
        done, _ = updated()
        self.assertEqual(reports.shape, (2,))
        for i in range(N):
            self.same(s[i], done[i] if i in (1, 3) else stress()[i])
        s = stress()
        self.assertEqual(sand.update(strain(), s, z, index=np.array([], dtype=int)).shape, (0,))
        self.same(s, stress())

    def test_turns_stress_by_the_rotation(self):
        Q = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])  # 11 goes to 22
        turned = [-60, -100, -70, -10, -3, -5]
        for rotation in (np.tile(Q, (N, 1, 1)), np.asfortranarray(np.tile(Q, (N, 1, 1)))):
            s, z = stress(), state()
            sand.update(np.zeros((N, 6)), s, z, rotation_increment=rotation)
            np.testing.assert_allclose(s, np.tile(turned, (N, 1)), atol=1e-12)
        s = stress()
        sand.update(np.zeros((N, 6)), s, state(), rotation_increment=rotation,
                    stress_is_rotated=True)
        self.same(s, stress())

    def test_takes_four_components(self):
        d, s, z = strain(), stress(), state()
        d[:, 4:], s[:, 4:] = 0, 0
        plane, plane_z = s[:, :4].copy(), z.copy()
        sand.update(d, s, z)
        sand.update(d[:, :4], plane, plane_z)
        self.same(plane, s[:, :4])
        self.same(plane_z, z)

    def test_reports_what_it_did_and_advises_the_next_step(self):
        substep = np.zeros(N)
        s, z = stress(), state()
        reports = sand.update(strain(), s, z, substep=substep)
        self.assertTrue((reports["status"] == 0).all() and (reports["evaluations"] > 0).all())
        self.assertTrue((substep > 0).all())

    def test_takes_one_increment_for_all_and_no_points_at_all(self):
        s, z = stress(), state()
        sand.update(np.broadcast_to(strain()[1], (N, 6)), s, z)
        self.same(s, np.tile(updated()[0][1], (N, 1)))
        self.assertEqual(sand.update(*(np.zeros((0, k)) for k in (6, 6, 8))).shape, (0,))

    def test_validates_without_a_change(self):
        s, z = stress(), state()
        sand.update(strain(), s, z, validate_only=True)
        self.same(s, stress())
        self.same(z, state())

    def test_serves_two_threads_at_once(self):
        many = 400
        ends = [np.tile(stress(), (many, 1)) for _ in range(2)]
        threads = [threading.Thread(target=sand.update, args=(
            np.tile(strain(), (many, 1)), s, np.tile(state(), (many, 1)))) for s in ends]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for s in ends:
            self.same(s, np.tile(updated()[0], (many, 1)))


class SandTest(unittest.TestCase):
    def test_knows_its_parameters_in_the_unit_given(self):
        in_pa = grit.Sand("lausitz", stress_scale=1000).parameters
        self.assertEqual(in_pa["granulate_hardness"], 1.6e9)
        self.assertEqual(grit.Sand(**in_pa).parameters, in_pa)
        self.assertIn("lausitz", grit.sands())

    def test_multiplies_its_operators_by_columns(self):
        d = strain()[0]
        L, N_6 = sand.stiffness(stress()[0], 0.62)
        rate, _ = sand.rate(stress()[0], state()[0], d, intergranular_strain=False)
        length = np.sqrt((d[:3] ** 2).sum() + (d[3:] ** 2).sum() / 2)
        np.testing.assert_allclose(L @ d + N_6 * length, rate, rtol=1e-12)

    def test_tells_invariants_and_states_at_rest(self):
        s = sand.stress_at_rest(10.0, 2.0, K0=0.4)
        np.testing.assert_allclose(s, [-8, -8, -20, 0, 0, 0])
        values = sand.invariants(s, sand.state(0.62))
        self.assertAlmostEqual(values["p"], 12)
        self.assertAlmostEqual(values["q"], 12)
        e_i, e_c, e_d = sand.void_ratios(0.0)
        self.assertTrue(e_i > e_c > e_d)
        self.assertLess(sand.void_ratio_at_pressure(0.7, 100.0), 0.7)
        self.assertGreater(sand.wave_modulus(s, 0.62), 0)


if __name__ == "__main__":
    unittest.main()
