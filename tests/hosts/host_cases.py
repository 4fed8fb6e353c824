# SPDX-License-Identifier: BSD-3-Clause
"""The cases of reference.cpp as a Python host runs them, over arrays of points: three alike, the middle
one is looked at; once with sand.update and once, with the argument element, with grit.element_test."""
import sys

import numpy as np

import grit

POINTS = 3
sand = grit.Sand("lausitz")
isotropic = np.array([-1.0, -1, -1, 0, 0, 0])


class Host:
    def __init__(self, pressure, void_ratio):
        self.stress = np.tile(pressure * isotropic, (POINTS, 1))
        self.state = np.tile(sand.state(void_ratio, isotropic), (POINTS, 1))
        self.substep = np.zeros(POINTS)

    def stage(self, radial, change, increments):
        strain, tangent = np.zeros((POINTS, 6)), np.zeros((POINTS, 6, 6))
        strain[:, 0] = change / increments
        if radial == "isochoric":
            strain[:, 1:3] = -change / increments / 2
        target = self.stress[1, 1]
        for _ in range(increments):
            for _ in range(25):
                trial, state = self.stress.copy(), self.state.copy()
                substep = self.substep.copy()
                sand.update(strain, trial, state, tangent=tangent, substep=substep)
                off = target - trial[:, 1]
                if radial != "free" or max(abs(off)) <= 1e-10 * np.linalg.norm(trial[1]):
                    break
                strain[:, 1:3] += (off / (tangent[:, 1, 1] + tangent[:, 1, 2]))[:, None]
            else:
                raise SystemExit("the radial stress was not found")
            self.stress, self.state, self.substep = trial, state, substep
        return self

    def end(self, pore_pressure=0.0):
        return self.stress[1, 0], self.stress[1, 1], self.state[1, grit.VOID_RATIO], pore_pressure


def element(pressure, void_ratio, stages):
    run = grit.element_test(sand, stages, pressure * isotropic, void_ratio, isotropic,
                            tolerance=2e-4)  # as sand.update by default
    return (run["stress"][-1, 0], run["stress"][-1, 1], run["void_ratio"][-1],
            run["pore_pressure"][-1])


turns = [-1e-3, 2e-3, -2e-3, 2e-3, -2e-3, 2e-3]
if sys.argv[1:] == ["element"]:
    stage = grit.stage
    ends = {
        "oedometer": element(10, 0.7, [stage.oedometer(x, 200) for x in (-0.02, 0.002, -0.01)]),
        "drained": element(100, 0.55, [stage.triaxial_drained(-0.2, 400)]),
        "undrained": element(100, 0.7, [stage.triaxial_undrained(-0.1, increments=400)]),
        "cyclic": element(100, 0.6, [stage.triaxial_drained(x, 200) for x in turns]),
    }
else:
    cyclic = Host(100, 0.6)
    for turn in turns:
        cyclic.stage("free", turn, 200)
    oedometer = Host(10, 0.7)
    for strain in (-0.02, 0.002, -0.01):
        oedometer.stage("fixed", strain, 200)
    undrained = Host(100, 0.7).stage("isochoric", -0.1, 400)
    ends = {
        "oedometer": oedometer.end(),
        "drained": Host(100, 0.55).stage("free", -0.2, 400).end(),
        "undrained": undrained.end(undrained.stress[1, 1] + 100),  # total radial stress -100 kPa
        "cyclic": cyclic.end(),
    }
for name, end in ends.items():
    print(f"{name:10}", *(f"{x:.16e}" for x in end))
