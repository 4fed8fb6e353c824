#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pushes.py [--grit FILE] [--out DIR] [--jobs N]: a rigid pile pushed into sand below the water table, the cases push_*.toml of
this folder, and the table of docs/saturated.md.

What has ended in DIR (results/saturated) is not run again."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from results import History  # noqa: E402
from studies import command_line, processor_seconds, run_all  # noqa: E402

WATERS = {"flow_1e3": "k = 1e-3 m/s", "flow_1e5": "k = 1e-5 m/s", "undrained": "undrained"}
CASES = {"push_dry": "dry"}
for _contact, _said in (("", ""), ("_surface", "surface, ")):
    for _water, _name in WATERS.items():
        CASES[f"push_{_water}{_contact}"] = _said + _name
        CASES[f"push_{_water}{_contact}_implicit"] = "... implicit"


def row(out, case):
    history = History(out / f"{case}.csv")
    pressures = "–" if case == "push_dry" else \
        f"{min(history['least_pore_pressure']) / 1e3:.0f} … {max(history['largest_pore_pressure']) / 1e3:.0f}"
    residual = max(abs(share) for share in history["residual_share"])
    return (f"| {CASES[case]} | {history['tip_force'][-1]:.1f} | {history['shaft_force'][-1]:.1f} | {pressures} | "
            f"{history['step'][-1]:.0f} | {processor_seconds(out, case):.1f} | {residual:.0e} |")


def main():
    args = command_line(__doc__, "saturated").parse_args()
    run_all(args, [HERE / f"{case}.toml" for case in CASES if not (args.out / f"{case}.csv").exists()], "--threads", "1")
    print("| at 40 mm | tip [kN] | shaft [kN] | pore pressure on the way [kPa] | steps | processor's time [s] | energy residual, "
          "most |\n" + "|---" * 7 + "|")
    for case in CASES:
        print(row(args.out, case), flush=True)


if __name__ == "__main__":
    main()
