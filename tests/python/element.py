# SPDX-License-Identifier: BSD-3-Clause
import inspect
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest

import numpy as np

import grit

sand = grit.Sand("lausitz")
isotropic = [-1.0, -1, -1, 0, 0, 0]
stage = grit.stage


def run(*stages, pressure=100.0, void_ratio=0.6, **options):
    return grit.element_test(sand, list(stages), pressure * np.array(isotropic), void_ratio,
                             direction=isotropic, **options)


class ElementTest(unittest.TestCase):
    def test_takes_the_sample_of_a_case_file(self):
        """Not a digit of the file differs, however little is said, for any sand and state."""
        random = np.random.default_rng(21)
        for trial in range(12):
            names = list(grit.sands())
            name = names[trial % len(names)]
            p = float(np.round(10 ** random.uniform(1, 3), 3))
            e_i, e_c, e_d = grit.Sand(name).void_ratios(p)
            e = float(np.round(e_d + random.uniform(0.2, 0.8) * (e_i - e_d), 4))
            with tempfile.TemporaryDirectory() as folder:
                case = pathlib.Path(folder) / "x.toml"
                case.write_text(
                    f'[sand]\nname = "{name}"\n[start]\npressure_kPa = {p!r}\nvoid_ratio = {e!r}\n'
                    '[[stage]]\ntest = "triaxial_drained"\naxial_strain = -0.01\nincrements = 40\n'
                    'first_share = 1e-3\n'
                    '[[stage]]\ntest = "triaxial_undrained"\naxial_strain = 0.004\nincrements = 20\n'
                    'first_share = 1e-3\n')
                subprocess.run([os.environ["GRIT_CLI"], "element", "--quiet", "--no-plot", "--out", folder,
                                str(case)], check=True)
                lines = [line for line in case.with_suffix(".csv").read_text().splitlines()
                         if not line.startswith("#")]
            head = [word.split(" ")[0] for word in lines[0].split(",")]
            rows = [dict(zip(head, line.split(","))) for line in lines[1:]]
            test = grit.element_test(
                grit.Sand(name),
                [stage.triaxial_drained(-0.01, 40, 1e-3), stage.triaxial_undrained(0.004, 20, 1e-3)],
                p * np.array(isotropic), e)
            self.assertEqual(len(rows), len(test["stage"]))
            for i, row in enumerate(rows):
                for key, value in [("stress_11", test["stress"][i, 0]), ("stress_22", test["stress"][i, 1]),
                                   ("h_11", test["state"][i, 0]), ("void_ratio", test["void_ratio"][i]),
                                   ("pore_pressure", test["pore_pressure"][i])]:
                    self.assertEqual(row[key], f"{value:.12g}" if row[key] != "nan" else "nan", (name, i, key))

    def test_refuses_a_sample_that_there_cannot_be(self):
        e_i, e_c, e_d = sand.void_ratios(100.0)
        for wrong in (e_d - 1e-3, e_i + 1e-3, 2.0):
            with self.assertRaises(grit.BadCall) as caught:
                run(stage.triaxial_drained(-0.2), void_ratio=wrong)
            self.assertIn("the void ratio must be in [e_d, e_i] = [", str(caught.exception))
        with self.assertRaises(grit.BadCall):
            run(stage.triaxial_drained(-0.2), pressure=-100.0)

    def test_ends_at_the_reference_of_dense_lausitz_sand(self):
        """Reference: verification/cases/lausitz_dense.toml, integrated with DOP853."""
        dense = run(stage.triaxial_drained(-0.2, 400), void_ratio=0.55, tolerance=1e-6)
        self.assertAlmostEqual(dense["stress"][-1, 0] / -398.912, 1, delta=5e-5)
        self.assertAlmostEqual(dense["void_ratio"][-1], 0.612734, delta=5e-6)
        self.assertEqual(dense["strain"].shape, (401, 6))
        self.assertEqual(dense["state"].shape, (401, 8))
        np.testing.assert_allclose(dense["strain"][-1, 0], -0.2)

    def test_holds_what_each_stage_holds(self):
        drained = run(stage.triaxial_drained(-0.02))
        np.testing.assert_allclose(drained["stress"][:, 1:3], -100, rtol=1e-8)
        undrained = run(stage.triaxial_undrained(-0.02))
        np.testing.assert_allclose(undrained["total_stress"][:, 1:3], -100, rtol=1e-8)
        np.testing.assert_allclose(undrained["strain"][:, :3].sum(axis=1), 0, atol=1e-15)
        np.testing.assert_allclose(undrained["stress"][:, 1] - undrained["pore_pressure"], -100,
                                   rtol=1e-8)
        confined = run(stage.oedometer_stress(-100.0))
        np.testing.assert_allclose(confined["stress"][-1, 0], -200)
        self.assertFalse(confined["strain"][:, 1:].any())
        p = run(stage.triaxial_constant_p(-0.02))["stress"][:, :3].mean(axis=1)
        np.testing.assert_allclose(p, -100, rtol=1e-8)

    def test_runs_stages_on_one_sample(self):
        turned = run(stage.isotropic_stress(-100.0, 10), stage.triaxial_drained(-0.01, 50, 1e-4),
                     stage.triaxial_drained(0.01, increments=50))
        self.assertEqual(turned["stage"].tolist(), [0] + [1] * 10 + [2] * 50 + [3] * 50)
        np.testing.assert_allclose(turned["stress"][11:, 1], -200, rtol=1e-8)
        self.assertLess(abs(np.diff(turned["strain"][:, 0])[10]), 1.1e-6)

    def test_takes_one_stage_without_a_list(self):
        one = stage.oedometer(-0.01)
        np.testing.assert_array_equal(grit.element_test(sand, one, isotropic, 0.6)["stress"],
                                      grit.element_test(sand, [one], isotropic, 0.6)["stress"])

    def test_says_what_shape_it_wants(self):
        for arguments, message in (
                (([stage.oedometer(-0.01)], [-100.0] * 3, 0.6), "stress must be (6,), got (3,)"),
                (([stage.oedometer(-0.01)], isotropic, 0.6, [[1.0] * 6]), "direction must be (6,), got (1, 6)"),
                (([stage.oedometer(-0.01)], [1j] * 6, 0.6), "stress must be real numbers, got complex128"),
                (([stage.oedometer(-0.01)], ["1"] * 6, 0.6), "stress must be real numbers, got <U1"),
                (([stage.oedometer(-0.01)], np.ma.masked_array(isotropic, [1] * 6), 0.6),
                 "stress must have no mask, got a MaskedArray: an index tells which points are taken"),
                (([1], isotropic, 0.6), "stages must be a list of what the functions of grit.stage return, got [1]")):
            with self.assertRaises(grit.BadCall) as caught:
                grit.element_test(sand, *arguments)
            self.assertEqual(str(caught.exception), message)

    def test_says_what_it_does_not_run(self):
        with self.assertRaises(grit.BadCall) as caught:
            run(stage.triaxial_drained(-0.2), void_ratio=-1)
        self.assertEqual(str(caught.exception), "void ratio must be > 0, got -1")
        with self.assertRaises(grit.BadCall):
            run(stage.triaxial_drained(-0.2, increments=0))
        with self.assertRaises(grit.BadCall):
            run(stage.triaxial_drained(np.nan))
        with self.assertRaises(grit.BadCall):
            run(stage.triaxial_drained(-0.1), void_ratio_slope=[1.0])
        with self.assertRaises(grit.BadCall):
            sand.state(0.6, rho=0.5)

    def test_lets_no_pore_pressure_stay_in_a_drained_stage(self):
        sheared, more = stage.triaxial_undrained(-0.01), stage.triaxial_drained(-0.01)
        for stages, number in (([sheared, more], 2), ([sheared, stage.oedometer(-0.01)], 2), ([more, sheared, sheared, more], 4)):
            with self.assertRaises(grit.BadCall) as caught:
                run(*stages)
            self.assertEqual(str(caught.exception), f"stage {number} begins with the pore pressure of an undrained stage: "
                                                    "let it out by stage.drain() before")
        test = run(sheared, stage.drain(20), more)
        drained = test["stage"] == 2
        self.assertGreater(test["pore_pressure"][~drained][100], 1)
        self.assertLess(abs(test["pore_pressure"][drained][-1]), 1e-9)
        np.testing.assert_allclose(test["total_stress"][drained, 1], -100, rtol=1e-8)
        np.testing.assert_allclose(test["stress"][test["stage"] == 3, 1], -100, rtol=1e-8)

    def test_ends_with_what_it_has_when_it_is_interrupted(self):
        def interrupt(*_):
            raise KeyboardInterrupt
        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.3)
            with self.assertRaises(KeyboardInterrupt) as caught:
                run(stage.triaxial_drained(-0.2, increments=1_000_000))
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        rows = len(caught.exception.history["stress"])
        self.assertTrue(2 < rows < 1_000_000)

    def test_hands_over_what_was_reached_when_it_cannot_go_on(self):
        with self.assertRaises(grit.NotConverged) as caught:
            run(stage.isotropic_stress(50.0), stage.triaxial_drained_stress(-1e4))
        self.assertIn("step 2", str(caught.exception))
        history = caught.exception.history
        self.assertEqual(history["stage"][-1], 2)
        self.assertLess(history["stress"][-1, 0], -100)

    def test_documents_everything(self):
        for name in grit.__all__:
            thing = getattr(grit, name)
            if callable(thing):
                self.assertTrue(inspect.getdoc(thing), name)
        for name, method in inspect.getmembers(grit.Sand):
            if not name.startswith("_"):
                self.assertTrue(inspect.getdoc(method), name)
        for text in ("(n, 6)", "[stress]", "tension +", "Raises"):
            self.assertIn(text, grit.Sand.update.__doc__)


class Derivatives(unittest.TestCase):
    def test_are_central_differences_of_the_test(self):
        sand = grit.Sand("lausitz")
        stages = [grit.stage.triaxial_drained(-0.05, increments=20, first_share=1e-3)]
        common = dict(stress=[-100.0, -100, -100, 0, 0, 0], tolerance=1e-10)
        test = grit.element_test(sand, stages, void_ratio=0.65, parameters=["h_s", "void_ratio"], **common)
        up, down = (grit.element_test(sand, stages, void_ratio=e, **common) for e in (0.6501, 0.6499))
        ours = test["stress_slope"][:, :, 1]
        self.assertEqual(test["state_slope"].shape, (21, 8, 2))
        self.assertLess(abs((up["stress"] - down["stress"]) / 2e-4 - ours).max(), 1e-6 * abs(ours).max())

    def test_of_an_unknown_parameter_are_refused(self):
        with self.assertRaisesRegex(grit.BadCall, "parameters: nix is none of this sand"):
            grit.element_test(grit.Sand("lausitz"), [grit.stage.oedometer(-0.01)],
                              stress=[-100.0, -100, -100, 0, 0, 0], void_ratio=0.65, parameters=["nix"])


if __name__ == "__main__":
    unittest.main()
