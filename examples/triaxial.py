# SPDX-License-Identifier: BSD-3-Clause
"""A drained triaxial test of dense Lausitz sand (e 0.55, 100 kPa) to 20 % axial strain, as a host that
calls the update runs it: Newton's method finds the radial strain. triaxial.f90 prints the same."""
import numpy as np

import grit

increments, pressure, axial = 400, 100.0, -0.2 / 400  # kPa, compression is negative
sand = grit.Sand("lausitz")
stress = np.array([-pressure, -pressure, -pressure, 0, 0, 0])
state = sand.state(void_ratio=0.55, direction=[-1, -1, -1, 0, 0, 0])
strain, tangent, substep = np.zeros(6), np.zeros((6, 6)), np.zeros(1)
strain[0] = axial
for i in range(1, increments + 1):
    for _ in range(25):
        trial, trial_state, advice = stress.copy(), state.copy(), substep.copy()
        sand.update(strain, trial, trial_state, tangent=tangent, substep=advice,
                    tolerance=1e-5)
        off = -pressure - trial[1]
        if abs(off) <= 1e-10 * np.linalg.norm(trial):
            break
        strain[1:3] += off / (tangent[1, 1] + tangent[1, 2])
    else:
        raise SystemExit("the radial stress was not found")
    stress, state, substep = trial, trial_state, advice
    if i % (increments // 4) == 0:
        print(f"axial strain{i * axial:7.3f}  stress 11{stress[0]:11.5f} kPa"
              f"  void ratio{state[grit.VOID_RATIO]:9.6f}")
