#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check.py GRIT DIR: runs two_blows.toml into DIR and holds what it measures against two_blows.csv. --results: of a
run that is there already; --write: put what it measures there."""
import argparse
import csv
import pathlib
import subprocess
import sys

from measures import energies, level_of_tip, momentum_identity, peak_frames, radial_stress, sets
from results import Run, Unusable

HERE = pathlib.Path(__file__).resolve().parent
REFERENCE = HERE / "two_blows.csv"


def measured(run):
    """(what, unit, value, relative tolerance). A tenth of the sand's tolerance moves them by a third of theirs at most."""
    own, each, rebound = sets(run.history)
    worst, peak, _ = momentum_identity(run.history)
    e = energies(run.history)
    work = e["hammer"] + e["weight"]
    cells, _ = radial_stress(run, peak_frames(run)[-1])
    yield "particles", "-", run.history.particles, 1e-12
    yield "penetration by self-weight", "m", own, 0.005
    for k, value in enumerate(each):
        yield f"set of blow {k + 1}", "m", value, 0.005
        yield f"rebound of blow {k + 1}", "m", rebound[k], 0.02
    yield "largest reaction", "kN", peak, 0.005
    yield "work of the hammer", "J", e["hammer"], 0.005
    yield "work of stress in the sand", "J", e["sand"], 0.005
    yield "contact loss", "J", e["contact"], 0.01
    yield "largest radial stress at the last peak", "kPa", max(s for s, _, _ in cells.values()), 0.03
    yield "level of the tip at the last peak", "m", level_of_tip(run, peak_frames(run)[-1]), 0.001
    yield "momentum identity below 1 % of the reaction", "-", float(worst < 0.01 * peak), 0.0
    yield "energy residual below 0.1 % of the work", "-", float(abs(e["residual"]) < 1e-3 * work), 0.0


def write(found):
    with REFERENCE.open("w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["measure", "unit", "value", "tolerance"])
        table.writerows((what, unit, f"{value:.6g}", f"{tolerance:g}") for what, unit, value, tolerance in found)


def compare(found):
    """Whether all is as committed; says what is."""
    with REFERENCE.open(newline="") as file:
        wanted = {row["measure"]: row for row in csv.DictReader(file)}
    fine = set(wanted) == {what for what, *_ in found}
    if not fine:
        print(f"{REFERENCE.name} has other measures than the run")
    for what, unit, value, _ in found:
        if what not in wanted:
            continue
        reference, tolerance = float(wanted[what]["value"]), float(wanted[what]["tolerance"])
        off = abs(value - reference)
        ok = off <= tolerance * abs(reference)
        fine = fine and ok
        print(f"{what:<45} {value:>10.5g} {reference:>10.5g} {unit:<4} within {100 * tolerance:g} %"
              + ("" if ok else "  FAILED"))
    return fine


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("grit", help="the program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--results", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    if not options.results:
        subprocess.run([options.grit, "mpm", HERE / "two_blows.toml", "--out", options.folder, "--no-plot", "--quiet"],
                       check=True)
    try:
        found = list(measured(Run(options.folder, "two_blows")))
    except Unusable as problem:
        sys.exit(f"check.py: {problem}")
    if options.write:
        write(found)
    sys.exit(0 if compare(found) else 1)


if __name__ == "__main__":
    main()
