#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes footing_mesh.inp: the half of a strip footing 1 m wide on a bed of sand, x to the right, y up, with
the stress at rest at every integration point. Rows and columns grow away from the edge of the strip."""
from math import sqrt

HALF_STRIP, WIDTH, DEPTH = 0.5, 4.0, 3.0  # m
COLUMNS, UNDER_STRIP, ROWS = 28, 4, 18
UNIT_WEIGHT, SURCHARGE, K0 = 16.0, 20.0, 0.455  # kN/m3, kPa


def growing(first, count, length):
    """count cells from 0 to length, the first so long, each longer than the one before by one ratio."""
    low, high = 1.0, 2.0
    for _ in range(60):
        ratio = (low + high) / 2
        if first * sum(ratio**i for i in range(count)) < length:
            low = ratio
        else:
            high = ratio
    return [first * sum(low**i for i in range(n)) for n in range(count)] + [length]


CELL = HALF_STRIP / UNDER_STRIP
X = [CELL * i for i in range(UNDER_STRIP)]
X += [HALF_STRIP + x for x in growing(CELL, COLUMNS - UNDER_STRIP, WIDTH - HALF_STRIP)]
Y = [-y for y in growing(CELL, ROWS, DEPTH)]


def node(column, row):
    return 1 + column + (COLUMNS + 1) * row


def element(column, row):
    return 1 + column + COLUMNS * row


def print_set(kind, name, members):
    print(f"*{kind}, {kind}={name}", *(f"{m}," for m in members), sep="\n")


print("*NODE, NSET=ALL")
for row, y in enumerate(Y):
    for column, x in enumerate(X):
        print(f"{node(column, row)}, {x:.9g}, {y:.9g}")
print("*ELEMENT, TYPE=CPE4, ELSET=SAND")
for row in range(ROWS):
    for column in range(COLUMNS):
        below, above = node(column, row + 1), node(column, row)
        print(f"{element(column, row)}, {below}, {below + 1}, {above + 1}, {above}")

print_set("NSET", "BASE", [node(c, ROWS) for c in range(COLUMNS + 1)])
print_set("NSET", "SIDES", [node(c, r) for r in range(ROWS + 1) for c in (0, COLUMNS)])
print_set("NSET", "STRIP", [node(c, 0) for c in range(UNDER_STRIP + 1)])
print_set("NSET", "SURFACE", [node(c, 0) for c in range(COLUMNS + 1)])
print_set("ELSET", "TOP", [element(c, 0) for c in range(COLUMNS)])
# Below the middle of the strip, inside and outside its edge, deeper below it, and where little happens.
print_set("ELSET", "PATHS", [element(*at) for at in
                             ((0, 0), (3, 0), (4, 0), (5, 2), (1, 5), (10, 1), (24, 14))])

# Points 1, 2, 5, 6 of a plane element lie below its middle, 3, 4, 7, 8 above.
print("*INITIAL CONDITIONS, TYPE=STRESS")
for row in range(ROWS):
    middle, half = (Y[row] + Y[row + 1]) / 2, (Y[row] - Y[row + 1]) / 2
    for column in range(COLUMNS):
        for point in range(1, 9):
            y = middle + half / sqrt(3) * (1 if point in (3, 4, 7, 8) else -1)
            s = UNIT_WEIGHT * y - SURCHARGE
            print(f"{element(column, row)}, {point}, {K0 * s:.10g}, {s:.10g}, {K0 * s:.10g}, 0., 0., 0.")
