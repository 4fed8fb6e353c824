# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import grit
from samples import N, sand, state, strain, stress

# Differences tell steps that error control has cut otherwise: next to none of their error is left.
FINE = {"tolerance": 1e-11, "evaluation_limit": 100000}
NAMES = [name for name in sand.parameters if name != "pressure_shift"] + ["void_ratio"]


def path(law, e_0=0.62, slopes=None, **options):
    """Two increments: a shear, and a part of it back."""
    s, z = stress(), state()
    z[:, grit.VOID_RATIO] = e_0
    for factor in (1.0, -0.3):
        if slopes is None:
            law.update(factor * strain(), s, z, **FINE)
        else:
            law.update_differentiated(factor * strain(), s, z, *slopes, **FINE, **options)
    return s, z


def changed(name, value):
    return grit.Sand(**{**sand.parameters, name: value})


class Differentiated(unittest.TestCase):
    def test_has_the_bits_of_update_and_central_differences_of_a_path(self):
        slopes = sand.slopes(NAMES, N)
        s, z = path(sand, slopes=slopes, parameters=NAMES)
        for own, plain in zip((s, z), path(sand)):
            self.assertTrue(np.array_equal(own, plain))
        h = 1e-6
        for k, name in enumerate(NAMES):
            if name == "void_ratio":
                value = 0.62
                low, high = path(sand, value * (1 - h)), path(sand, value * (1 + h))
            else:
                value = sand.parameters[name]
                low, high = (path(changed(name, value * (1 + by))) for by in (-h, h))
            for slope, a, b, size in zip(slopes, low, high, (100.0, 1e-4)):
                np.testing.assert_allclose(slope[:, :, k] * value, (b - a) / (2 * h), rtol=1e-6,
                                           atol=1e-6 * size, err_msg=name)
        self.assertTrue((np.abs(slopes[0]).max(axis=(0, 1)) > 0).all())

    def test_by_strain_is_the_consistent_tangent(self):
        tangent, s, z = np.empty((N, 6, 6)), stress(), state()
        sand.update(strain(), s, z, tangent=tangent)
        slopes = sand.slopes([None] * 6, N)
        sand.update_differentiated(strain(), stress(), state(), *slopes, parameters=[None] * 6,
                                   strain_increment_slope=np.tile(np.eye(6), (N, 1, 1)))
        np.testing.assert_allclose(slopes[0], tangent, rtol=1e-9, atol=1e-9 * np.abs(tangent).max())

    def test_gives_each_point_the_same_bits_alone_and_in_any_layout(self):
        names = ["phi_c", "void_ratio", "R"]
        together = sand.slopes(names, N)
        path(sand, slopes=together, parameters=names)
        for i in range(N):
            alone = sand.slopes(names)
            s, z = stress()[i], state()[i]
            for factor in (1.0, -0.3):
                sand.update_differentiated(factor * strain()[i], s, z, *alone, parameters=names,
                                           **FINE)
            for own, all_points in zip(alone, together):
                self.assertTrue(np.array_equal(own, all_points[i]))
        strided = [np.zeros((3, N, 2 * x.shape[1]))[:, :, ::2].transpose(1, 2, 0) for x in together]
        strided[1][:, grit.VOID_RATIO, 1] = 1
        path(sand, slopes=strided, parameters=names)
        for own, dense in zip(strided, together):
            self.assertTrue(np.array_equal(own, dense))

    def test_takes_the_points_of_an_index_and_the_plane_components(self):
        slopes = sand.slopes(["alpha"], N)
        reports = sand.update_differentiated(strain(), stress(), state(), *slopes,
                                             parameters=["alpha"], index=np.array([3, 1]))
        taken = np.abs(slopes[0]).sum(axis=(1, 2)) > 0
        self.assertEqual((len(reports), taken.tolist()), (2, [False, True, False, True, False]))
        z = np.tile(sand.state(0.62, [-1, -1, -1, 0.3, 0, 0], 0.9), (N, 1))
        plane = sand.slopes(["alpha"], N, components=4)
        full = sand.slopes(["alpha"], N)
        d, s = strain(), stress()
        d[:, 4:] = s[:, 4:] = 0
        sand.update_differentiated(d[:, :4].copy(), s[:, :4].copy(), z.copy(), *plane,
                                   parameters=["alpha"])
        sand.update_differentiated(d, s, z, *full, parameters=["alpha"])
        self.assertTrue(np.array_equal(plane[0], full[0][:, :4]))

    def test_refuses_and_changes_nothing(self):
        def refused(error, words, slopes, **options):
            s, z = stress(), state()
            with self.assertRaisesRegex(error, words):
                sand.update_differentiated(strain(), s, z, *slopes,
                                           **{"parameters": ["n", "beta"], **options})
            self.assertTrue(np.array_equal(s, stress()) and np.array_equal(z, state()))

        good = sand.slopes(["n", "beta"], N)
        refused(grit.BadCall, "parameters: cohesion is none of this sand", good,
                parameters=["n", "cohesion"])
        refused(grit.BadCall, r"stress_slope must be \(5, 6, 1\), got \(5, 6, 2\)", good,
                parameters=["n"])
        refused(grit.BadCall, r"state_slope must be \(5, 8, 2\), got \(5, 6, 2\)",
                (good[0], good[0].copy()))
        refused(grit.BadCall, "stress_slope must be a NumPy array", (None, good[1]))
        refused(grit.BadCall, "state_slope must be a NumPy array", (good[0], None))
        refused(grit.BadCall, r"count of the derivatives must be in \[1, 32\], got 0",
                sand.slopes([], N), parameters=[])
        refused(grit.BadCall, r"count of the derivatives must be in \[1, 32\], got 33",
                sand.slopes([None] * 33, N), parameters=[None] * 33)
        refused(grit.BadCall, r"strain_increment_slope must be \(5, 6, 2\), got \(6, 2\)", good,
                strain_increment_slope=np.zeros((6, 2)))
        refused(grit.BadCall, "which an update without intergranular strain does not use",
                sand.slopes(["R"], N), parameters=["R"], intergranular_strain=False)
        both = np.zeros((N, 8, 2))
        refused(grit.BadCall, "share memory", (both[:, :6], both))
        bad = [x.copy() for x in good]
        bad[0][2, 1, 0] = np.inf
        refused(grit.BadCall, "point 2: derivatives of stress, state and strain increment must be",
                bad)
        self.assertTrue(all((x == y).all() for x, y in zip(good, sand.slopes(["n", "beta"], N))))
        with self.assertRaisesRegex(grit.BadCall, "components must be 6 or 4, got 5"):
            sand.slopes(["n"], N, components=5)


if __name__ == "__main__":
    unittest.main()
