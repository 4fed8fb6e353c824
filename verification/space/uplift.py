#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What pulls a square plate anchor out: uplift.py CASE.toml HISTORY.csv [--friction-angle DEG] [--to PICTURE.svg]

CASE: of grit mpm in space, a quarter of an anchor that is a box; HISTORY: what it left. Prints the force of contact on the whole
anchor over its way, beside the upper bound of Murray & Geddes (1987), gamma A H (1 + H/B tan phi (2 + pi/3 H/B tan phi)); gnuplot
draws it."""
import math
import pathlib

from in_sand import InSand, block, gnuplot, options_of

WAYS = (0.002, 0.005, 0.01, 0.02, 0.03, 0.05, 0.075)  # [m]


def main():
    options = options_of(__doc__)
    anchor = InSand(options.case, options.history)
    box = anchor.body["box"][0]
    width, deep = 2.0 * box["x_m"][1], -box["z_m"][1]
    slope = deep / width * math.tan(math.radians(options.friction_angle))
    bound = anchor.weight * width ** 2 * deep * (1.0 + slope * (2.0 + math.pi / 3.0 * slope))
    pulled = [(-row["depth"], -4.0 * row["contact_force_z"]) for row in anchor.rows if row["stage"] == 2]
    print("| way [mm] | " + " | ".join(f"{1e3 * way:g}" for way in WAYS) + " | most | Murray & Geddes |")
    print("|---|" + "---|" * (len(WAYS) + 2))
    near = [min(pulled, key=lambda row: abs(row[0] - way)) for way in WAYS if way <= pulled[-1][0] + 1e-3]
    most = max(pulled, key=lambda row: row[1])
    cells = [f"{force:.1f}" for _, force in near] + [""] * (len(WAYS) - len(near))
    print("| force [kN] | " + " | ".join(cells) + f" | {most[1]:.1f} at {1e3 * most[0]:.0f} mm | {bound:.1f} |")
    if options.to:
        gnuplot(block("mpm", [f"{1e3 * way:.3f} {force:.4f}" for way, force in pulled])
                + "set xlabel 'way [mm]'; set ylabel 'force [kN]'; set grid lc rgb '#dddddd'; set key bottom right\n"
                f"set xrange [0:*]; set yrange [0:*]; bound = {bound:.4f}\n"
                "plot $mpm with lines lw 2 lc rgb '#0072B2' title 'material points', "
                f"bound with lines lw 1.5 dt 2 lc rgb '#D55E00' title 'Murray and Geddes, {options.friction_angle:g}°'",
                pathlib.Path(options.to), 600, 420)


if __name__ == "__main__":
    main()
