#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""push.py [--grit FILE] [--out DIR] [--jobs N] [CASE ...]: pushes of this folder and the tables of docs/push.md.

CASE: files of this folder without .toml; default: all. What has ended in DIR (results/push) is not run again."""
import argparse
import concurrent.futures
import math
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from results import K0, Frame, History  # noqa: E402
from results import rings as beside_shaft  # noqa: E402

RADIUS = 0.15  # [m]
DEPTHS = (0.1, 0.2, 0.3, 0.5)  # of the push [m]
GAMMA = 2650 / 1.55 * 9.81e-3  # of the sand at the start [kN/m3]


def run(grit, case, out):
    log = out / f"{case}.log"
    with log.open("w") as file:
        subprocess.run([grit, "mpm", str(HERE / f"{case}.toml"), "--out", str(out), "--no-plot"],
                       stdout=file, stderr=subprocess.STDOUT, check=True)


def work_at(history, depth):
    """Of the pile on the sand until a depth [kJ], all around."""
    depths, work = history["depth"], history["rigid_work"]
    for i in range(1, len(history)):
        if depths[i] >= depth:
            share = (depth - depths[i - 1]) / (depths[i] - depths[i - 1])
            return 1e-3 * (work[i - 1] + share * (work[i] - work[i - 1]))
    return math.nan


def rings(out, case):
    """In the last frame, within a quarter of a diameter of one diameter above the tip, for each ring: mean
    -sigma_rr by K0 gamma z, e, share without stress; and particles inside the pile's shaft."""
    last = sorted(out.glob(f"{case}_??????_soil.vtu"))[-1]
    sand, pile = Frame(last), Frame(str(last).replace("_soil", "_pile"))
    tip = min(z for corners in pile.corners for _, z in corners)
    at_rest = K0 * GAMMA * -(tip + 2 * RADIUS)
    found = [(stress, at_rest, void_ratio, free)
             for stress, void_ratio, free in beside_shaft(sand, RADIUS, tip + 1.5 * RADIUS, tip + 2.5 * RADIUS)]
    within = sum(1 for r, z in sand.centres() if r < 0.95 * RADIUS and z > tip + RADIUS)
    return found, within


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grit", default=str(HERE.parents[1] / "build/run/cli/grit"))
    parser.add_argument("--out", type=pathlib.Path, default=HERE.parents[1] / "results/push")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("cases", nargs="*", metavar="CASE")
    args = parser.parse_args()
    cases = args.cases or sorted(file.stem for file in HERE.glob("*.toml"))
    for case in cases:
        if not (HERE / f"{case}.toml").exists():
            sys.exit(f"push.py: no case {case} in {HERE}")
    if not os.access(args.grit, os.X_OK):
        sys.exit(f"push.py: no program {args.grit}: script/run builds it")
    args.out.mkdir(parents=True, exist_ok=True)
    due = [case for case in cases if not (args.out / f"{case}.csv").exists()]
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(lambda case: run(args.grit, case, args.out), due))
    print("| case | " + " | ".join(f"work to {d} m [kJ]" for d in DEPTHS) +
          " | shaft [kN], most | sigma_rr / K0 gamma z, rings | e | stress-free [%] | in the pile |")
    print("|" + "---|" * (len(DEPTHS) + 6))
    for case in cases:
        history = History(args.out / f"{case}.csv")
        works = [work_at(history, depth) for depth in DEPTHS]
        of_rings, within = rings(args.out, case)
        columns = [case] + ["" if math.isnan(w) else f"{w:.2f}" for w in works]
        columns.append(f"{max(abs(force) for force in history['shaft_force']):.2f}")
        columns.append(", ".join(f"{stress / rest:.1f}" for stress, rest, _, _ in of_rings))
        columns.append(", ".join(f"{e:.2f}" for _, _, e, _ in of_rings))
        columns.append(", ".join(f"{100 * free:.0f}" for _, _, _, free in of_rings))
        print("| " + " | ".join(columns) + f" | {within} |")


if __name__ == "__main__":
    main()
