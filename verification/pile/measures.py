#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""measures.py RESULTS [NAME ...] [--save DIR]: what the runs of verification/pile show, as Markdown; no names: all that
are there but members of ensembles. Per run: sets, momentum identity, energy balance, cost, and the measures of the claims P1 ... P6 of
docs/pile.md. --save keeps them as DIR/NAME.json, some kilobytes where a run leaves a hundred megabytes; tables.py prints
the tables from these. --ensemble GROUP: of the members of a group of ensemble.py instead, a row for each and a row for
each of their blows, as DIR/GROUP.csv and DIR/GROUP_blows.csv, which ensemble_tables.py reads; rows that are there of other members
stay."""
import argparse
import csv
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys

import tables
from results import RINGS, Run, Unusable, rings
from whole_file import whole_file

GRAVITY = 9.81  # [m/s2]
RADIUS, DIAMETER = 0.15, 0.3  # of the pile [m]
STRIP = 0.034125  # height of the strips that gaps are taken in: a cell of the base case [m]
PEAK = 0.05  # of a blow, after its begin [s]
BIN = tables.ROW  # edge of the squares that stresses and void ratios are averaged over [m]
CARRIES = 1.0  # stress of sand that supports a shaft, a tenth of that at rest in its middle [kPa]
RESTS = 0.03  # a pile no faster is at rest [m/s]
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


def rests(history):
    """When the pile has come to rest for good in the stage of self-weight; how long after the begin of a blow it does at
    the latest [s]; and how fast it is when the next one begins at most [m/s]."""
    def after(first, last):
        moving = [i for i in range(first, last) if abs(history["velocity"][i]) > RESTS]
        return history["t"][max(moving, default=first)] - history["t"][first]
    blows = history.blows()
    return (after(0, history.drive()), max((after(*blow) for blow in blows), default=math.nan),
            max((abs(history["velocity"][last]) for _, last in blows), default=math.nan))


def reactions(history):
    """Of each blow, the largest ones and the smallest ones [kN]."""
    total = [tip + shaft for tip, shaft in zip(history["tip_force"], history["shaft_force"])]
    blows = [total[first:last + 1] for first, last in history.blows()]
    return [max(blow) for blow in blows], [min(blow) for blow in blows]


def momentum_identity(history):
    """R - (F_hammer + W - D - m a) of rows, means over a millisecond, D of local damping: its largest size in the drive
    and the peak of R [kN], and the same for impulses from the begin of the drive to each row, as a share of R's."""
    t, v = history["t"], history["velocity"]
    damping = history.columns.get("damping_force", [0.0] * len(history))  # older runs tell none
    weight, worst, peak = history.mass * GRAVITY / 1e3, 0.0, 0.0
    impulse, lost, drift = 0.0, 0.0, 0.0
    for i in range(max(1, history.drive()), len(history)):
        dt = t[i] - t[i - 1]
        if dt <= 0.0:
            continue
        reaction = history["tip_force"][i] + history["shaft_force"][i]
        wanted = history["hammer_force"][i] + weight - damping[i] - history.mass * (v[i] - v[i - 1]) / dt / 1e3
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


def after_hammer(history):
    """Of each blow, from the end of the hammer's force to that of the blow: how far the pile goes down until it stops, back
    up until it stops again, and how much deeper it is at the end of the blow than there [m]; its kinetic energy where the
    force ends, and what R - W takes until it stops [J]; its momentum where the force ends over the hammer's impulse; and the
    smallest R [kN]."""
    out = []
    for first, last in history.blows():
        if math.isnan(history.mass):
            raise Unusable("a rigid pile, which has no mass, stops at no depth of its own")
        # Forces are means since the row before: that of the first row may still be of the stage before.
        end = next((i for i in range(first + 2, last + 1) if history["hammer_force"][i] <= 0.0), last + 1) - 1
        impulse = sum(1e3 * history["hammer_force"][i] * (history["t"][i] - history["t"][i - 1]) for i in range(first + 1, end + 1))
        depth, speed = history["depth"], history["velocity"][end]
        stop = next((i for i in range(end, last + 1) if history["velocity"][i] <= 0.0), last)
        back = next((i for i in range(stop, last + 1) if history["velocity"][i] > 0.0), last)
        reaction = [tip + shaft for tip, shaft in zip(history["tip_force"][end:last + 1], history["shaft_force"][end:last + 1])]
        resisted = sum((1e3 * reaction[i - end] - history.mass * GRAVITY) * (depth[i] - depth[i - 1])
                       for i in range(end + 1, stop + 1))
        out.append((depth[stop] - depth[end], depth[stop] - depth[back], depth[last] - depth[back],
                    0.5 * history.mass * speed**2, resisted, history.mass * speed / impulse, min(reaction)))
    return out


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


def shaft_gaps(run, index):
    """Between shaft and sand that carries stress, in strips from one above the tip to where it was at the start [m]."""
    pile, tip = run.frame(index, "pile"), level_of_tip(run, index)
    count = max(0, int((level_of_tip(run, 0) - tip) / STRIP) - 1)
    outer, inner = [-math.inf] * count, [math.inf] * count
    for quads, best, pick in ((pile.corners, outer, max), (carrying(run.frame(index)), inner, min)):
        for q in quads:
            low, high = min(z for _, z in q), max(z for _, z in q)
            edge = pick(r for r, _ in q)
            for k in range(max(0, math.ceil((low - tip) / STRIP - 1.5)),
                           min(count, math.floor((high - tip) / STRIP - 1.5) + 1)):
                best[k] = pick(best[k], edge)
    return [b - a for a, b in zip(outer, inner) if math.isfinite(a) and math.isfinite(b)]


def at_ends(run):
    """Median gap at the shaft in the last frame of each blow [m]; NaN: none after its peak, or no strip yet."""
    out, t = [], run.history["t"]
    for first, last in run.history.blows():
        index = max(i for i, time in enumerate(run.times) if time <= t[last] + 1e-9)
        gaps = shaft_gaps(run, index) if run.times[index] > t[first] + PEAK + 1e-3 else []
        out.append(statistics.median(gaps or [math.nan]))
        run.forget(index)
    return out


def intruders(run, index):
    """Sand particles whose centres are in the pile: how many, how many of these carry stress, and how deep they are [m]."""
    sand, tip = run.frame(index), level_of_tip(run, index)
    deep = [min(RADIUS - r, z - tip) if r < RADIUS and z > tip else 0.0 for r, z in sand.centres()]
    loaded = sum(d > 0.0 and s < -CARRIES for d, s in zip(deep, sand["stress_zz"]))
    return sum(d > 0.0 for d in deep), loaded, max(deep)


def tip_gap(run, index):
    """Mean distance from a flat tip down to the sand that carries stress over the pile's radius [m]."""
    tip, count = level_of_tip(run, index), int(RADIUS / (0.5 * STRIP))
    top = [-math.inf] * count
    for q in carrying(run.frame(index)):
        left, right = min(r for r, _ in q), max(r for r, _ in q)
        for k in range(count):
            if left <= (k + 0.5) * 0.5 * STRIP <= right:
                top[k] = max(top[k], min(tip, max(z for _, z in q)))
    return statistics.fmean(tip - z for z in top)


def at_peaks(run):
    """stress_by_rows of each blow, and tip_gap if the tip is flat."""
    lowest = level_of_tip(run, 0) + 1e-6
    flat = max(r for q in run.frame(0, "pile").corners for r, z in q if z < lowest) > 0.9 * RADIUS
    stresses, gaps = [], []
    for index in peak_frames(run):
        stresses.append(stress_by_rows(run, index))
        if flat:
            gaps.append(tip_gap(run, index))
        run.forget(index)
    return stresses, gaps


def void_ratio_extents(run, change=VOID_RATIO_CHANGE):
    """In diameters, at the end: from the shaft outwards as far as the mean Delta e over the lower half of the embedded
    length, but a diameter at the tip, is below -change; and from the tip down and sideways as far as the mean Delta e of
    the sand that carries stress below its level is above change, in shells of BIN."""
    now, start, tip = run.frame(-1), run.frame(0), level_of_tip(run, -1)
    changes = [a - b for a, b in zip(now["void_ratio"], start["void_ratio"])]
    columns = {}
    for mean, r, z in cell_means(now, changes).values():
        if r > RADIUS and tip + DIAMETER < z < 0.5 * tip:
            columns.setdefault(r, []).append(mean)
    dense = 0.0
    for r in sorted(columns):
        if statistics.fmean(columns[r]) > -change:
            if dense > 0.0 or r > 2.0 * DIAMETER:
                break
            continue  # the sheared sand at the shaft
        dense = (r + 0.5 * BIN - RADIUS) / DIAMETER
    shells = {}
    for (r, z), area, value, s_zz in zip(now.centres(), now.areas(), changes, now["stress_zz"]):
        if z < tip and s_zz < -CARRIES:
            shell = shells.setdefault(int(math.hypot(max(0.0, r - RADIUS), tip - z) / BIN), [0.0, 0.0])
            shell[0] += area * r
            shell[1] += area * r * value
    loose = 0
    while loose in shells and shells[loose][1] > change * shells[loose][0]:
        loose += 1
    return dense, loose * BIN / DIAMETER


# ---- members of an ensemble

CHANGES = (0.003, 0.01, 0.02, 0.04)  # of void ratio that extents are taken at


def beside(run, index):
    """Rings of the sand beside the shaft that the tip has passed, but half a diameter above it, and the mean level [m]; ()
    where that is less than a quarter of a diameter high."""
    low, high = level_of_tip(run, index) + 0.5 * DIAMETER, level_of_tip(run, 0)
    return (rings(run.frame(index), RADIUS, low, high), 0.5 * (low + high)) if high - low > 0.25 * DIAMETER else ()


def largest_stress(run, index):
    """The largest cell mean of -sigma_rr beyond that of the start [kPa]; the centre of its square, from the axis and below
    the tip [m]; how many particles have their centres in it; and the mean -sigma_rr and -sigma_zz of the sand below the tip,
    a third of a diameter high [kPa]."""
    cells, tip = radial_stress(run, index)
    at, (stress, r, z) = max(cells.items(), key=lambda item: item[1][0])
    frame = run.frame(index)
    places = frame.centres()
    count = sum((math.floor(x / BIN), math.floor(y / BIN)) == at for x, y in places)
    below = [i for i, (x, y) in enumerate(places) if x < RADIUS and tip - DIAMETER / 3 <= y < tip]
    areas = frame.areas()
    weights = [areas[i] * places[i][0] for i in below]
    disc = [-sum(w * frame[name][i] for w, i in zip(weights, below)) / sum(weights) for name in ("stress_rr", "stress_zz")]
    return stress, r, tip - z, count, *disc


def by_blow(run):
    """A row of numbers for each blow of a run, by column."""
    h, t = run.history, run.history["t"]
    total = [tip + shaft for tip, shaft in zip(h["tip_force"], h["shaft_force"])]
    _, each, rebound = sets(h)
    peaks, blows, after = peak_frames(run), h.blows(), after_hammer(h)
    for k, (first, last) in enumerate(blows):
        top = max(range(first, last + 1), key=lambda i: total[i])
        stress = [max((s for row, s in stress_by_rows(run, peaks[k]).items() if row * BIN > below - 1e-9), default=0.0)
                  for below in (-math.inf, 0.1, 0.2)]
        _, r, below, count, disc_rr, disc_zz = largest_stress(run, peaks[k])
        row = {"blow": k + 1, "from_m": h["depth"][first], "set_m": each[k], "rebound_m": rebound[k],
               "stress_kPa": stress[0], "stress_0.1_m_kPa": stress[1], "stress_0.2_m_kPa": stress[2],
               "largest_r_m": r, "largest_below_m": below, "largest_particles": count, "disc_rr_kPa": disc_rr,
               "disc_zz_kPa": disc_zz,
               "tip_kN": h["tip_force"][top], "shaft_kN": h["shaft_force"][top],
               **dict(zip(("on_m", "back_m", "again_m", "kinetic_J", "resisted_J", "momentum_share", "least_kN"), after[k]))}
        run.forget(peaks[k])
        rest = max(i for i, time in enumerate(run.times) if time <= t[last] + 1e-9)
        found = beside(run, rest) if run.times[rest] > t[first] + PEAK + 1e-3 else ()
        for ring in range(len(RINGS)):
            for i, what in enumerate(("stress_kPa", "void_ratio", "free_share")):
                row[f"ring_{ring + 1}_{what}"] = found[0][ring][i] if found else math.nan
        row["ring_level_m"] = found[1] if found else math.nan
        run.forget(rest)
        yield row


def at_end(run):
    """What a run ends with, by column."""
    h = run.history
    own, each, _ = sets(h)
    rest, rest_after_blow, speed = rests(h)
    worst, peak, _ = momentum_identity(h)
    e = energies(h)
    row = {"self_weight_m": own, "blows": len(each), "driven_m": sum(each), "rest_s": rest, "rest_after_blow_s": rest_after_blow,
           "speed_at_blows": speed, "identity_share": worst / peak, "energy_share": e["residual"] / (e["hammer"] + e["weight"])}
    for change in CHANGES:
        row[f"denser_{change:g}_D"], row[f"looser_{change:g}_D"] = void_ratio_extents(run, change)
    row["inside_pile"], row["inside_pile_loaded"], _ = intruders(run, -1)
    run.forget()
    return row


def write_rows(target, rows):
    """Rows of members; those of others that are there stay."""
    members = {(row["case"], str(row["member"])) for row in rows}
    if target.exists():
        with target.open(newline="") as file:
            table = csv.DictReader(file)
            if table.fieldnames != list(rows[0]):
                raise Unusable(f"{target}: columns of another version")
            rows = [row for row in table if (row["case"], row["member"]) not in members] + rows
    rows.sort(key=lambda row: (row["case"], int(row["member"])))  # blows stay in their order
    with whole_file(target) as path, path.open("w", newline="") as file:
        table = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        table.writeheader()
        table.writerows({key: f"{value:.5g}" if isinstance(value, float) else value for key, value in row.items()} for row in rows)


def ensemble(folder, group, to):
    """group.csv and group_blows.csv of all members in folder that are done."""
    pattern = re.compile(re.escape(group) + r"_.+-\d+")
    names = sorted(p.stem for p in folder.glob(f"{group}_*.csv")
                   if pattern.fullmatch(p.stem) and not p.with_suffix(".checkpoint").exists())
    if not names:
        raise Unusable(f"{folder}: no member of {group} is done")
    ends, blows = [], []
    for name in names:
        run = Run(folder, name)
        case, member = name.rsplit("-", 1)
        head = {"case": case.removeprefix(group + "_"), "member": int(member)}
        blows += [head | row for row in by_blow(run)]
        ends.append(head | at_end(run))
    to.mkdir(parents=True, exist_ok=True)
    write_rows(to / f"{group}.csv", ends)
    write_rows(to / f"{group}_blows.csv", blows)


# ---- all of a run

def measured(run):
    """What tables.py needs of a run."""
    h = run.history
    own, each, rebound = sets(h)
    worst, peak, drift = momentum_identity(h)
    rate, parts = run.cost()
    rest, rest_after_blow, speed = rests(h)
    highest, lowest = reactions(h)
    inside, loaded, deepest = intruders(run, -1)
    dense, loose = void_ratio_extents(run)
    run.forget()
    gaps = at_ends(run)
    stresses, tip_gaps = at_peaks(run)
    out = {
        "name": run.name, "program": next((c.split(",")[0] for c in h.comments if c.startswith("Grit ")), ""),
        "stopped": h.stopped, "particles": h.particles, "steps": h["step"][-1], "simulated_s": h["t"][-1],
        "depth_m": h["depth"][-1], "self_weight_m": own, "sets_m": each, "rebounds_m": rebound,
        "reactions_kN": highest, "lowest_reactions_kN": lowest,
        "weight_kN": h.mass * GRAVITY / 1e3, "rest_s": rest, "rest_after_blow_s": rest_after_blow, "speed_at_blows": speed,
        "peak_reaction_kN": peak, "identity_kN": worst, "impulse_share": drift, "energies_J": energies(h),
        "particle_steps_per_s": rate, "parts_percent": parts, "line_vertices": run.penalty_vertices(),
        "radial_stress_kPa": stresses, "shaft_gaps_m": gaps, "tip_gaps_m": tip_gaps,
        "inside_pile": inside, "inside_pile_loaded": loaded, "inside_pile_m": deepest,
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
    parser.add_argument("--ensemble", metavar="GROUP", help="of ensemble.py")
    options = parser.parse_args()
    if options.ensemble and not options.save:
        parser.error("--ensemble needs --save")
    names = options.names or sorted(p.stem for p in options.results.glob("*.csv")
                                    if not (p.with_suffix(".checkpoint").exists() or
                                            (options.results / "members" / f"{p.stem}.toml").exists()))
    try:
        if options.ensemble:
            ensemble(options.results, options.ensemble, options.save)
            return
        if not names:
            raise Unusable(f"{options.results}: no results")
        numbers = [measured(Run(options.results, name)) for name in names]
        if options.save:
            options.save.mkdir(parents=True, exist_ok=True)
            where = origin(pathlib.Path(__file__).parent)
            for run in numbers:
                run |= where | ({"commit": options.commit} if options.commit else {})
                with whole_file(options.save / f"{run['name']}.json") as path:
                    path.write_text(json.dumps(run) + "\n")
        tables.report(numbers)
    except Unusable as problem:
        sys.exit(f"measures.py: {problem}")


if __name__ == "__main__":
    main()
