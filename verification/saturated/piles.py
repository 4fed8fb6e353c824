#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""piles.py [--grit FILE] [--out DIR] [--jobs N] [CASE ...]: piles driven into sand below the water table, the cases
pile_*.toml of this folder, and the table of docs/saturated.md.

What has ended in DIR (results/saturated) is not run again."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from results import Frame, History  # noqa: E402
from studies import chosen, command_line, processor_seconds, run_all  # noqa: E402

RADIUS, EMBEDMENT = 0.15, 0.5  # [m]
COUNTS, SHOWN = (5, 10, 20), 10  # blows that penetrations are told after, and whose peak the others are of


def run_due(args, cases):
    """Those that have not ended, with one thread each."""
    logs = {case: args.out / f"{case}.log" for case in cases}
    due = [case for case, log in logs.items() if not (log.exists() and "stage drive ended" in log.read_text())]
    run_all(args, [HERE / f"{case}.toml" for case in due], "--threads", "1")


def frames(out, case):
    """(time, file) of the sand."""
    entries = re.findall(r'timestep="([^"]*)"[^>]*file="([^"]*_sand\.vtu)"', (out / f"{case}.pvd").read_text())
    return [(float(time), out / file) for time, file in entries]


def excess(frame, depth, inside):
    """Mean of what the pore pressure has beyond that at rest, by volume of the ring, where inside(r, below) [kPa]."""
    total = volume = 0.0
    for corners, p in zip(frame.corners, frame.values["pore_pressure"]):
        r, z = (sum(c[k] for c in corners) / 4 for k in (0, 1))
        if inside(r, -EMBEDMENT - depth - z):
            area = 0.5 * abs(sum(corners[k - 1][0] * corners[k][1] - corners[k][0] * corners[k - 1][1]
                                 for k in range(4)))
            total += (p - 9.81 * max(0.0, -z)) * area * r
            volume += area * r
    return total / volume if volume else float("nan")


def told(case):
    """Sand and water of pile_SAND_WATER.toml."""
    sand, water = case.removeprefix("pile_").split("_", 1)
    return f"{sand}, " + (f"k = 1e-{water[-1]} m/s" if water.startswith("flow_1e") else water)


def row(out, case):
    history = History(out / f"{case}.csv")
    blows, depth = history.blows(), history["depth"]
    driven = [f"{1e3 * (depth[blows[n - 1][1]] - depth[history.drive()]):.0f}" if n <= len(blows) else "–" for n in COUNTS]
    cells = [told(case) + (", stopped" if history.stopped else ""),
             f"{1e3 * depth[history.drive()]:.0f}", *driven, str(len(blows))]
    first, last = blows[SHOWN - 1]
    peak = max(range(first, last), key=lambda i: history["hammer_force"][i])
    time, file = min(frames(out, case), key=lambda f: abs(f[0] - history["t"][peak]))
    now, at = Frame(file), min(range(len(history)), key=lambda i: abs(history["t"][i] - time))
    if "pore_pressure" in now.values:
        below = excess(now, depth[at], lambda r, z: r < RADIUS and 0.0 < z < 2 * RADIUS)
        beside = excess(now, depth[at], lambda r, z: RADIUS < r < 2 * RADIUS and -2 * RADIUS < z < 0.0)
        cells += [f"{below:.0f}", f"{beside:.0f}"]
    else:
        cells += ["–", "–"]
    cells += [f"{max(history['tip_force'][first:last]):.0f}", f"{max(abs(x) for x in history['residual_share']):.0e}",
              f"{processor_seconds(out, case) / 60:.1f}"]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = command_line(__doc__, "saturated")
    parser.add_argument("cases", nargs="*", metavar="CASE")
    args = parser.parse_args()
    cases = chosen(args.cases, sorted(p.stem for p in HERE.glob("pile_*.toml")))
    run_due(args, cases)
    print("| case | by its weight [mm] | " + " | ".join(f"by {n} blows [mm]" for n in COUNTS) + f" | blows | excess pore pressure at "
          f"the peak of blow {SHOWN}, below the tip [kPa] | beside it [kPa] | tip, most of that blow [kN] | energy residual, most | "
          "processor [min] |\n" + "|---" * (8 + len(COUNTS)) + "|")
    for case in cases:
        print(row(args.out, case), flush=True)


if __name__ == "__main__":
    main()
