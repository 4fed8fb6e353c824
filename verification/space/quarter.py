#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A quarter of a pile beside the plane of it: quarter.py PLANE.csv QUARTER.csv, histories of grit mpm

prints depth, and the force of contact as a mean over time, at the end of each stage and blow; four times the quarter's."""
import csv
import sys


def rows_of(file):
    with open(file, encoding="utf-8") as lines:
        table = csv.reader(line for line in lines if not line.startswith("#"))
        names = [name.split(" [")[0] for name in next(table)]
        return [dict(zip(names, map(float, row))) for row in table]


def contact(row):
    return sum(row[name] for name in ("tip_force", "shaft_force", "under_force", "side_force") if name in row)


def seen(rows, since, until):
    """Depth at the end, and the mean and the largest force of contact between two times."""
    some = [row for row in rows if since < row["t"] <= until]
    before = max((row["t"] for row in rows if row["t"] <= since), default=0.0)
    impulse, largest, last = 0.0, 0.0, before
    for row in some:
        impulse += contact(row) * (row["t"] - last)
        largest = max(largest, contact(row))
        last = row["t"]
    return some[-1]["depth"], impulse / (last - before), largest


def main():
    plane, quarter = rows_of(sys.argv[1]), rows_of(sys.argv[2])
    print("| until | depth [m]: plane | quarter | | mean contact force [kN]: plane | quarter | | largest: plane | quarter |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, since, until in (("self-weight, 0.55 s", 0.0, 0.55), ("first blow, 0.95 s", 0.55, 0.95), ("second blow, 1.35 s", 0.95, 1.35)):
        if until > quarter[-1]["t"] + 0.01:
            print(f"the quarter ends at {quarter[-1]['t']:.3f} s")
            return
        a, b = seen(plane, since, until + 1e-3), seen(quarter, since, until + 1e-3)
        b = (b[0], 4.0 * b[1], 4.0 * b[2])
        share = [100.0 * (y / x - 1.0) for x, y in zip(a, b)]
        print(f"| {name} | {a[0]:.4f} | {b[0]:.4f} | {share[0]:+.1f} % | {a[1]:.2f} | {b[1]:.2f} | {share[1]:+.1f} % "
              f"| {a[2]:.1f} | {b[2]:.1f} |")


if __name__ == "__main__":
    main()
