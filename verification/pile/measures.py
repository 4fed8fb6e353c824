#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""measures.py RESULTS [NAME ...] [--save DIR]: what the runs of verification/pile show, as Markdown; no names: all that
are there. Per run: sets, momentum identity, energy balance, cost, and the measures of the claims P1 ... P6 of
docs/pile.md. --save keeps them as DIR/NAME.json, some kilobytes where a run leaves a hundred megabytes; tables.py prints
the tables from these."""
import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys

import tables
from results import Run, Unusable

GRAVITY = 9.81  # [m/s2]
RADIUS, DIAMETER = 0.15, 0.3  # of the pile [m]
CELL = 0.034125  # the smallest one [m]
PEAK = 0.05  # of a blow, after its begin [s]
BIN = tables.ROW  # edge of the squares that stresses and void ratios are averaged over [m]
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


def stress_by_rows(run, index):
    """{row: largest cell mean of the row [kPa]}, rows of BIN below the tip, negative above it."""
    cells, tip = radial_stress(run, index)
    rows = {}
    for stress, _, z in cells.values():
        row = math.floor((tip - z) / BIN)
        if stress >= 1.0:
            rows[row] = max(rows.get(row, 0.0), round(stress, 1))
    return rows


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


def at_peaks(run):
    """stress_by_rows and tip_gap of each blow."""
    stresses, gaps = [], []
    for index in peak_frames(run):
        stresses.append(stress_by_rows(run, index))
        gaps.append(tip_gap(run, index))
        run.forget(index)
    return stresses, gaps


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


# ---- all of a run

def measured(run):
    """What tables.py needs of a run."""
    h = run.history
    own, each, rebound = sets(h)
    worst, peak, drift = momentum_identity(h)
    rate, parts = run.cost()
    gaps, to_any = shaft_gaps(run, -1), shaft_gaps(run, -1, all_sand=True)
    reactions = [max(h["tip_force"][i] + h["shaft_force"][i] for i in range(first, last + 1)) for first, last in h.blows()]
    dense, loose = void_ratio_extents(run)
    stresses, tip_gaps = at_peaks(run)
    out = {
        "name": run.name, "program": next((c.split(",")[0] for c in h.comments if c.startswith("Grit ")), ""),
        "stopped": h.stopped, "particles": h.particles, "steps": h["step"][-1], "simulated_s": h["t"][-1],
        "depth_m": h["depth"][-1], "self_weight_m": own, "sets_m": each, "rebounds_m": rebound, "reactions_kN": reactions,
        "peak_reaction_kN": peak, "identity_kN": worst, "impulse_share": drift, "energies_J": energies(h),
        "particle_steps_per_s": rate, "parts_percent": parts, "line_elements": run.penalty_vertices(),
        "radial_stress_kPa": stresses,
        "shaft_gap_m": statistics.median(gaps or [math.nan]), "shaft_gap_to_any_m": statistics.median(to_any or [math.nan]),
        "tip_gaps_m": tip_gaps,
        "flattening": flattening(each), "denser_D": dense, "looser_D": loose,
    }
    run.forget()
    return out


def origin(root):
    """Commit of the sources and the machine."""
    commit = subprocess.run(["git", "-C", root, "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    models = [line.split(":")[1].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
              if line.startswith("model name")]
    return {"commit": commit, "machine": f"{models[0] if models else 'unknown'}, {os.cpu_count()} cores"}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--save", type=pathlib.Path, metavar="DIR")
    parser.add_argument("--commit", help="of the program, where the sources are not those it was built from")
    options = parser.parse_args()
    names = options.names or sorted(p.stem for p in options.results.glob("*.csv")
                                    if not p.with_suffix(".checkpoint").exists())
    try:
        if not names:
            raise Unusable(f"{options.results}: no results")
        numbers = [measured(Run(options.results, name)) for name in names]
        if options.save:
            options.save.mkdir(parents=True, exist_ok=True)
            where = origin(pathlib.Path(__file__).parent)
            for run in numbers:
                run |= where | ({"commit": options.commit} if options.commit else {})
                aside = options.save / f"{run['name']}.json.part"
                aside.write_text(json.dumps(run) + "\n")
                aside.rename(options.save / f"{run['name']}.json")
        tables.report(numbers)
    except Unusable as problem:
        sys.exit(f"measures.py: {problem}")


if __name__ == "__main__":
    main()
