#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A quarter beside the mean of planes that differ by where the side lies in its cell: phases.py [--at SECONDS] PLANE.csv ...
QUARTER.csv, histories of grit mpm

prints depth and force of contact of each at a time, the last one if none is given; four times the quarter's force."""
import argparse

from quarter import contact, rows_of


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--at", type=float, default=float("inf"))
    parser.add_argument("files", nargs="+")
    arguments = parser.parse_args()
    seen = []
    for file in arguments.files:
        row = [row for row in rows_of(file) if row["t"] <= arguments.at + 1e-3][-1]
        seen.append((1e3 * row["depth"], contact(row) * (4.0 if "under_force" in row else 1.0)))
        print(f"{file} {row['t']:.3f} s {seen[-1][0]:.3f} mm {seen[-1][1]:.2f} kN")
    for name, values in zip(("depth", "force"), zip(*seen)):
        planes, quarter = values[:-1], values[-1]
        mean = sum(planes) / len(planes)
        print(f"{name}: planes {mean:.3f}, {100.0 * (min(planes) / mean - 1.0):+.1f} to "
              f"{100.0 * (max(planes) / mean - 1.0):+.1f} %; quarter {100.0 * (quarter / mean - 1.0):+.1f} %")


if __name__ == "__main__":
    main()
