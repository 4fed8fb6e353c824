#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The surface of a quarter of an upright cylinder, closed, as an STL file: quarter_cylinder.py RADIUS FROM_Z TO_Z FILE [PARTS]

PARTS edges from the axis to the wall (default 6). Corners lie a little outside of the radius: the polygon has the area of the
circle. The mirror image about the diagonal is the same surface."""
import math
import struct
import sys

ROW = 0.25  # height of the wall's triangles [m]


def disc(radius, n):
    """Corners of n by n cells of the quarter of a disc: rings of a square, bent."""
    around = 2 * n
    outer = radius / math.sqrt(math.sin(0.5 * math.pi / around) * around / (0.5 * math.pi))
    out = {}
    for i in range(n + 1):
        for j in range(n + 1):
            ring = max(i, j)
            angle = 0.0 if ring == 0 else 0.25 * math.pi * (j / i if i >= j else 2.0 - i / j)
            r = outer * ring / n
            out[i, j] = (r * (0.0 if i == 0 else math.cos(angle)), r * (0.0 if j == 0 else math.sin(angle)))
    return out


def triangles(radius, low, high, n):
    at = disc(radius, n)
    rows = max(1, round((high - low) / ROW))
    z = [low + (high - low) * k / rows for k in range(rows + 1)]
    out = []

    def quad(a, b, c, d, along_ac):
        out.extend([(a, b, c), (a, c, d)] if along_ac else [(a, b, d), (b, c, d)])

    for i in range(n):
        for j in range(n):
            corners = [at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]]
            for level, upward in ((low, False), (high, True)):
                a, b, c, d = [(*x, level) for x in corners]
                # Along the diagonal of the whole, and as mirror images beside it.
                quad(*((a, b, c, d) if upward else (a, d, c, b)), True)
    rim = [(n, j) for j in range(n + 1)] + [(i, n) for i in range(n - 1, -1, -1)]
    sides = [(rim, None), ([(i, 0) for i in range(n + 1)], True), ([(0, j) for j in range(n, -1, -1)], False)]
    for line, along in sides:
        for k, (p, q) in enumerate(zip(line, line[1:])):
            for bottom, top in zip(z, z[1:]):
                a, b = (*at[p], bottom), (*at[q], bottom)
                c, d = (*at[q], top), (*at[p], top)
                quad(a, b, c, d, k < n if along is None else along)
    return out


def main():
    radius, low, high = (float(x) for x in sys.argv[1:4])
    n = int(sys.argv[5]) if len(sys.argv) > 5 else 6
    all_of_it = triangles(radius, low, high, n)
    with open(sys.argv[4], "wb") as file:
        file.write(b"quarter of a cylinder".ljust(80) + struct.pack("<I", len(all_of_it)))
        for corners in all_of_it:
            file.write(struct.pack("<12fH", 0.0, 0.0, 0.0, *(c for x in corners for c in x), 0))


if __name__ == "__main__":
    main()
