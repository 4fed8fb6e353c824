#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""step_cost.py [--grit FILE] [--out DIR]: what a step of a driven pile costs in dry sand and below the water table, the cases
pile_*.toml until 0.1 s after the hammer has begun, one after the other and with one thread, the best of two rounds; a table of
docs/saturated.md. To be run on a machine that does nothing else."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from ensemble import text  # noqa: E402
from piles import told  # noqa: E402
from results import History  # noqa: E402
from studies import command_line, give_up, processor_seconds, run  # noqa: E402

ROUNDS = 2


def measured(args, file):
    """Processor's time of a step [us], and how long steps are on the mean [us]."""
    if not run(args.grit, file, args.out, "--threads", "1"):
        give_up(f"failed: {args.out / file.stem}.log")
    history = History(args.out / f"{file.stem}.csv")
    steps = history["step"][-1]
    return 1e6 * processor_seconds(args.out, file.stem) / steps, 1e6 * history["t"][-1] / steps


def main():
    args = command_line(__doc__, "saturated", jobs=False).parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    files = {}
    for case in sorted(HERE.glob("pile_*.toml")):
        files[case.stem] = args.out / f"{case.stem}-begun.toml"
        files[case.stem].write_text(text(case, {"stage.drive.until.time_s": 0.1}))
    found = {case: [] for case in files}
    for _ in range(ROUNDS):
        for case, file in files.items():
            found[case].append(measured(args, file))
    best = {case: min(all_of) for case, all_of in found.items()}
    print("| case | processor's time of a step [µs] | by the dry one | mean step [µs] | processor's time of a second, by the dry one |\n"
          + "|---" * 5 + "|")
    for case, (cost, step) in best.items():
        dry, dry_step = best["_".join(case.split("_")[:2]) + "_dry"]
        print(f"| {told(case)} | {cost:.0f} | ×{cost / dry:.2f} | {step:.1f} | ×{cost / step / (dry / dry_step):.2f} |")


if __name__ == "__main__":
    main()
