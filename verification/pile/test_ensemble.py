#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What ensembles are made of and what is concluded from them, on numbers that can be seen through."""
import pathlib
import tempfile
import tomllib
import unittest

import ensemble
from ensemble_tables import Group, difference
from measures import GRAVITY, after_hammer, write_rows
from results import Frame, Unusable, rings


class Histories(dict):
    """Of a pile of 1000 kg: blows as they are given."""
    mass = 1000.0

    def blows(self):
        return [(0, len(self["t"]) - 1)]


def stopped_by(reaction, speed):
    """A hammer of 10 kN for 0.1 s, at whose end the pile has a speed; a constant reaction [kN] then stops it."""
    dt, rows = 1e-3, {key: [] for key in ("t", "depth", "velocity", "hammer_force", "tip_force", "shaft_force")}
    depth = 0.0
    for i in range(400):
        t = i * dt
        after = max(0.0, t - 0.1)
        v = speed * min(1.0, t / 0.1) if t <= 0.1 else max(0.0, speed - (1e3 * reaction / 1e3 - GRAVITY) * after)
        depth += v * dt
        for key, value in zip(rows, (t, depth, v, 10.0 if t <= 0.1 + 1e-9 else 0.0, reaction, 0.0)):
            rows[key].append(value)
    return Histories(rows)


class Ensembles(unittest.TestCase):
    def test_members_differ_in_neutral_choices_only(self):
        for group in ("base", "coarse", "rapid"):
            for name, _, overrides in ensemble.cases(group):
                found = list(ensemble.members(overrides))
                self.assertEqual(len(found), ensemble.MEMBERS, name)
                self.assertEqual({key for member in found for key in member},
                                 {"body.pile.density_kg_per_m3", "numerics.cfl", "grid.z.1.to_m", "grid.z.2.to_m",
                                  "body.sand.box.1.z_m", "body.sand.box.3.z_m"}, name)

    def test_phase_moves_lines_by_a_share_of_the_cell_and_boxes_with_them(self):
        for cells in (90, 180):
            moved = ensemble.phase({"grid.z.2.cells": cells}, 0.25)
            cell = (moved["grid.z.2.to_m"] - moved["grid.z.1.to_m"]) / cells
            self.assertAlmostEqual(cell, 8.1 / cells)
            self.assertAlmostEqual(moved["grid.z.1.to_m"], -3.51 + 0.25 * cell)
            self.assertEqual(moved["body.sand.box.1.z_m"], [moved["grid.z.1.to_m"], -0.5])
            self.assertEqual(moved["body.sand.box.3.z_m"], [-10.0, moved["grid.z.1.to_m"]])

    def test_case_files_are_toml_and_name_a_base_that_is_there(self):
        for group, count in (("base", 40), ("coarse", 40), ("rapid", 110)):
            files = ensemble.files(group)
            self.assertEqual(len(files), count)
            for name, text in files.items():
                self.assertTrue((ensemble.HERE / tomllib.loads(text)["base"]).is_file(), name)

    def test_cells_of_a_ratio_fill_the_way(self):
        for ratio in (1.5, 2, 3):
            found = ensemble.cells_in_radius(ratio)
            self.assertAlmostEqual(found["grid.r.1.to_m"] / found["grid.r.1.cells"], 0.15 / ratio)


def squares(edge, particles, **values):
    """A frame of squares with these centres."""
    frame = Frame.__new__(Frame)
    half = 0.5 * edge
    frame.corners = [tuple((r + half * s, z + half * t) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))) for r, z in particles]
    frame.values, frame.count = values, len(particles)
    return frame


class Rings(unittest.TestCase):
    def test_each_ring_has_the_sand_of_its_height_by_volume(self):
        # Beside a shaft of radius 1: rings from 1 to 1.5, 2 and 3.
        sand = squares(0.1, [(1.1, -1.0), (1.4, -1.0), (1.6, -1.0), (2.9, -1.0), (1.2, -3.0), (3.1, -1.0), (0.9, -1.0)],
                       stress_rr=[-10.0, 0.0, -30.0, -40.0, -99.0, -99.0, -99.0],
                       void_ratio=[0.5, 0.6, 0.7, 0.8, 9.0, 9.0, 9.0])
        near, middle, far = rings(sand, 1.0, -2.0, 0.0)
        for found, wanted in zip(near, (10.0 * 1.1 / 2.5, (0.5 * 1.1 + 0.6 * 1.4) / 2.5, 1.4 / 2.5)):
            self.assertAlmostEqual(found, wanted)
        self.assertAlmostEqual(middle[0], 30.0)
        self.assertAlmostEqual(far[0], 40.0)
        self.assertEqual((middle[2], far[2]), (0.0, 0.0))


class Rows(unittest.TestCase):
    def test_rows_of_members_that_are_not_measured_now_stay(self):
        with tempfile.TemporaryDirectory() as folder:
            target = pathlib.Path(folder) / "coarse.csv"
            write_rows(target, [{"case": case, "member": k, "x": 1.0} for case in ("loose", "dense") for k in (10, 2)])
            write_rows(target, [{"case": "loose", "member": 2, "x": 2.5}])
            self.assertEqual(target.read_text(), "case,member,x\ndense,2,1\ndense,10,1\nloose,2,2.5\nloose,10,1\n")
            with self.assertRaises(Unusable):
                write_rows(target, [{"case": "loose", "member": 2, "y": 2.5}])


class Conclusions(unittest.TestCase):
    def test_what_runs_scatter_by_is_no_difference(self):
        self.assertTrue(difference([1.0, 2.0, 3.0], [1.5, 2.5, 3.5], 1).endswith(", no"))
        self.assertEqual(difference([1.0, 2.0, 3.0], [11.0, 12.0, 13.0], 1), "-10.0 ± 0.8")
        # Student's t of 8 degrees of freedom is 2.31.
        one = [0.0, 1.0, 2.0, 3.0, 4.0]
        self.assertFalse(difference([x + 2.32 for x in one], one, 2).endswith(", no"))
        self.assertTrue(difference([x + 2.30 for x in one], one, 2).endswith(", no"))

    def test_of_single_runs_nothing_is_concluded(self):
        self.assertEqual(difference([1.0], [2.0, 3.0], 1), "")

    def test_sets_are_taken_at_equal_depth(self):
        group = Group.__new__(Group)
        group.blows = {"a": {1: [{"from_m": 0.1, "set_m": 0.06}, {"from_m": 0.16, "set_m": 0.03}, {"from_m": 0.19, "set_m": 0.02}],
                             2: [{"from_m": 0.3, "set_m": 0.06}]}}
        self.assertEqual(len(group.set_at("a", 0.13)), 1)  # the second one does not pass it
        self.assertAlmostEqual(group.set_at("a", 0.115)[0], 0.0525)
        self.assertAlmostEqual(group.set_at("a", 0.175)[0], 0.025)

    def test_what_is_left_of_the_hammers_impulse_goes_into_the_ground(self):
        (after, back, again, kinetic, resisted, share, least), = after_hammer(stopped_by(20.0, 0.5))
        self.assertAlmostEqual(kinetic, 125.0, delta=1.5)
        self.assertAlmostEqual(resisted, kinetic, delta=3.0)
        self.assertAlmostEqual(after, 0.5**2 / 2 / (20.0 - GRAVITY), delta=4e-4)
        self.assertEqual((back, again, least), (0.0, 0.0, 20.0))
        self.assertAlmostEqual(share, 1000 * 0.5 / 1e3, delta=0.02)


if __name__ == "__main__":
    unittest.main()
