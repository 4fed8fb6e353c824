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


def with_error(values, digits):
    """Mean and its standard error, of those that are numbers."""
    values = [value for value in values if not math.isnan(value)]
    if len(values) < 2:
        return f"{mean(values):.{digits}f}"
    return f"{mean(values):.{digits}f} ± {statistics.stdev(values) / math.sqrt(len(values)):.{digits}f}"


def in_mm(values):
    return [1e3 * value for value in values]


def stress_peaks(run, below=-math.inf):
    """For each blow: the largest cell mean [kPa], of all or from so far below the tip on [m]."""
    return [max((stress for row, stress in rows.items() if int(row) * ROW > below - 1e-9), default=0.0)
            for rows in run["radial_stress_kPa"]]


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
                     f"{sum(run['sets_m']):.3f}", f"{run['depth_m']:.3f}", f"{peak:.1f}", f"{100 * run['identity_kN'] / peak:.1e}",
                     f"{100 * run['impulse_share']:.0e}",
                     f"{100 * abs(e['residual']) / (e['hammer'] + e['weight']):.0e}", f"{run['steps']:.0f}", f"{rate:.2e}",
                     f"{wall:.0f}", f"{wall / run['simulated_s']:.0f}", "stopped early" if run["stopped"] else "end"])
    table(["run", "self-weight [m]", "blows", "mean set [mm]", "driven [m]", "final depth [m]", "peak R [kN]", "identity [% of peak]",
           "impulse [%]", "energy residual [% of work]", "steps", "particle-steps/s", "wall time [s]", "s per simulated s",
           "reached"], rows)


def report_energies(runs):
    names = list(runs[0]["energies_J"])
    table(["energy [J]", *names],
          [[run["name"]] + [f"{run['energies_J'][n]:.4g}" for n in names] for run in runs])


def report_rest(runs):
    table(["run", "at rest after self-weight [s]", "after a blow at the latest [s]", "fastest when the next begins [m/s]",
           "R of a blow, smallest [kN]", "weight [kN]"],
          [[run["name"], f"{run['rest_s']:.2f}", f"{run['rest_after_blow_s']:.2f}", f"{run['speed_at_blows']:.3f}",
            f"{min(run['lowest_reactions_kN']):.1f} to {max(run['lowest_reactions_kN']):.1f}",
            f"{run['weight_kN']:.1f}"] for run in runs if run["sets_m"]])


# Of each blow: what, digits, values.
CLAIMS = [("P1 sigma_rr [kPa]", 0, stress_peaks),
          ("from 0.1 m below the tip on", 0, lambda run: stress_peaks(run, 0.1)),
          ("from 0.2 m on", 0, lambda run: stress_peaks(run, 0.2)),
          ("P2 rebound [mm]", 2, lambda run: in_mm(run["rebounds_m"])),
          ("P3 gap at the shaft [mm]", 1, lambda run: in_mm(run["shaft_gaps_m"])),
          ("at the tip [mm]", 1, lambda run: in_mm(run["tip_gaps_m"]))]


def report_claims(runs, by_name):
    rows, differences, others = [], [], []
    for run in runs:
        fca = by_name.get(run["name"].split("_")[0] + "_fca", run)
        level = 0.1 * max(stress_peaks(fca))
        rows.append([run["name"], *(with_error(values(run), digits) for _, digits, values in CLAIMS)])
        if "_gca" in run["name"]:
            fca = by_name.get(run["name"].replace("_gca", "_fca"))
            if fca:
                differences.append([f"{fca['name']} less {run['name']}",
                                    *(with_error([f - g for f, g in zip(values(fca), values(run))], digits)
                                      for _, digits, values in CLAIMS)])
        others.append([run["name"], f"{max(stress_peaks(run)):.0f}", f"{mean(reach(run, level)):.2f} ({level:.0f} kPa)",
                       f"{run['inside_pile']} ({run['inside_pile_loaded']})", f"{1e3 * run['inside_pile_m']:.0f}",
                       f"{run['flattening']:.2f}", f"{run['denser_D']:.1f}", f"{run['looser_D']:.1f}",
                       f"{run['parts_percent'].get('contact', math.nan):.0f}", str(run["line_vertices"])])
    table(["single runs: mean of the blows, standard error between them", *(what for what, _, _ in CLAIMS)], rows)
    if differences:
        table(["blow by blow", *(what for what, _, _ in CLAIMS)], differences)
    table(["run", "P1 largest [kPa]", "reach below tip [m]", "sand inside the pile (loaded)", "deepest [mm]",
           "P4 last/first sets", "P5 denser [D]", "looser at tip [D]", "contact [% of time]", "vertices of lines"], others)


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
                     with_error(stress_peaks(run)[:5], 0), with_error(stress_peaks(run, 0.2)[:5], 0),
                     with_error(in_mm(run["tip_gaps_m"][:5]), 1), f"{run['looser_D']:.2f}"])
    table(["run", "self-weight [m]", "five blows [mm]", "change [%]", "of the depth [%]", "rebound [mm]", "peak R [kN]",
           "sigma_rr [kPa]", "from 0.2 m below the tip on", "gap at the tip [mm]",
           "at the end looser at tip [D]"], rows)


def report(runs):
    by_name = {run["name"]: run for run in runs}
    compared = [run for run in runs if re.fullmatch(r"(dense|loose)_(gca|fca|pca)(_gated|_smooth)?", run["name"])]
    report_runs(runs)
    report_energies(runs)
    if compared:
        report_rest(compared)
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
