# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import grit


class Normals(unittest.TestCase):
    def test_come_from_the_gradient_that_is_asked_for(self):
        a, b = np.array([[3.0, 0], [0, 2]]), np.array([[0.0, -4], [5, 0]])
        np.testing.assert_allclose(grit.contact_normals("a", gradient_a=a), [[1, 0], [0, 1]])
        np.testing.assert_allclose(grit.contact_normals("b", gradient_b=b), [[0, 1], [-1, 0]])
        np.testing.assert_allclose(grit.contact_normals("average", gradient_a=a, gradient_b=b)[0], [0.6, 0.8])
        given = np.array([[0.0, 0, -7], [1, 2, 2]])
        np.testing.assert_allclose(grit.contact_normals("given", given=given), [[0, 0, -1], [1 / 3, 2 / 3, 2 / 3]])

    def test_read_sections_of_arrays(self):
        nodes = np.zeros((3, 5))
        nodes[:, 1:4:2] = [[3, 4], [0, 1], [-1, 0]]
        np.testing.assert_allclose(grit.contact_normals("a", gradient_a=nodes[::-1, 1:4:2]), [[-1, 0], [0, 1], [0.6, 0.8]])

    def test_are_zero_where_roundoff_would_decide_and_leave_fixed_components_out(self):
        g = np.array([[3.0, 4], [3, 4]])
        normal = grit.contact_normals("a", gradient_a=g, scale=np.array([1e12, 5]), fixed=np.array([0, 1]))
        np.testing.assert_array_equal(normal, [[0, 0], [0, 1]])
        np.testing.assert_array_equal(grit.contact_normals("a", gradient_a=g, scale=np.full(2, 50.0), threshold=0.5), np.zeros((2, 2)))

    def test_by_regression_that_one_node_misses_are_there_for_the_others(self):
        x = np.array([[-0.1, 0], [0.1, 0.03], [0.2, -0.4], [-0.3, 0.2], [0.0, 0.3], [-0.2, -0.2]])
        body = np.array([0, 1, 1, 0, 1, 0])
        offset, particle = np.array([0, 2, 8]), np.array([0, 1, 0, 1, 2, 3, 4, 5])  # the first node has one of each
        with self.assertRaises(grit.NotConverged) as caught:
            grit.contact_normals_by_regression(x, body, offset, particle, length=1.0, iteration_limit=5)
        self.assertEqual(caught.exception.point, 1)
        apart = x[1] - x[0]
        np.testing.assert_allclose(caught.exception.normal, [apart / np.linalg.norm(apart), [0, 0]], atol=1e-10)

    def test_by_regression_stand_on_the_line_between_two_clouds(self):
        along, across = np.array([0.6, 0.8]), np.array([-0.8, 0.6])
        x = np.array([d * across + t * along for d in (-0.3, -0.1, 0.1, 0.3) for t in (-0.4, 0.4)])
        body = np.repeat([0, 1], 4)
        offset = np.array([0, 8, 12])  # the second node has A alone
        particle = np.concatenate([np.arange(8), np.arange(4)])
        normal = grit.contact_normals_by_regression(x, body, offset, particle, length=1.0)
        np.testing.assert_allclose(normal, [across, [0, 0]], atol=1e-10)
        far = np.vstack([x, [[0.0, -90]]])  # of weight 0
        weight = np.append(np.ones(8), 0)
        weighted = grit.contact_normals_by_regression(far, np.append(body, 0), np.array([0, 9]), length=1.0, weight=weight)
        np.testing.assert_allclose(weighted, [across], atol=1e-10)
        with self.assertRaises(grit.NotConverged):
            grit.contact_normals_by_regression(x, body, np.array([0, 8]), length=1.0, ridge=1e-6, iteration_limit=1)

    def test_are_refused(self):
        g = np.ones((2, 2))
        for message, kind, call in (
                ('source must be "a", "b", "average" or "given", got "c"', grit.BadCall, lambda: grit.contact_normals("c", gradient_a=g)),
                ("gradient_b must be a NumPy array of float64, got NoneType", grit.BadCall, lambda: grit.contact_normals("b", gradient_a=g)),
                ("given must be (n, 2) or (n, 3), got (2,)", grit.BadCall, lambda: grit.contact_normals("given", given=g[0])),
                ("gradient_b must be (2, 2), got (1, 2)", grit.BadCall,
                 lambda: grit.contact_normals("average", gradient_a=g, gradient_b=g[:1])),
                ("fixed must be an array of integers, got float64", grit.BadCall,
                 lambda: grit.contact_normals("a", gradient_a=g, fixed=np.zeros(2))),
                ("offset must rise from 0 or more to 2 or less, the entries of the list", grit.BadCall,
                 lambda: grit.contact_normals_by_regression(g, np.array([0, 1]), np.array([0, 3]), length=1.0))):
            with self.assertRaises(kind) as caught:
                call()
            self.assertEqual(str(caught.exception), message)
        with self.assertRaises(grit.BadState) as caught:
            grit.contact_normals("a", gradient_a=np.array([[1.0, 0], [np.nan, 0]]))
        self.assertEqual(caught.exception.point, 1)


class Surfaces(unittest.TestCase):
    """A below, B above three nodes on a line; normals point up."""

    def setUp(self):
        self.nodes = np.array([[0.0, 0], [1, 0], [2, 0]])
        self.normal = np.tile([0.0, 1], (3, 1))
        self.sides = np.array([[[0.5, 0], [0.1, 0.2]]])
        self.surfaces = grit.ContactSurfaces(self.nodes, self.normal, centres=True)

    def add_both(self, surfaces):
        surfaces.add("a", np.array([[0.5, -0.5]]), np.array([[0, 1]]), side=self.sides)
        surfaces.add("b", np.array([[0.5, 0.4], [1.5, 0.3]]), np.array([0, 1, 1, 2]), offset=np.array([0, 2, 4]))

    def test_know_nothing_at_first(self):
        self.assertTrue(np.isinf(self.surfaces.distance("a")).all())
        self.assertTrue(np.isinf(self.surfaces.gap()).all())

    def test_see_the_farthest_corner_of_each_domain(self):
        self.add_both(self.surfaces)
        np.testing.assert_allclose(self.surfaces.distance("a"), [0.3, 0.3, np.inf])
        np.testing.assert_allclose(self.surfaces.distance("b"), [0.4, 0.3, 0.3])
        np.testing.assert_allclose(self.surfaces.gap(), [0.7, 0.6, np.inf])
        np.testing.assert_allclose(self.surfaces.surface, [[0.3, 0.4], [0.3, 0.3], [np.inf, 0.3]])
        np.testing.assert_allclose(self.surfaces.distance("a", "nearest centre"), [np.sqrt(0.5), np.sqrt(0.5), np.inf])
        np.testing.assert_allclose(self.surfaces.centre[:, 1], [np.hypot(0.5, 0.4), np.hypot(0.5, 0.3), np.hypot(0.5, 0.3)])

    def test_are_negative_inside_but_for_the_edge(self):
        self.surfaces.add("a", np.array([[0.0, 0.1]]), np.array([[0, -1]]))
        np.testing.assert_allclose(self.surfaces.distance("a"), [-0.1, np.inf, np.inf])
        np.testing.assert_allclose(self.surfaces.distance("a", measure="edge"), [0.1, np.inf, np.inf])

    def test_of_other_nodes_are_not_merged(self):
        one = grit.ContactSurfaces(self.nodes, self.normal)
        for other, what in ((grit.ContactSurfaces(self.nodes + 1, self.normal), "position"),
                            (grit.ContactSurfaces(self.nodes, -self.normal), "normal"),
                            (grit.ContactSurfaces(np.zeros((len(self.nodes), 3)), np.zeros((len(self.nodes), 3))), "position")):
            with self.assertRaisesRegex(grit.BadCall, f"surfaces of nodes with another {what}"):
                one.merge(other)

    def test_have_minima_whose_size_nobody_changes(self):
        for numbers in self.surfaces.surface, self.surfaces.centre:
            with self.assertRaises(ValueError):
                numbers.resize((1, 2))

    def test_of_threads_are_merged(self):
        self.add_both(self.surfaces)
        one, other = (grit.ContactSurfaces(self.nodes, self.normal, centres=True) for _ in range(2))
        one.add("a", np.array([[0.5, -0.5]]), np.array([[0, 1]]), side=self.sides)
        other.add("b", np.array([[0.5, 0.4], [1.5, 0.3]]), np.array([0, 1, 1, 2]), offset=np.array([0, 2, 4]))
        one.merge(other)
        np.testing.assert_array_equal(one.surface, self.surfaces.surface)
        np.testing.assert_array_equal(one.centre, self.surfaces.centre)

    def test_in_space(self):
        surfaces = grit.ContactSurfaces(np.zeros((1, 3)), np.array([[0.0, 0, 1]]))
        surfaces.add("a", np.array([[0.1, 0.2, -0.5]]), np.array([[0]]), side=0.25 * np.eye(3)[None])
        np.testing.assert_allclose(surfaces.distance("a"), [0.25])
        self.assertIsNone(surfaces.centre)
        with self.assertRaises(grit.BadCall):
            surfaces.distance("a", "nearest centre")

    def test_refuse_what_they_cannot_take_and_change_nothing(self):
        self.add_both(self.surfaces)
        before, centre = self.surfaces.surface.copy(), self.surfaces.centre.copy()
        x = np.array([[0.5, -0.01], [np.nan, 0]])
        for message, kind, call in (
                ('body must be "a" or "b", got "c"', grit.BadCall, lambda: self.surfaces.add("c", x, np.zeros((2, 1), int))),
                ("node must be (2, k), or have an offset, got (2,)", grit.BadCall, lambda: self.surfaces.add("a", x, np.zeros(2, int))),
                ("offset must be (3,), got (2,)", grit.BadCall,
                 lambda: self.surfaces.add("a", x, np.zeros(2, int), offset=np.array([0, 2]))),
                ("side must be (2, k, 2), k = 1 ... 3", grit.BadCall,
                 lambda: self.surfaces.add("a", x, np.zeros((2, 1), int), side=np.zeros((2, 2)))),
                (None, grit.BadCall, lambda: self.surfaces.add("a", x[:1], np.array([[0, 3]]))),
                (None, grit.BadState, lambda: self.surfaces.add("a", x, np.zeros((2, 1), int)))):
            with self.assertRaises(kind) as caught:
                call()
            if message:
                self.assertEqual(str(caught.exception), message)
            np.testing.assert_array_equal(self.surfaces.surface, before)
            np.testing.assert_array_equal(self.surfaces.centre, centre)


if __name__ == "__main__":
    unittest.main()
