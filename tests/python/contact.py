# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import grit


class Contact(unittest.TestCase):
    """Masses 1 and 3 approach along 11 with a velocity of 4, three nodes at different distances."""

    def setUp(self):
        self.nodes = {
            "mass_a": np.ones(3), "mass_b": np.full(3, 3.0),
            "normal": np.tile([1.0, 0], (3, 1)),
            "velocity_a": np.tile([3.0, 7], (3, 1)), "velocity_b": np.tile([-1.0, 7], (3, 1)),
            "distance": np.array([0, 0.25, 0.5]), "spacing": np.array([0.5, 2.0])}
        self.f_p = np.array([1, grit.penalty_factor(0.25, 0.5), 0])

    def test_scales_the_impulse_by_the_penalty_factor(self):
        self.assertEqual(self.f_p[1], 1 - 0.5**6)
        reports = grit.contact_correct(**self.nodes, time_step=0.1)
        np.testing.assert_allclose(self.nodes["velocity_a"][:, 0], 3 - 3 * self.f_p, atol=1e-14)
        np.testing.assert_allclose(self.nodes["velocity_b"][:, 0], -1 + self.f_p, atol=1e-14)
        np.testing.assert_allclose(reports["impulse"][:, 0], 3 * self.f_p)
        np.testing.assert_allclose(reports["force"][:, 0], 30 * self.f_p)
        self.assertEqual(reports["state"].tolist(), [grit.SLIP, grit.SLIP, grit.OPEN])
        self.assertTrue((self.nodes["velocity_a"][:, 1] == 7).all())

    def test_is_frictional_contact_without_a_distance(self):
        del self.nodes["distance"], self.nodes["spacing"]
        self.nodes["velocity_a"][:, 1] = 6
        reports = grit.contact_correct(**self.nodes, law="frictional", friction_coefficient=0.9)
        np.testing.assert_allclose(self.nodes["velocity_a"], self.nodes["velocity_b"], atol=1e-14)
        self.assertTrue((reports["state"] == grit.STICK).all())

    def test_writes_to_sections_at_the_nodes_of_an_index(self):
        velocity = np.zeros((3, 2, 2))
        velocity[:, 0], velocity[:, 1] = self.nodes["velocity_a"], self.nodes["velocity_b"]
        self.nodes.update(velocity_a=velocity[:, 0], velocity_b=velocity[:, 1])
        reports = grit.contact_correct(**self.nodes, index=np.array([1]))
        self.assertEqual(reports.shape, (1,))
        np.testing.assert_allclose(velocity[:, 0, 0], [3, 3 - 3 * self.f_p[1], 3], atol=1e-14)

    def test_keeps_a_rigid_body(self):
        grit.contact_correct(**self.nodes, rigid="a")
        self.assertTrue((self.nodes["velocity_a"][:, 0] == 3).all())
        self.assertEqual(self.nodes["velocity_b"][0, 0], 3)

    def test_corrects_accelerations(self):
        a, b = np.zeros((3, 2)), np.zeros((3, 2))
        grit.contact_correct(**self.nodes, acceleration_a=a, acceleration_b=b, time_step=0.1)
        np.testing.assert_allclose(a[:, 0], -30 * self.f_p)
        np.testing.assert_allclose(b[:, 0], 10 * self.f_p)

    def test_relaxes_in_its_own_time_whatever_the_step(self):
        for _ in range(4):
            grit.contact_correct(**self.nodes, time_step=0.01, relaxation_time=0.04)
        w = self.nodes["velocity_a"][:, 0] - self.nodes["velocity_b"][:, 0]
        np.testing.assert_allclose(w, 4 * (1 - self.f_p), atol=1e-14)

    def test_pushes_what_overlaps_apart(self):
        self.nodes["velocity_b"][:, 0] = 3
        overlap, stiffness, area, dt = 0.01, 100.0, 2.0, 0.1
        reports = grit.contact_correct(**self.nodes, gap=np.full(3, -overlap), time_step=dt,
                                       contact_area=np.full(3, area), contact_stiffness=stiffness)
        f, m = self.f_p[1], 0.75
        C, K = m * f / ((1 - f) * dt), stiffness * area
        J = dt * K * overlap / (1 + (C + K * dt) * dt / m)
        np.testing.assert_allclose(reports["impulse"][:, 0], [0, J, 0], rtol=1e-12)

    def test_does_not_rub_with_what_water_carries(self):
        self.nodes["velocity_a"][:, 1] = 0  # slips
        carried = 0.25 * 3 * self.f_p
        reports = grit.contact_correct(**self.nodes, friction_coefficient=0.1, pore_impulse=carried)
        np.testing.assert_allclose(reports["impulse"][:, 0], 3 * self.f_p)
        np.testing.assert_allclose(-reports["impulse"][:, 1], 0.1 * 0.75 * 3 * self.f_p)

    def test_refuses_what_it_cannot_take_and_changes_nothing(self):
        bad_normal = np.array([[1.0, 0], [1, 0.5], [1, 0]])
        read_only = self.nodes["velocity_b"].copy()
        read_only.flags.writeable = False
        for message, kind, changes in (
                ("mass_a must be (3,), got (2,)", grit.BadCall, {"mass_a": np.ones(2)}),
                ("normal must be (n, 2) or (n, 3), without n for one point, got (3, 4)", grit.BadCall,
                 {"normal": np.ones((3, 4))}),
                ("mass_b must be an array of float64, got int64", grit.BadCall,
                 {"mass_b": np.ones(3, int)}),
                ("velocity_b is written to, but is read-only", grit.BadCall,
                 {"velocity_b": read_only}),
                ("velocity_a and velocity_b share memory, and one of them is written to", grit.BadCall,
                 {"velocity_b": self.nodes["velocity_a"]}),
                ("law must be \"geo\" or \"frictional\", got \"gca\"", grit.BadCall, {"law": "gca"}),
                ("rigid must be None, \"a\" or \"b\", got \"c\"", grit.BadCall, {"rigid": "c"}),
                ("node 2: mass_a must be in [0, 1e100] [mass], got -1", grit.BadState,
                 {"mass_a": np.array([1.0, 1, -1])}),
                ("node 1: normal must be a unit vector, |n|^2 within 1e-06 of 1 [-], got |n| = 1.11803",
                 grit.BadState, {"normal": bad_normal})):
            with self.assertRaises(kind) as caught:
                grit.contact_correct(**{**self.nodes, **changes})
            self.assertEqual(str(caught.exception), message)
            self.assertTrue((self.nodes["velocity_a"] == [3, 7]).all())
            self.assertTrue((self.nodes["velocity_b"] == [-1, 7]).all())


if __name__ == "__main__":
    unittest.main()
