#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""measures.py RESULTS [NAME ...]: what the runs of verification/pile show, as Markdown; no names: all that are there.
Per run: sets, momentum identity, energy balance, cost; and the measures of the claims P1 ... P6 of docs/pile.md."""
import argparse
import math
import pathlib
import re
import statistics
import sys

from results import Run, Unusable

GRAVITY = 9.81  # [m/s2]
RADIUS, DIAMETER = 0.15, 0.3  # of the pile [m]
CELL = 0.034125  # the smallest one [m]
PEAK = 0.05  # of a blow, after its begin [s]
BIN = 0.05  # edge of the squares that stresses and void ratios are averaged over [m]
SURFACE, EMBEDDED = 0.0, -0.5  # levels of the sand and of the tip at the start [m]
CARRIES = 1.0  # stress of sand that supports a shaft, a tenth of that at rest in its middle [kPa]
VOID_RATIO_CHANGE = 0.01  # that counts as densified or dilated


# ---- history

def sets(history):
    """Penetration by self-weight and by each blow, and the rebound within each [m]."""
    depth = history["depth"]
    own, each, rebound = depth[history.drive()], [], []
    for first, last in history.blows():
        deepest, back = depth[first], 0.0
        for i in range(first, last + 1):
            deepest = max(deepest, depth[i])
            back = max(back, deepest - depth[i])
        each.append(depth[last] - depth[first])
        rebound.append(back)
    return own, each, rebound


def momentum_identity(history):
    """R - (F_hammer + W - m a) of rows, which are means over a millisecond: its largest size in the drive and the peak
    of R [kN], and the same for the impulses from the begin of the drive to each row, as a share of R's."""
    t, v = history["t"], history["velocity"]
    weight, worst, peak = history.mass * GRAVITY / 1e3, 0.0, 0.0
    impulse, lost, drift = 0.0, 0.0, 0.0
    for i in range(max(1, history.drive()), len(history)):
        dt = t[i] - t[i - 1]
        if dt <= 0.0:
            continue
        reaction = history["tip_force"][i] + history["shaft_force"][i]
        wanted = history["hammer_force"][i] + weight - history.mass * (v[i] - v[i - 1]) / dt / 1e3
        worst, peak = max(worst, abs(reaction - wanted)), max(peak, reaction)
        impulse += reaction * dt
        lost += (reaction - wanted) * dt
        drift = max(drift, abs(lost))
    return worst, peak, drift / impulse if impulse > 0.0 else math.nan


def energies(history):
    """Terms of the balance at the end [J], each as it was summed up by the run."""
    last = {name: values[-1] for name, values in history.columns.items()}
    weight = last["external_work"] - last["traction_work"]
    pile = last["driven_stored_energy"] - history["driven_stored_energy"][0]
    return {"hammer": last["traction_work"], "weight": weight, "kinetic": last["kinetic_energy"],
            "pile": pile, "sand": last["stored_energy"] - pile, "contact": last["contact_loss"],
            "damping": last["damping_loss"], "transfer": last["transfer_loss"],
            "residual": last["energy_residual"]}


def flattening(each):
    """Mean set of the last quarter of the blows over that of the first: 1 is a straight line."""
    quarter = max(1, len(each) // 4)
    return statistics.fmean(each[-quarter:]) / statistics.fmean(each[:quarter]) if each else math.nan


# ---- frames

def cell_means(frame, values):
    """{(i, j): (mean, centre r, centre z)} over squares, weighted with the volume of the rings."""
    sums = {}
    for (r, z), area, value in zip(frame.centres(), frame.areas(), values):
        at = (math.floor(r / BIN), math.floor(z / BIN))
        weight = area * r
        old = sums.get(at, (0.0, 0.0))
        sums[at] = (old[0] + weight, old[1] + weight * value)
    return {at: (s / w, (at[0] + 0.5) * BIN, (at[1] + 0.5) * BIN) for at, (w, s) in sums.items() if w > 0.0}


def level_of_tip(run, index):
    return min(z for q in run.frame(index, "pile").corners for _, z in q)


def peak_frames(run):
    t = run.history["t"]
    return [run.frame_near(t[first] + PEAK) for first, _ in run.history.blows()]


def radial_stress(run, index):
    """Cell means of -sigma_rr beyond that of the start [kPa], and the level of the tip [m]."""
    now, start = run.frame(index), run.frame(0)
    beyond = [a - b for a, b in zip(start["stress_rr"], now["stress_rr"])]
    return cell_means(now, beyond), level_of_tip(run, index)


def stress_peaks(run):
    """For each blow: the largest cell mean [kPa]."""
    out = []
    for index in peak_frames(run):
        cells, _ = radial_stress(run, index)
        out.append(max(s for s, _, _ in cells.values()))
        run.forget()
    return out


def reach_of_stress(run, level):
    """For each blow: how far below the tip cells carry more than this level [m]."""
    out = []
    for index in peak_frames(run):
        cells, tip = radial_stress(run, index)
        out.append(max([tip - z for s, _, z in cells.values() if s > level], default=0.0))
        run.forget()
    return out


def carrying(frame):
    """Particles with stress: not those that lie loose in a gap."""
    return [q for q, s_rr, s_zz in zip(frame.corners, frame["stress_rr"], frame["stress_zz"])
            if s_rr < -CARRIES and s_zz < -CARRIES]


def shaft_gaps(run, index, all_sand=False):
    """Between shaft and sand in strips of a cell's height, from a cell above the tip to where it stood at the start [m];
    to the sand that carries stress, or to any."""
    pile, sand = run.frame(index, "pile"), run.frame(index)
    tip = level_of_tip(run, index)
    count = max(0, int((EMBEDDED - tip - CELL) / CELL))
    outer, inner = [-math.inf] * count, [math.inf] * count
    for quads, best, pick in ((pile.corners, outer, max), (sand.corners if all_sand else carrying(sand), inner, min)):
        for q in quads:
            low, high = min(z for _, z in q), max(z for _, z in q)
            edge = pick(r for r, _ in q)
            for k in range(max(0, math.ceil((low - tip - CELL) / CELL - 0.5)),
                           min(count, math.floor((high - tip - CELL) / CELL - 0.5) + 1)):
                best[k] = pick(best[k], edge)
    return [b - a for a, b in zip(outer, inner) if math.isfinite(a) and math.isfinite(b)]


def tip_gap(run, index):
    """Mean distance from the tip down to the sand that carries stress over the pile's radius [m]."""
    tip, count = level_of_tip(run, index), int(RADIUS / (0.5 * CELL))
    top = [-math.inf] * count
    for q in carrying(run.frame(index)):
        left, right = min(r for r, _ in q), max(r for r, _ in q)
        for k in range(count):
            if left <= (k + 0.5) * 0.5 * CELL <= right:
                top[k] = max(top[k], min(tip, max(z for _, z in q)))
    return statistics.fmean(tip - z for z in top)


def void_ratio_extents(run, change=VOID_RATIO_CHANGE):
    """In diameters: from the shaft outwards as far as mean Delta e, over the embedded length but a diameter at both
    ends, is below -change; and below and beside the tip the farthest cell with Delta e above change."""
    index = len(run.files) - 1
    now, start, tip = run.frame(index), run.frame(0), level_of_tip(run, index)
    cells = cell_means(now, [a - b for a, b in zip(now["void_ratio"], start["void_ratio"])])
    low, high = tip + DIAMETER, SURFACE - DIAMETER
    columns = {}
    for mean, r, z in cells.values():
        if r > RADIUS and low < z < high:
            columns.setdefault(r, []).append(mean)
    dense = 0.0
    for r in sorted(columns):
        if statistics.fmean(columns[r]) > -change:
            if dense > 0.0 or r > 2.0 * DIAMETER:
                break
            continue  # the sheared sand at the shaft
        dense = (r + 0.5 * BIN - RADIUS) / DIAMETER
    beside = [math.hypot(max(0.0, r - RADIUS), tip - z) for mean, r, z in cells.values()
              if mean > change and abs(z - tip) < DIAMETER and r < RADIUS + 2.0 * DIAMETER]
    run.forget()
    return dense, max(beside, default=0.0) / DIAMETER


# ---- tables

def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def mean(values):
    return statistics.fmean(values) if values else math.nan


def report_runs(runs):
    rows = []
    for run in runs:
        h = run.history
        own, each, rebound = sets(h)
        worst, peak, drift = momentum_identity(h)
        e = energies(h)
        rate, parts = run.cost()
        rows.append([run.name, f"{own:.3f}", str(len(each)), f"{1e3 * mean(each):.1f}", f"{h['depth'][-1]:.3f}",
                     f"{peak:.1f}", f"{100 * worst / peak:.1e}", f"{100 * drift:.0e}",
                     f"{100 * abs(e['residual']) / (e['hammer'] + e['weight']):.0e}",
                     f"{h['step'][-1]:.0f}", f"{rate:.2e}", f"{h['step'][-1] * h.particles / rate / h['t'][-1] if rate else math.nan:.0f}",
                     "stopped early" if h.stopped else "end"])
    table(["run", "self-weight [m]", "blows", "mean set [mm]", "final depth [m]", "peak R [kN]", "identity [% of peak]",
           "impulse [%]", "energy residual [% of work]", "steps", "particle-steps/s", "s per simulated s", "reached"], rows)


def report_sensitivity(runs, reference):
    """What five blows do, beside those of the reference."""
    def row(run):
        own, each, rebound = sets(run.history)
        peak = max((run.history["tip_force"][i] + run.history["shaft_force"][i]
                    for i in range(run.history.drive(), run.history.blows()[min(4, len(each) - 1)][1])), default=math.nan)
        return own, sum(each[:5]), mean(rebound[:5]), peak

    base = row(reference)
    rows = []
    for run in [reference, *runs]:
        if len(run.history.blows()) < 5:
            continue
        own, driven, back, peak = row(run)
        rows.append([run.name, f"{own:.3f}", f"{1e3 * driven:.0f}", f"{100 * (driven / base[1] - 1):+.0f}",
                     f"{100 * ((own + driven) / (base[0] + base[1]) - 1):+.0f}", f"{1e3 * back:.2f}", f"{peak:.0f}"])
    table(["run", "self-weight [m]", "five blows [mm]", "change [%]", "of the depth [%]", "rebound [mm]", "peak R [kN]"], rows)


def report_energies(runs):
    names = list(energies(runs[0].history))
    table(["energy [J]", *names],
          [[run.name] + [f"{energies(run.history)[n]:.4g}" for n in names] for run in runs])


def report_claims(runs):
    by_name = {run.name: run for run in runs}
    if not runs:
        return
    rows = []
    for run in runs:
        own, each, rebound = sets(run.history)
        sand = run.name.split("_")[0]
        fca = by_name.get(f"{sand}_fca", run)
        peaks = stress_peaks(run)
        level = 0.1 * max(stress_peaks(fca))
        reach = reach_of_stress(run, level)
        gaps, to_any = shaft_gaps(run, -1), shaft_gaps(run, -1, all_sand=True)
        tip_gaps = [tip_gap(run, index) for index in peak_frames(run)]
        dense, loose = void_ratio_extents(run)
        _, parts = run.cost()
        rows.append([run.name, f"{mean(peaks):.0f}", f"{max(peaks):.0f}", f"{mean(reach):.2f} ({level:.0f} kPa)",
                     f"{1e3 * mean(rebound):.2f}", *(f"{1e3 * statistics.median(g or [math.nan]):.1f}" for g in (gaps, to_any)),
                     f"{1e3 * mean(tip_gaps):.1f}", f"{flattening(each):.2f}", f"{dense:.2f}", f"{loose:.2f}",
                     f"{parts.get('contact', math.nan):.0f}", str(run.penalty_vertices())])
        run.forget()
    table(["run", "P1 sigma_rr, mean of blows [kPa]", "largest", "reach below tip [m]", "P2 rebound [mm]",
           "P3 gap at shaft, median [mm]", "to any particle", "at the tip, mean of peaks", "P4 last/first sets", "P5 denser [D]", "looser at tip [D]",
           "P6 contact [% of time]", "line elements"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    names = options.names or sorted(p.stem for p in options.results.glob("*.csv"))
    try:
        runs = [Run(options.results, name) for name in names]
        if not runs:
            raise Unusable(f"{options.results}: no results")
        report_runs(runs)
        report_energies(runs)
        compared = [run for run in runs if re.fullmatch(r"(dense|loose)_(gca|fca|pca)(_gated)?", run.name)]
        report_claims(compared)
        reference = next((run for run in compared if run.name == "dense_gca"), None)
        if reference:
            report_sensitivity([run for run in runs if run not in compared], reference)
    except Unusable as problem:
        sys.exit(f"measures.py: {problem}")


if __name__ == "__main__":
    main()
