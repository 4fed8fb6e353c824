# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import grit

N, DEPTH, EPS = 5, 0.01, 2e4


class Penalty(unittest.TestCase):
    """Two flat lines of length 4, pressed into each other by a known depth: A above travels right, B below left."""

    def setUp(self):
        self.a = np.column_stack([np.arange(N, dtype=float), np.full(N, -DEPTH)])
        self.b = np.column_stack([np.arange(N, dtype=float)[::-1], np.zeros(N)])
        self.options = {"normal_stiffness": EPS, "depth_max": 0.5}

    def test_presses_with_the_depth_over_the_length(self):
        self.assertEqual(grit.penalty_stiffness(2, 1e4, 1), EPS)
        out = grit.penalty_forces(self.a, self.b, **self.options)
        totals = out["totals"]
        np.testing.assert_allclose(totals["force_on_a"], [0, EPS * DEPTH * (N - 1)], atol=1e-9)
        np.testing.assert_allclose(out["force_a"].sum(axis=0), totals["force_on_a"], atol=1e-9)
        np.testing.assert_allclose(out["force_a"].sum(axis=0) + out["force_b"].sum(axis=0), 0, atol=1e-9)
        np.testing.assert_allclose(out["reports_a"]["gap"], -DEPTH, rtol=1e-12)
        np.testing.assert_allclose(out["reports_a"]["normal"], np.tile([0.0, 1], (N, 1)), atol=1e-14)
        self.assertTrue((out["reports_a"]["state"] == grit.PENALTY_SLIP).all())
        self.assertEqual((totals["contacts_a"], totals["contacts_b"]), (N, N))
        self.assertAlmostEqual(totals["largest_penetration"], DEPTH)
        mass = np.full(N, 2.0)
        step = grit.penalty_stable_step(mass, out["stiffness_a"], mass, out["stiffness_b"])
        self.assertAlmostEqual(step, 2 / np.sqrt((out["stiffness_a"].max() + out["stiffness_b"].max()) / 2))
        self.assertAlmostEqual(grit.penalty_stable_step(mass, out["stiffness_a"]), 2 / np.sqrt(out["stiffness_a"].max() / 2))

    def test_is_nothing_apart(self):
        out = grit.penalty_forces(self.a + [0, 2 * DEPTH], self.b, **self.options)
        self.assertTrue((out["force_a"] == 0).all() and (out["reports_b"]["state"] == grit.PENALTY_OPEN).all())

    def test_sticks_and_then_slips_with_a_history_in_place(self):
        dt, mu = 0.1, 0.3
        a, b = np.zeros((N, 2)), np.zeros((N, 2))
        travel = np.tile([1e-3 / dt, 0], (N, 1))  # of A, so small that it sticks
        friction = dict(self.options, friction_coefficient=mu, time_step=dt, velocity_b=np.zeros((N, 2)), history_a=a, history_b=b)
        first = grit.penalty_forces(self.a, self.b, velocity_a=np.zeros((N, 2)), **friction)
        np.testing.assert_allclose(a[:, 1], EPS * DEPTH)
        sticking = grit.penalty_forces(self.a, self.b, velocity_a=travel, **friction)
        self.assertTrue((sticking["reports_a"]["state"] == grit.PENALTY_STICK).all())
        np.testing.assert_allclose(np.abs(a[:, 0]), EPS * 1e-3)
        self.assertLess(sticking["totals"]["force_on_a"][0], 0)
        slipping = grit.penalty_forces(self.a, self.b, velocity_a=10 * travel, **friction)
        self.assertTrue((slipping["reports_a"]["state"] == grit.PENALTY_SLIP).all())
        np.testing.assert_allclose(np.abs(a[:, 0]), mu * EPS * DEPTH)
        np.testing.assert_allclose(slipping["totals"]["force_on_a"][0], -mu * first["totals"]["force_on_a"][1])
        self.assertGreater(slipping["totals"]["dissipation"], 0)

    def test_tells_the_stiffness_of_flush_contact(self):
        shares = np.array([0.5, 1, 1, 1, 0.5])
        for mu, larger in ((0.0, 1), (0.3, 2)):  # eps_t counts with friction
            stiffness = grit.penalty_flush_stiffness(self.a, normal_stiffness=EPS, tangential_stiffness=2 * EPS, friction_coefficient=mu)
            np.testing.assert_allclose(stiffness, larger * EPS * shares)

    def test_splits_lines(self):
        history = np.arange(2.0 * N).reshape(N, 2)
        for longest, m in ((0.5, 2 * N - 1), (0.1, 10 * (N - 1) + 1)):  # the second takes a second call
            new = grit.penalty_remesh(self.a, longest=longest, history=history)
            self.assertEqual(new["position"].shape, (m, 2))
            np.testing.assert_allclose(new["position"][:, 0], np.linspace(0, N - 1, m))
            np.testing.assert_allclose(new["history"][:, 1], np.linspace(1, 2 * N - 1, m))
            w = new["weight"][:, None]
            first, second = (self.a[new["parents"][:, i]] for i in (0, 1))
            np.testing.assert_allclose((1 - w) * first + w * second, new["position"], atol=1e-14)
        self.assertNotIn("history", grit.penalty_remesh(self.a, longest=9.0))
        np.testing.assert_array_equal(grit.penalty_remesh(self.a, longest=9.0)["position"], self.a)

    def test_refuses_what_it_cannot_take_and_changes_nothing(self):
        history = np.ones((N, 2))
        friction = dict(friction_coefficient=0.3, time_step=0.1, velocity_a=np.zeros((N, 2)), velocity_b=np.zeros((N, 2)),
                        history_a=history, history_b=np.ones((N, 2)))
        far = self.a.copy()
        far[3] = np.nan
        for message, kind, changes in (
                ("position_a must be (n, 2), got (2, 5)", grit.BadCall, {"position_a": self.a.T}),
                ("history_b must be (5, 2), got (5,)", grit.BadCall, {"history_b": np.ones(N)}),
                ("history_a and history_b share memory, and one of them is written to", grit.BadCall, {"history_b": history}),
                (None, grit.BadCall, {"depth_max": 0.0}),
                (None, grit.BadState, {"position_a": far})):
            with self.assertRaises(kind) as caught:
                grit.penalty_forces(**{"position_a": self.a, "position_b": self.b, **self.options, **friction, **changes})
            if message:
                self.assertEqual(str(caught.exception), message)
            self.assertTrue((history == 1).all())
        self.assertEqual(caught.exception.point, 3)
        for call in (lambda: grit.penalty_stiffness(1, -1, 1), lambda: grit.penalty_stable_step(np.ones(2), np.ones(3)),
                     lambda: grit.penalty_remesh(self.a, longest=0.0)):
            with self.assertRaises(grit.BadCall):
                call()


if __name__ == "__main__":
    unittest.main()
