#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pushes.py [--grit FILE] [--out DIR] [--jobs N]: a rigid pile pushed into sand below the water table, the cases push_*.toml of
this folder, each with five CFL numbers and those with longer steps once in ones as short as the explicit pressure takes, and the
table of docs/saturated.md: means and standard deviations between runs, the difference to explicit pressure with its standard
error ("no": Student's t does not tell it from the scatter of the runs), and the extremes of pressures and residuals of all runs.

What has ended in DIR (results/saturated) is not run again."""
import pathlib
import statistics
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from ensemble import text  # noqa: E402
from ensemble_tables import difference, spread  # noqa: E402
from results import History  # noqa: E402
from studies import command_line, give_up, processor_seconds, run_all  # noqa: E402

SHORT, STEP = "_short", 7e-6  # [s]
WATERS = {"flow_1e3": "k = 1e-3 m/s", "flow_1e5": "k = 1e-5 m/s", "undrained": "undrained"}
IMPLICIT = "_implicit"
CASES = {"push_dry": "dry", "push_dry" + SHORT: "... in short steps"}
for _contact, _said in (("", ""), ("_surface", "surface, ")):
    for _water, _name in WATERS.items():
        CASES[f"push_{_water}{_contact}"] = _said + _name
        CASES[f"push_{_water}{_contact}{IMPLICIT}"] = "... implicit"
        CASES[f"push_{_water}{_contact}{IMPLICIT}{SHORT}"] = "... implicit, in short steps"
CFL = (0.38, 0.39, 0.40, 0.41, 0.42)


def members(case):
    """{name: its CFL number}"""
    return {case: CFL[2]} if case.endswith(SHORT) else {f"{case}-{k + 1}": cfl for k, cfl in enumerate(CFL)}


def write_members(out, case):
    """Case files of those that have not ended."""
    steps = {"numerics.largest_step_s": STEP} if case.endswith(SHORT) else {}
    for member, cfl in members(case).items():
        result = out / f"{member}.csv"
        if not result.exists() or History(result).stopped:
            file = out / f"{member}.toml"
            file.write_text(text(HERE / f"{case.removesuffix(SHORT)}.toml", {"numerics.cfl": cfl} | steps))
            yield file


class Pushes:
    """The runs of a case."""

    def __init__(self, out, case):
        self.runs = [History(out / f"{member}.csv") for member in members(case)]
        if any(run.stopped for run in self.runs):
            give_up(f"a run of {case} was stopped: call it again")
        self.seconds = statistics.fmean(processor_seconds(out, member) for member in members(case))

    def last(self, column):
        return [run[column][-1] for run in self.runs]

    def pressures(self):
        low = min(min(run["least_pore_pressure"]) for run in self.runs)
        return f"{low / 1e3:.0f} … {max(max(run['largest_pore_pressure']) for run in self.runs) / 1e3:.0f}"

    def residual(self):
        return max(abs(share) for run in self.runs for share in run["residual_share"])


def row(out, case):
    now, beside = Pushes(out, case), ""
    if case.endswith(IMPLICIT):
        explicit = Pushes(out, case.removesuffix(IMPLICIT))
        beside = difference(now.last("tip_force"), explicit.last("tip_force"), 1)
    pressures = "–" if case.startswith("push_dry") else now.pressures()
    return (f"| {CASES[case]} | {spread(now.last('tip_force'), 1)} | {beside} | {spread(now.last('shaft_force'), 1)} | {pressures} | "
            f"{statistics.fmean(now.last('step')):.0f} | {now.seconds:.1f} | {now.residual():.0e} |")


def main():
    args = command_line(__doc__, "saturated").parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    run_all(args, [file for case in CASES for file in write_members(args.out, case)], "--threads", "1")
    print("| at 40 mm | tip [kN] | more than explicit [kN] | shaft [kN] | pore pressure on the way [kPa] | steps | processor's time "
          "[s] | energy residual, most |\n" + "|---" * 8 + "|")
    for case in CASES:
        print(row(args.out, case), flush=True)


if __name__ == "__main__":
    main()
