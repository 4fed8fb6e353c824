#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""verification/pile/two_blows.toml with its shaft elsewhere in its cell: shifted_pile.py FIRST_CELL LAW > CASE.toml

FIRST_CELL: width of the cell at the axis, in widths of the others (68.25 mm). LAW: geo or surface."""
import pathlib
import sys

TWO_BLOWS = pathlib.Path(__file__).resolve().parents[1] / "pile/two_blows.toml"
WIDTH, RADIUS, OUTSIDE = 0.06825, 0.15, 5.0  # [m]


def case(first_cell, law):
    first = first_cell * WIDTH
    cells = 3 if first_cell > 0.9 else 4
    fine = first + cells * WIDTH
    keys = {
        "grid.r": f"[{{to_m = {first!r}, cells = 1}}, {{to_m = {fine!r}, cells = {cells}}}, "
                  f"{{to_m = {OUTSIDE}, cell_m = {WIDTH}, growth = 1.3}}]",
        "body.sand.box.1.r_m": [0, fine], "body.sand.box.2.r_m": [RADIUS, fine],
        "body.sand.box.3.r_m": [0, fine], "body.sand.box.4.r_m": [fine, OUTSIDE],
        "fields.interval_s": 5,
    }
    if law == "surface":
        keys["contact"] = '[{stiff = "pile", soft = "sand", law = "surface", friction_coefficient = 0.3}]'
    return f'base = "{TWO_BLOWS}"\n[override]\n' + "".join(f'"{key}" = {value}\n' for key, value in keys.items())


def main():
    sys.stdout.write(case(float(sys.argv[1]), sys.argv[2]))


if __name__ == "__main__":
    main()
