#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""alternating.py [--grit FILE] [--out DIR] [--jobs N] [--picture FILE] [--scatter]: what of the pore pressures around a driven pile changes sign
from cell to cell, with contact at nodes and at surfaces: the cases blows_*.toml and those of piles.py that have water, and the table of
docs/saturated.md; a picture of the cells (gnuplot).

Means of cells, their excess over the pressure at rest; within three radii of the axis, three below the tip and six above it.
"Checkerboard": fourth differences along r and along z over 256, as in the table of blocks; by what the pile presses with, the
largest force on its tip over its section. "One way": fourth differences along r or along z over 16, the least of five cells in a row whose signs alternate: of a plain jump
nothing, of a cell that stands out a sixteenth. "Where water bears": where no particle of the 25 cells, or of those of the row, cavitates, for beside those that
do the pressure itself jumps.
--scatter: in place of that the loose piles whose water stays, with five CFL numbers each: means and standard deviations between runs, and
the largest of all.
What has ended
in DIR (results/saturated) is not run again."""
import bisect
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from ensemble_tables import spread  # noqa: E402
from figures import gnuplot  # noqa: E402
from results import Frame, History  # noqa: E402
from studies import command_line, run_all  # noqa: E402
from piles import EMBEDMENT, RADIUS, frames, run_due, told  # noqa: E402
from pushes import members, write_members  # noqa: E402

GROWTH, OUTSIDE = 1.3, (0.273, 5.0, 12)  # of cells beyond the pile's way: from, to [m], count
LINES_R = [0.06825 * n for n in range(4)] + [
    OUTSIDE[0] + (OUTSIDE[1] - OUTSIDE[0]) * (GROWTH**n - 1) / (GROWTH**OUTSIDE[2] - 1) for n in range(OUTSIDE[2] + 1)]
LOWEST, CELL_Z = -3.51, 0.09  # of the grid along the pile's way [m]
CAVITATES = 99.0  # a particle whose pressure is below that [kPa], of 100 in the cases
SHOWN = 1.05  # [s]
SCATTERED = ("pile_loose_flow_1e7", "pile_loose_undrained")


WEIGHTS = (1, -4, 6, -4, 1)


def cells(frame):
    """Mean excess pore pressure [kPa] by the numbers of a cell, and its least pore pressure [kPa]."""
    sums = {}
    for (r, z), area, p in zip(frame.centres(), frame.areas(), frame["pore_pressure"]):
        of = sums.setdefault((bisect.bisect(LINES_R, r) - 1, math.floor((z - LOWEST) / CELL_Z)), [0.0, 0.0, p])
        of[0] += area * (p - 9.81 * max(0.0, -z))
        of[1] += area
        of[2] = min(of[2], p)
    return {cell: p / area for cell, (p, area, _) in sums.items()}, {cell: of[2] for cell, of in sums.items()}


def centre(cell):
    return 0.5 * sum(LINES_R[cell[0]:cell[0] + 2]), LOWEST + (cell[1] + 0.5) * CELL_Z


def along(cell, direction, n):
    return tuple(c + n * d for c, d in zip(cell, direction))


def fourth(values, cell, direction):
    near = [values.get(along(cell, direction, n)) for n in range(-2, 3)]
    return None if None in near else sum(w * p for w, p in zip(WEIGHTS, near)) / 16


def in_a_row(values, cell, direction):
    """What alternates in the five cells around one; None: nine are not there."""
    parts = [fourth(values, along(cell, direction, n), direction) for n in range(-2, 3)]
    if None in parts:
        return None
    return min(map(abs, parts)) if all(a * b < 0 for a, b in zip(parts, parts[1:])) else 0.0


def around(values, cell):
    """The 25 cells around one, row by row; None: some are not there."""
    near = [values.get((cell[0] + i, cell[1] + j)) for j in range(-2, 3) for i in range(-2, 3)]
    return None if None in near else near


def near_the_tip(values, tip):
    for cell in values:
        r, z = centre(cell)
        if r < 3 * RADIUS and tip - 3 * RADIUS < z < min(tip + 6 * RADIUS, -0.2):
            yield cell


def one_way(values, least, tip):
    """(part, whether all nine cells bear)."""
    for cell in near_the_tip(values, tip):
        for direction in ((1, 0), (0, 1)):
            part = in_a_row(values, cell, direction)
            if part is not None:
                yield part, min(least[along(cell, direction, n)] for n in range(-4, 5)) > -CAVITATES


def checkerboards(values, least, tip):
    """(part, whether all 25 cells bear)."""
    for cell in near_the_tip(values, tip):
        near = around(values, cell)
        if near is None:
            continue
        part = sum(WEIGHTS[n // 5] * WEIGHTS[n % 5] * p for n, p in enumerate(near)) / 256
        yield abs(part), min(around(least, cell)) > -CAVITATES


def most(parts):
    return max(parts, default=float("nan"))


def rms(parts):
    return math.hypot(*parts) / len(parts) ** 0.5 if parts else float("nan")


class Drive:
    """All (part, whether the cells it looks at bear) of a run's frames [kPa], what it presses with [kPa], and its history."""

    def __init__(self, out, case):
        history = self.history = History(out / f"{case}.csv")
        drive, t, depth = history.drive(), history["t"], history["depth"]
        self.along, self.boards = [], []
        for time, file in frames(out, case):
            if time < t[drive]:
                continue
            at = min(range(len(history)), key=lambda i: abs(t[i] - time))
            values, least = cells(Frame(file))
            self.along += one_way(values, least, -EMBEDMENT - depth[at])
            self.boards += checkerboards(values, least, -EMBEDMENT - depth[at])
        self.pressed = max(history["tip_force"][drive:]) / (math.pi * RADIUS**2)

    def driven(self):
        """[mm]"""
        depth = self.history["depth"]
        return 1e3 * (depth[self.history.blows()[-1][1]] - depth[self.history.drive()])


def row(out, case):
    run = Drive(out, case)
    depth, pressed, along, boards = run.history["depth"], run.pressed, run.along, run.boards
    parts = [part for part, _ in boards]
    kind = told(case.removesuffix("_surface").replace("blows_", "pile_dense_"))
    law = "surface" if case.endswith("_surface") else "geo"

    def share(found):
        return f"{most(found):.1f}, {100 * most(found) / pressed:.2f} %"

    return (f"| {kind} | {law} | {1e3 * depth[run.history.drive()]:.0f} | {len(run.history.blows())} | {run.driven():.0f} | "
            f"{pressed:.0f} | {len(parts)} | {share(parts)} | "
            f"{rms(parts):.1f} | {share([part for part, bears in boards if bears])} | "
            f"{share([part for part, _ in along])} | {rms([part for part, _ in along]):.1f} | "
            f"{share([part for part, bears in along if bears])} |")


def draw(out, cases, target):
    data, script = "", ""
    for n, case in enumerate(cases):
        time, file = min(frames(out, case), key=lambda f: abs(f[0] - SHOWN))
        history = History(out / f"{case}.csv")
        at = min(range(len(history)), key=lambda i: abs(history["t"][i] - time))
        tip = -EMBEDMENT - history["depth"][at]
        data += f"${case} << EOD\n" + "".join(
            "{:.4f} {:.4f} {:.4f} {:.2f}\n".format(*centre(cell), (LINES_R[cell[0] + 1] - LINES_R[cell[0]]) / 2, p)
            for cell, p in cells(Frame(file))[0].items() if cell[0] < 9) + "EOD\n"
        name = case.removeprefix("blows_flow_").replace("1e", "k = 1e-").replace("_surface", ", surface")
        script += (f"set object 1 rectangle from 0,{tip} to {RADIUS},0 fillcolor rgb '#b8b8b8' fillstyle solid noborder behind\n"
                   f"set title '{name}' offset 0,-0.7\nplot [0:0.68] [-1.5:0] ${case} using 1:2:3:({CELL_Z}/2):4 "
                   "with boxxyerror fillstyle solid noborder linecolor palette\n")
        if n == len(cases) - 1:
            script += "unset multiplot\n"
    gnuplot(data + "unset key\nset tics font ',7'\nset palette defined (-1 '#2166ac', -0.4 '#92c5de', 0 '#f7f7f7', 0.4 '#f4a582', "
            "1 '#b2182b')\nset cbrange [-100:100]\nset cblabel 'excess pore pressure [kPa]' offset -1\nset xlabel 'r [m]' "
            "offset 0,0.7\nset ylabel 'z [m]' offset 1\nset multiplot layout 2,2\n" + script, target, 700, 640)


def scatter(args):
    """The table of SCATTERED."""
    args.out.mkdir(parents=True, exist_ok=True)
    run_all(args, [file for case in SCATTERED for file in write_members(args.out, case)], "--threads", "1")
    print("| case | runs | by 20 blows [mm] | checkerboard, most [%] | most of all runs | one way, most [%] | most of all runs |\n"
          + "|---" * 7 + "|")
    for case in SCATTERED:
        runs = [Drive(args.out, name) for name in members(case)]
        cells = [told(case), str(len(runs)), spread([run.driven() for run in runs], 0)]
        for of in ("boards", "along"):
            shares = [100 * most([part for part, _ in getattr(run, of)]) / run.pressed for run in runs]
            cells += [spread(shares, 2), f"{max(shares):.2f}"]
        print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = command_line(__doc__, "saturated")
    parser.add_argument("--picture", type=pathlib.Path)
    parser.add_argument("--scatter", action="store_true")
    args = parser.parse_args()
    if args.scatter:
        return scatter(args)
    blows = sorted(p.stem for p in HERE.glob("blows_*.toml"))
    piles = sorted(p.stem for p in HERE.glob("pile_*.toml") if "_dry" not in p.stem)
    run_due(args, blows + piles)
    print("| case | contact | by its weight [mm] | blows | by all of them [mm] | presses with [kPa] | cells, of all frames "
          "| checkerboard, most [kPa] | RMS [kPa] | where water bears | one way, most [kPa] | RMS [kPa] | where water bears |\n" + "|---" * 13 + "|")
    for case in blows + piles:
        print(row(args.out, case), flush=True)
    if args.picture:
        draw(args.out, blows, args.picture)


if __name__ == "__main__":
    main()
