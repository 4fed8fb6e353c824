#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""push.py [--grit FILE] [--out DIR] [--jobs N] [--members N] [--frames] [CASE ...]: pushes of this folder and the tables of docs/push.md.

CASE: files of this folder without .toml; default: all. What has ended in DIR (results/push) is not run again.
--members: N runs of each case that differ by choices that are none, in DIR/members, and the table of their means ± standard
deviations; stresses beside the shaft are means over the frames of the last 0.1 m as well. --frames: what presses on the shaft in each
frame instead."""
import math
import pathlib
import statistics
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from results import K0, Frame, History  # noqa: E402
from results import rings as beside_shaft  # noqa: E402
from studies import chosen, command_line, run_all  # noqa: E402

RADIUS = 0.15  # [m]
DEPTHS = (0.1, 0.2, 0.3, 0.5)  # of the push [m]
GAMMA = 2650 / 1.55 * 9.81e-3  # of the sand at the start [kN/m3]
NEUTRAL = ({"body.soil.grain_density_kg_per_m3": 2650 * (1 + 1e-9)}, {"numerics.cfl": 0.38}, {"numerics.cfl": 0.42},
           {"body.soil.grain_density_kg_per_m3": 2650 * (1 - 1e-9)}, {"body.soil.grain_density_kg_per_m3": 2650 * (1 + 2e-9)})
LAST = 0.1  # of the push, whose frames count for members [m]
FRAME = 0.02  # a frame of members each [m]


def speed_of(case):
    """As the files' names tell [m/s]."""
    return {"05": 0.5, "02": 0.2}.get(next((part for part in case.split("_") if part in ("05", "02")), ""), 1.0)


def write_members(case, count, out):
    """Case files; their names are CASE-1 ..."""
    files = []
    for k, choice in enumerate(NEUTRAL[:count]):
        keys = choice | {"fields.interval_s": FRAME / speed_of(case)}
        files.append(out / f"{case}-{k + 1}.toml")
        files[-1].write_text(f'base = "{HERE / case}.toml"\n[override]\n' +
                             "".join(f'"{key}" = {value!r}\n' for key, value in keys.items()))
    return files


def work_at(history, depth):
    """Of the pile on the sand until a depth [kJ], all around."""
    depths, work = history["depth"], history["rigid_work"]
    for i in range(1, len(history)):
        if depths[i] >= depth:
            share = (depth - depths[i - 1]) / (depths[i] - depths[i - 1])
            return 1e-3 * (work[i - 1] + share * (work[i] - work[i - 1]))
    return math.nan


def tip_of(pile):
    return min(z for corners in pile.corners for _, z in corners)


def soil_frames(out, case):
    return sorted(out.glob(f"{case}_??????_soil.vtu"))


def of_frame(soil):
    """(z of the tip, of each ring within a quarter of a diameter of one diameter above it: mean -sigma_rr by K0 gamma z, e,
    share without stress, the sand); none where that is above the ground."""
    tip = tip_of(Frame(str(soil).replace("_soil", "_pile")))
    sand = Frame(soil)
    level = tip + 2 * RADIUS
    of_rings = [] if level > -0.5 * RADIUS else beside_shaft(sand, RADIUS, level - 0.5 * RADIUS, level + 0.5 * RADIUS)
    return tip, [(stress / (K0 * GAMMA * -level), void_ratio, free) for stress, void_ratio, free in of_rings], sand


def rings(out, case, last=0.0):
    """In the frames of the last metres, or the last one, within a quarter of a diameter of one diameter above the tip, for each
    ring: mean -sigma_rr by K0 gamma z, e, share without stress; and the particles inside the pile's shaft, at most."""
    found, within = [], 0
    lowest = None
    for soil in reversed(soil_frames(out, case)):
        tip, of_rings, sand = of_frame(soil)
        lowest = tip if lowest is None else lowest
        if found and tip - lowest > last:
            break
        found.append(of_rings)
        within = max(within, sum(1 for r, z in sand.centres() if r < 0.95 * RADIUS and z > tip + RADIUS))
        if last == 0.0:
            break
    return [tuple(statistics.fmean(x) for x in zip(*ring)) for ring in zip(*found)], within


def print_header(columns):
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))


BESIDE = ["sigma_rr / K0 gamma z, rings", "e", "stress-free [%]", "in the pile"]
WORK = [f"work to {d} m [kJ]" for d in DEPTHS]


def print_cases(cases, out):
    print_header(["case"] + WORK + ["shaft [kN], most"] + BESIDE)
    for case in cases:
        history = History(out / f"{case}.csv")
        works = [work_at(history, depth) for depth in DEPTHS]
        of_rings, within = rings(out, case)
        columns = [case] + ["" if math.isnan(w) else f"{w:.2f}" for w in works]
        columns.append(f"{max(abs(force) for force in history['shaft_force']):.2f}")
        columns.append(", ".join(f"{stress:.1f}" for stress, _, _ in of_rings))
        columns.append(", ".join(f"{e:.2f}" for _, e, _ in of_rings))
        columns.append(", ".join(f"{100 * free:.0f}" for _, _, free in of_rings))
        print("| " + " | ".join(columns) + f" | {within} |")


def print_frames(cases, out):
    print_header(["case", "tip [m]", BESIDE[0]])
    for case in cases:
        for soil in soil_frames(out, case):
            tip, of_rings, _ = of_frame(soil)
            if of_rings:
                print(f"| {case} | {tip:.2f} | " + ", ".join(f"{stress:.2f}" for stress, _, _ in of_rings) + " |", flush=True)


def with_scatter(values, digits):
    if any(math.isnan(x) for x in values):
        return ""
    scatter = f" ± {statistics.stdev(values):.{digits}f}" if len(values) > 1 else ""
    return f"{statistics.fmean(values):.{digits}f}{scatter}"


def print_members(cases, out):
    print_header(["case", "runs"] + WORK + ["from 0.3 to 0.5 m [kPa]"] + BESIDE)
    for case in cases:
        names = sorted(file.stem for file in out.glob(f"{case}-?.csv"))
        histories = [History(out / f"{name}.csv") for name in names]
        works = [[work_at(history, depth) for depth in DEPTHS] for history in histories]
        columns = [case, str(len(names))] + [with_scatter(column, 2) for column in zip(*works)]
        columns.append(with_scatter([(w[3] - w[2]) / (0.2 * math.pi * RADIUS**2) for w in works], 0))
        found = [rings(out, name, LAST) for name in names]
        for which, factor, digits in ((0, 1, 1), (1, 1, 2), (2, 100, 0)):
            columns.append(", ".join(with_scatter([factor * of_rings[ring][which] for of_rings, _ in found], digits)
                                     for ring in range(3)))
        print("| " + " | ".join(columns) + f" | {max(within for _, within in found)} |")


def main():
    parser = command_line(__doc__, "push")
    parser.add_argument("--members", type=int, default=0, choices=range(len(NEUTRAL) + 1), metavar="N")
    parser.add_argument("--frames", action="store_true")
    parser.add_argument("cases", nargs="*", metavar="CASE")
    args = parser.parse_args()
    cases = chosen(args.cases, sorted(file.stem for file in HERE.glob("*.toml")))
    if args.members:
        args.out /= "members"
        args.out.mkdir(parents=True, exist_ok=True)
    files = [HERE / f"{case}.toml" for case in cases]
    if args.members:  # the first members of all cases come first
        files = [file for same in zip(*(write_members(case, args.members, args.out) for case in cases)) for file in same]
    run_all(args, [file for file in files if not (args.out / f"{file.stem}.csv").exists()])
    if args.frames:
        print_frames([file.stem for file in files], args.out)
        return
    (print_members if args.members else print_cases)(cases, args.out)


if __name__ == "__main__":
    main()
