# SPDX-License-Identifier: BSD-3-Clause
"""What studies of `grit mpm` have in common: options, and runs of many cases. Standard library only."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def command_line(doc, results, jobs=True):
    """doc: of the module, its name first. results: folder below results/."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grit", default=str(ROOT / "build/run/cli/grit"))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results" / results)
    if jobs:
        parser.add_argument("--jobs", type=int, default=os.cpu_count())
    return parser


def give_up(why):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {why}")


def chosen(wanted, known, what="case"):
    """Those that are wanted, or all."""
    for name in wanted:
        if name not in known:
            give_up(f"no {what} {name}: one of {', '.join(known)}")
    return wanted or known


def run(grit, file, out, *options):
    """What the program says goes to OUT/<case>.log, with the processor's time in its last line. Returns whether it ended
    with 0."""
    with (out / f"{file.stem}.log").open("w") as log:
        child = subprocess.Popen([grit, "mpm", str(file), "--out", str(out), "--no-plot", *options], stdout=log,
                                 stderr=subprocess.STDOUT)
        _, status, used = os.wait4(child.pid, 0)
        log.seek(0, os.SEEK_END)
        log.write(f"processor's time {used.ru_utime + used.ru_stime:.1f} s\n")
    return status == 0


def processor_seconds(out, case):
    """Of a run that has ended."""
    return float(re.findall(r"processor's time ([\d.]+) s", (out / f"{case}.log").read_text())[-1])


def run_all(args, files, *options):
    """As many at once as args.jobs says."""
    if files and not os.access(args.grit, os.X_OK):
        give_up(f"no program {args.grit}: script/run builds it")
    args.out.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        ended = list(pool.map(lambda file: run(args.grit, file, args.out, *options), files))
    if not all(ended):
        logs = [str(args.out / f"{file.stem}.log") for file, well in zip(files, ended) if not well]
        give_up("failed: " + ", ".join(logs))
