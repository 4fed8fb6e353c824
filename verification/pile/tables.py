#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""tables.py DIR [NAME ...]: the tables of docs/pile.md from what measures.py --save DIR has kept, as Markdown."""
import argparse
import json
import math
import pathlib
import re
import statistics
import sys

ROW = 0.05  # of measures.stress_by_rows [m]


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def mean(values):
    return statistics.fmean(values) if values else math.nan


def stress_peaks(run):
    """For each blow: the largest cell mean [kPa]."""
    return [max(rows.values(), default=0.0) for rows in run["radial_stress_kPa"]]


def reach(run, level):
    """For each blow: how far below the tip cells carry more than this level [m]."""
    return [max([(int(row) + 0.5) * ROW for row, stress in rows.items() if stress > level], default=0.0)
            for rows in run["radial_stress_kPa"]]


def report_runs(runs):
    rows = []
    for run in runs:
        peak, e, rate = run["peak_reaction_kN"], run["energies_J"], run["particle_steps_per_s"]
        wall = run["steps"] * run["particles"] / rate if rate else math.nan
        rows.append([run["name"], f"{run['self_weight_m']:.3f}", str(len(run["sets_m"])), f"{1e3 * mean(run['sets_m']):.1f}",
                     f"{run['depth_m']:.3f}", f"{peak:.1f}", f"{100 * run['identity_kN'] / peak:.1e}",
                     f"{100 * run['impulse_share']:.0e}",
                     f"{100 * abs(e['residual']) / (e['hammer'] + e['weight']):.0e}", f"{run['steps']:.0f}", f"{rate:.2e}",
                     f"{wall:.0f}", f"{wall / run['simulated_s']:.0f}", "stopped early" if run["stopped"] else "end"])
    table(["run", "self-weight [m]", "blows", "mean set [mm]", "final depth [m]", "peak R [kN]", "identity [% of peak]",
           "impulse [%]", "energy residual [% of work]", "steps", "particle-steps/s", "wall time [s]", "s per simulated s",
           "reached"], rows)


def report_energies(runs):
    names = list(runs[0]["energies_J"])
    table(["energy [J]", *names],
          [[run["name"]] + [f"{run['energies_J'][n]:.4g}" for n in names] for run in runs])


def report_claims(runs, by_name):
    rows = []
    for run in runs:
        fca = by_name.get(run["name"].split("_")[0] + "_fca", run)
        peaks, level = stress_peaks(run), 0.1 * max(stress_peaks(fca))
        rows.append([run["name"], f"{mean(peaks):.0f}", f"{max(peaks):.0f}",
                     f"{mean(reach(run, level)):.2f} ({level:.0f} kPa)", f"{1e3 * mean(run['rebounds_m']):.2f}",
                     f"{1e3 * run['shaft_gap_m']:.1f}", f"{1e3 * run['shaft_gap_to_any_m']:.1f}",
                     f"{1e3 * mean(run['tip_gaps_m']):.1f}", f"{run['flattening']:.2f}", f"{run['denser_D']:.2f}",
                     f"{run['looser_D']:.2f}", f"{run['parts_percent'].get('contact', math.nan):.0f}",
                     str(run["line_elements"])])
    table(["run", "P1 sigma_rr, mean of blows [kPa]", "largest", "reach below tip [m]", "P2 rebound [mm]",
           "P3 gap at shaft, median [mm]", "to any particle", "at the tip, mean of peaks", "P4 last/first sets", "P5 denser [D]",
           "looser at tip [D]", "P6 contact [% of time]", "line elements"], rows)


def report_sets(runs):
    """Mean set of the blows that began in each band of depth [mm]."""
    bands = [0.25 * i for i in range(6)]
    rows = []
    for run in runs:
        begins = [run["self_weight_m"]]
        for one in run["sets_m"]:
            begins.append(begins[-1] + one)
        pairs = list(zip(begins, run["sets_m"]))
        means = [mean([one for begin, one in pairs if low <= begin < low + 0.25]) for low in bands]
        rows.append([run["name"], *("" if math.isnan(m) else f"{1e3 * m:.0f}" for m in means)])
    table(["P4 mean set [mm] from", *(f"{low:.2f} m" for low in bands)], rows)


def report_sensitivity(runs, reference):
    """What five blows do, beside those of the reference."""
    base_own, base_driven = reference["self_weight_m"], sum(reference["sets_m"][:5])
    rows = []
    for run in [reference, *runs]:
        if len(run["sets_m"]) < 5:
            continue
        own, driven = run["self_weight_m"], sum(run["sets_m"][:5])
        rows.append([run["name"], f"{own:.3f}", f"{1e3 * driven:.0f}", f"{100 * (driven / base_driven - 1):+.0f}",
                     f"{100 * ((own + driven) / (base_own + base_driven) - 1):+.0f}",
                     f"{1e3 * mean(run['rebounds_m'][:5]):.2f}", f"{max(run['reactions_kN'][:5]):.0f}",
                     f"{mean(stress_peaks(run)[:5]):.0f}", f"{1e3 * mean(run['tip_gaps_m'][:5]):.1f}"])
    table(["run", "self-weight [m]", "five blows [mm]", "change [%]", "of the depth [%]", "rebound [mm]", "peak R [kN]",
           "sigma_rr, mean of blows [kPa]", "gap at the tip [mm]"], rows)


def report(runs):
    by_name = {run["name"]: run for run in runs}
    compared = [run for run in runs if re.fullmatch(r"(dense|loose)_(gca|fca|pca)(_gated|_smooth)?", run["name"])]
    report_runs(runs)
    report_energies(runs)
    if compared:
        report_claims(compared, by_name)
        report_sets(compared)
    if "dense_gca" in by_name:  # every run in dense sand by its first five blows
        reference = by_name["dense_gca"]
        others = [run for run in compared if run["name"].startswith("dense") and run is not reference]
        report_sensitivity(others + [run for run in runs if run not in compared], reference)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("saved", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    names = options.names or sorted(p.stem for p in options.saved.glob("*.json"))
    try:
        if not names:
            raise OSError(f"{options.saved}: nothing saved")
        report([json.loads((options.saved / f"{name}.json").read_text()) for name in names])
    except (OSError, json.JSONDecodeError) as problem:
        sys.exit(f"tables.py: {problem}")


if __name__ == "__main__":
    main()
