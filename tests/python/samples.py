# SPDX-License-Identifier: BSD-3-Clause
"""What the tests start from: five points of Lausitz sand [kPa] and their increments."""
import numpy as np

import grit

N = 5
sand = grit.Sand("lausitz")


def strain():
    return np.arange(1, N + 1)[:, None] * np.array([-1e-4, 3e-5, 2e-5, 1e-4, -5e-5, 7e-5])


def stress():
    return np.tile(np.array([-100.0, -60, -70, 10, -5, 3]), (N, 1))


def state():
    return np.tile(sand.state(0.62, [-1, -1, -1, 0.3, 0, 0], 0.9), (N, 1))


def updated(**options):
    s, z = stress(), state()
    sand.update(strain(), s, z, **options)
    return s, z
