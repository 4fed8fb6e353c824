#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""liquefaction.py [--grit FILE] [--out DIR] [--to DIR] [--undrained]: runs liquefying_column.toml, the same undrained and its
levels as element tests; prints the tables of docs/saturated.md and draws its picture (gnuplot). --undrained leaves the
column that drains out, and fails where the other one is not what element tests say."""
import csv
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from alternating import fourth  # noqa: E402
from piles import frames  # noqa: E402
from results import Frame  # noqa: E402
from studies import command_line  # noqa: E402

COLUMN, UNDRAINED, POINTS = "liquefying_column", "liquefying_column_undrained", "liquefying_levels"
LEVELS = {0.35: "z035", 1.05: "z105", 1.75: "z175"}  # [m]: samples of the element tests
START, CYCLES, PER_CYCLE = 0.5, 10, 200  # [s], of a second each; increments of the element tests
TOLERANCE = 0.006
COLOURS = ("#D55E00", "#0072B2", "#009E73")


class Column:
    """Excess pore pressures, by the effective vertical stress at the start."""

    def __init__(self, out, case):
        self.frames = frames(out, case)
        self.first = Frame(self.frames[0][1])
        self.levels = [z for _, z in self.first.centres()]
        self.vertical = [-s for s in self.first["stress_zz"]]

    def frame(self, time):
        return Frame(min(self.frames, key=lambda f: abs(f[0] - time))[1])

    def shares(self, time):
        now = self.frame(time)["pore_pressure"]
        return [(p - before) / s for p, before, s in zip(now, self.first["pore_pressure"], self.vertical)]

    def share(self, time, level):
        return self.shares(time)[self.index(level)]

    def index(self, level):
        return min(range(len(self.levels)), key=lambda i: abs(self.levels[i] - level))

    def alternating(self):
        """What of the pressures changes its sign from cell to cell, the most of all frames, by the largest effective stress at the
        start: fourth differences over 16, of two neighbours with different signs the smaller one."""
        most = 0.0
        for _, file in self.frames:
            cells = {(0, i): p for i, p in enumerate(Frame(file)["pore_pressure"])}
            parts = [fourth(cells, (0, i), (0, 1)) for i in range(2, len(cells) - 2)]
            most = max([most, *(min(abs(a), abs(b)) for a, b in zip(parts, parts[1:]) if a * b < 0)])
        return most / max(self.vertical)

    def settlement(self, time):
        frame = self.frame(time)
        return -frame["displacement"][3 * (frame.count - 1) + 1]


def of_element_test(out, level):
    """The same at the end of each cycle."""
    with (out / f"{POINTS}_{LEVELS[level]}.csv").open() as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    names = [name.split(" ")[0] for name in rows[0]]
    pore, vertical = names.index("pore_pressure"), names.index("stress_22")
    first = rows[1]
    return [(float(rows[1 + PER_CYCLE * n][pore]) - float(first[pore])) / -float(first[vertical])
            for n in range(CYCLES + 1)]


def run(grit, *arguments):
    subprocess.run([grit, *map(str, arguments), "--no-plot", "--quiet"], check=True)


def table_of_cycles(columns, points):
    print("| after cycle | " + " | ".join(f"{name}, z = {z} m" for z in LEVELS
                                          for name in ("element test", *columns)) + " |")
    print("|---" * (1 + len(LEVELS) * (1 + len(columns))) + "|")
    for n in range(1, CYCLES + 1):
        cells = []
        for z in LEVELS:
            cells += [points[z][n]] + [column.share(START + n, z) for column in columns.values()]
        print(f"| {n} | " + " | ".join(f"{x:.3f}" for x in cells) + " |")


def table_of_draining(column):
    print("\n| after the shaking [s] | " + " | ".join(f"z = {z} m" for z in LEVELS) + " | settlement [mm] |")
    print("|---" * (2 + len(LEVELS)) + "|")
    for after in (0, 10, 30, 60, 120, 240):
        time = START + CYCLES + after
        print(f"| {after} | " + " | ".join(f"{column.share(time, z):.3f}" for z in LEVELS)
              + f" | {1e3 * column.settlement(time):.1f} |")


def draw(column, points, target):
    from figures import block, gnuplot
    script = ""
    for k, z in enumerate(LEVELS):
        rows = [f"{t:.4g} {column.share(t, z):.4g}" for t, _ in column.frames if t < 20.0]
        script += block(f"c{k}", rows)
        script += block(f"p{k}", [f"{START + n} {points[z][n]:.4g}" for n in range(CYCLES + 1)])
    times = (0, 1.5, 2.5, 4.5, 10.5, 40.5, 130.5, 250.5)
    script += block("limit", [f"{s:.4g} {z:.4g}" for s, z in zip(column.vertical, column.levels)])
    for k, t in enumerate(times):
        rows = [f"{x * s:.4g} {z:.4g}" for x, s, z in zip(column.shares(t), column.vertical, column.levels)]
        script += block(f"t{k}", rows)
    script += """set multiplot layout 1,2
set xlabel 'time [s]'
set ylabel 'excess pore pressure / initial effective vertical stress'
set yrange [0:1.05]
set key bottom right
plot """ + ", ".join(f"$c{k} with lines lw 2 lc rgb '{c}' title 'z = {z} m', $p{k} with points pt 6 lc rgb '{c}' notitle"
                     for k, (z, c) in enumerate(zip(LEVELS, COLOURS))) + """
set xlabel 'excess pore pressure [kPa]'
set ylabel 'z [m]'
set yrange [0:2]
set xrange [0:24]
set key top right
plot $limit with lines lw 2 dt 2 lc rgb '#222222' title 'effective stress at the start', """ + ", ".join(
        f"$t{k} with lines lw 2 lc rgb '{'#0072B2' if t <= START + CYCLES else '#D55E00'}' dt {1 + k % 4} title '{t} s'"
        for k, t in enumerate(times) if k) + """
unset multiplot
"""
    gnuplot(script, target, 900, 420)


def main():
    parser = command_line(__doc__, "saturated", jobs=False)
    parser.add_argument("--to", type=pathlib.Path, help="folder of the picture")
    parser.add_argument("--undrained", action="store_true")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    run(args.grit, "element", HERE / f"{POINTS}.toml", "--out", args.out)
    for case in (UNDRAINED,) if args.undrained else (UNDRAINED, COLUMN):
        run(args.grit, "mpm", HERE / f"{case}.toml", "--out", args.out)
    points = {z: of_element_test(args.out, z) for z in LEVELS}
    columns = {"undrained": Column(args.out, UNDRAINED)}
    if not args.undrained:
        columns["k = 1e-4 m/s"] = Column(args.out, COLUMN)
    table_of_cycles(columns, points)
    if not args.undrained:
        table_of_draining(columns["k = 1e-4 m/s"])
    if args.to:
        draw(columns["k = 1e-4 m/s"], points, args.to / "liquefaction.svg")
    worst = max(abs(columns["undrained"].share(START + n, z) - points[z][n])
                for z in LEVELS for n in range(1, CYCLES + 1))
    print("\nalternating from cell to cell, most: " +
          ", ".join(f"{name} {100 * column.alternating():.2f} %" for name, column in columns.items()))
    print(f"\nundrained: {worst:.4f} off the element tests, at most")
    if worst > TOLERANCE:
        sys.exit(f"liquefaction.py: more than {TOLERANCE}")


if __name__ == "__main__":
    main()
