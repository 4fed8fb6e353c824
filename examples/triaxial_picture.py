# SPDX-License-Identifier: BSD-3-Clause
"""Drained triaxial tests of Lausitz sand at 100 kPa, dense to loose, as a table and as the picture triaxial.svg, which
gnuplot draws (Debian: gnuplot-nox)."""
import subprocess

import numpy as np

import grit

sand = grit.Sand("lausitz")
void_ratios = 0.55, 0.65, 0.75
curves = []  # axial shortening [%], q [kPa], volumetric strain [%], extension positive
for void_ratio in void_ratios:
    test = grit.element_test(sand, [grit.stage.triaxial_drained(-0.2)], [-100, -100, -100, 0, 0, 0], void_ratio)
    stress, strain = test["stress"], test["strain"]
    curves.append(np.column_stack([-100 * strain[:, 0], stress[:, 1] - stress[:, 0], 100 * strain[:, :3].sum(axis=1)]))
    print(f"e {void_ratio:.2f}  largest q {curves[-1][:, 1].max():6.1f} kPa  volume after 20 % {curves[-1][-1, 2]:+.2f} %")

lines = ["set terminal svg noenhanced size 900, 420 background '#ffffff'", "set output 'triaxial.svg'",
         "set multiplot layout 1, 2", "set grid", "set xlabel 'axial shortening (%)'"]
for column, (label, key) in enumerate([("q (kPa)", "bottom right"), ("volumetric strain (%)", "top left")], start=1):
    lines += [f"set ylabel '{label}'", f"set key {key}",
              "plot " + ", ".join(f"'-' with lines lw 2 title 'e = {e:.2f}'" for e in void_ratios)]
    for curve in curves:
        lines += [f"{row[0]:.6g} {row[column]:.6g}" for row in curve] + ["e"]
subprocess.run(["gnuplot"], input="\n".join(lines + ["unset multiplot"]), text=True, check=True)
print("picture: triaxial.svg")
