#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""verification/pile/two_blows.toml with its shaft elsewhere in its cell: shifted_pile.py FIRST_CELL LAW > CASE.toml

FIRST_CELL: width of the cell at the axis, in widths of the others (68.25 mm). LAW: geo or surface."""
import os
import re
import sys

BESIDE = os.path.dirname(os.path.abspath(__file__))
WIDTH = 0.06825


def case(first_cell, law):
    first = first_cell * WIDTH
    cells = 3 if first_cell > 0.9 else 4
    fine = first + cells * WIDTH
    with open(os.path.join(BESIDE, "../pile/dense_gca.toml"), encoding="utf-8") as file:
        text = file.read()
    for old, new in (
            ("[[grid.r]]\nto_m = 0.273\ncells = 8\n",
             f"[[grid.r]]\nto_m = {first!r}\ncells = 1\n[[grid.r]]\nto_m = {fine!r}\ncells = {cells}\n"),
            ("cell_m = 0.034125\ngrowth = 1.1", f"cell_m = {WIDTH}\ngrowth = 1.3"),
            ("0.273", repr(fine)),
            ("cell_m = 0.045\ngrowth = 0.9", "cell_m = 0.09\ngrowth = 0.75"),
            ("to_m = 4.59\ncells = 180", "to_m = 4.59\ncells = 90"),
            ("time_s = 1.15", "time_s = 0.55"),
            ("blows = 20", "blows = 2"),
            ("interval_s = 0.2\nvariables", "interval_s = 5\nvariables")):
        if old not in text:
            raise SystemExit(f"dense_gca.toml has no {old!r}")
        text = text.replace(old, new)
    if law == "surface":
        text = re.sub(r'law = "geo".*', 'law = "surface"', text.replace("gated = false\n", ""))
    return text


def main():
    sys.stdout.write(case(float(sys.argv[1]), sys.argv[2]))


if __name__ == "__main__":
    main()
