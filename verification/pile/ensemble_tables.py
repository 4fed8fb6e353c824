#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""ensemble_tables.py DIR: the tables of docs/pile.md from the rows that measures.py --ensemble has left in DIR, as Markdown.

mean ± standard deviation between runs that differ by nothing that matters; a difference with its standard error, and
"no" where Student's t (Welch, 95 %) does not tell it from the scatter of the runs."""
import argparse
import csv
import math
import pathlib
import statistics
import sys

from ensemble import BASE, CONTACTS, SANDS
from measures import BIN, CHANGES, DIAMETER, GRAVITY, RADIUS
from results import K0, RINGS
from tables import table

# Two-sided 95 % of Student's t by degrees of freedom.
STUDENT = (math.inf, 12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31)
DEPTHS = {"dense": (0.15, 0.20, 0.25, 0.30), "loose": (0.30, 0.35, 0.40, 0.45, 0.50)}  # that sets are compared at [m]
NAMES = {"gca": "GCA", "fca": "FCA", "pca": "PCA", "surface": "surface"}
GRAIN_DENSITY = BASE["body"][1]["grain_density_kg_per_m3"]


def unit_weight(void_ratio):
    """[kN/m3]"""
    return GRAIN_DENSITY / (1.0 + void_ratio) * GRAVITY * 1e-3


def read(path):
    with path.open(newline="") as file:
        return [{key: value if key == "case" else float(value) for key, value in row.items()} for row in csv.DictReader(file)]


class Group:
    """Members of the cases of a group: a row for each, and rows of blows."""

    def __init__(self, folder, name):
        self.ends, self.blows = {}, {}
        for row in read(folder / f"{name}.csv"):
            self.ends.setdefault(row["case"], {})[row["member"]] = row
        for row in read(folder / f"{name}_blows.csv"):
            self.blows.setdefault(row["case"], {}).setdefault(row["member"], []).append(row)

    def count(self, case):
        return len(self.ends.get(case, ()))

    def end(self, case, column, factor=1.0):
        return [factor * row[column] for row in self.ends.get(case, {}).values()]

    def mean_of_blows(self, case, value, blows=None):
        """For each member the mean over its blows, or over those given; without what is missing."""
        out = []
        for rows in self.blows.get(case, {}).values():
            found = [value(row) for row in rows if blows is None or row["blow"] in blows]
            found = [x for x in found if not math.isnan(x)]
            if found:
                out.append(statistics.fmean(found))
        return out

    def set_at(self, case, depth, member=None):
        """For each member, or one, that passes it: the set of a blow that begins at this depth, between those that do below and
        above it [m]."""
        out = []
        for number, rows in self.blows.get(case, {}).items():
            if member is not None and number != member:
                continue
            for low, high in zip(rows, rows[1:]):
                if low["from_m"] <= depth < high["from_m"]:
                    share = (depth - low["from_m"]) / (high["from_m"] - low["from_m"])
                    out.append(low["set_m"] + share * (high["set_m"] - low["set_m"]))
                    break
        return out


def spread(values, digits):
    """Mean and standard deviation between runs."""
    if not values:
        return ""
    deviation = f" ± {statistics.stdev(values):.{digits}f}" if len(values) > 1 else ""
    return f"{statistics.fmean(values):.{digits}f}{deviation}"


def difference(a, b, digits):
    """a less b, its standard error, and whether it is one."""
    if len(a) < 2 or len(b) < 2:
        return ""
    of_a, of_b = (statistics.variance(x) / len(x) for x in (a, b))
    error = math.sqrt(of_a + of_b)
    freedom = (of_a + of_b)**2 / (of_a**2 / (len(a) - 1) + of_b**2 / (len(b) - 1)) if error > 0.0 else 1.0
    found = statistics.fmean(a) - statistics.fmean(b)
    real = abs(found) > STUDENT[min(int(freedom), len(STUDENT) - 1)] * error
    return f"{found:+.{digits}f} ± {error:.{digits}f}" + ("" if real else ", no")


def cases(group, wanted=None):
    return [f"{sand}_{contact}" for sand in SANDS for contact in CONTACTS
            if group.count(f"{sand}_{contact}") and sand in (wanted or SANDS)]


def title(case):
    sand, contact = case.rsplit("_", 1)
    return f"{sand.replace('_', ' ')}, {NAMES[contact]}"


def report_depths(group):
    table(["case", "runs", "self-weight [mm]", "driven by five blows [mm]", "largest speed when a blow begins [m/s]",
           "identity, at most", "energy residual, at most"],
          [[title(case), str(group.count(case)), spread(group.end(case, "self_weight_m", 1e3), 0),
            spread(group.end(case, "driven_m", 1e3), 0), f"{max(group.end(case, 'speed_at_blows')):.3f}",
            f"{max(group.end(case, 'identity_share')):.0e}",
            f"{max(abs(x) for x in group.end(case, 'energy_share')):.0e}"] for case in cases(group)])


# Of each blow: what, digits, value.
CLAIMS = (("P1 σ_rr [kPa]", 0, lambda row: row["stress_kPa"]),
          ("from 0.1 m below the tip on", 0, lambda row: row["stress_0.1_m_kPa"]),
          ("from 0.2 m on", 0, lambda row: row["stress_0.2_m_kPa"]),
          ("mean below the tip", 0, lambda row: row["disc_rr_kPa"]),
          ("P2 rebound [mm]", 2, lambda row: 1e3 * row["rebound_m"]),
          ("set [mm]", 1, lambda row: 1e3 * row["set_m"]))


def report_claims(group):
    table(["mean of five blows", *(what for what, _, _ in CLAIMS)],
          [[title(case), *(spread(group.mean_of_blows(case, value), digits) for _, digits, value in CLAIMS)]
           for case in cases(group)])
    rows = []
    for sand in SANDS:
        for a, b in (("fca", "gca"), ("pca", "gca"), ("surface", "gca"), ("surface", "pca")):
            if group.count(f"{sand}_{a}") > 1 and group.count(f"{sand}_{b}") > 1:
                rows.append([f"{sand}, {NAMES[a]} less {NAMES[b]}",
                             *(difference(group.mean_of_blows(f"{sand}_{a}", value), group.mean_of_blows(f"{sand}_{b}", value),
                                          digits) for _, digits, value in CLAIMS)])
    table(["difference, its standard error", *(what for what, _, _ in CLAIMS)], rows)


def report_sets(group):
    for sand in SANDS:
        found = cases(group, (sand,))
        if not found:
            continue
        depths = DEPTHS[sand]
        rows = [[title(case), *(spread([1e3 * x for x in group.set_at(case, depth)], 0) for depth in depths)] for case in found]
        if f"{sand}_gca" in found:
            for case in found:
                if not case.endswith("_gca"):
                    rows.append([f"{title(case)} less GCA",
                                 *(difference([1e3 * x for x in group.set_at(case, depth)],
                                              [1e3 * x for x in group.set_at(f"{sand}_gca", depth)], 1) for depth in depths)])
        table(["P4 set [mm] of a blow from", *(f"{depth:.2f} m" for depth in depths)], rows)
        first, last = depths[0], depths[2]
        ratios = {}
        for case in found:
            at_depths = [(group.set_at(case, first, member), group.set_at(case, last, member)) for member in group.blows[case]]
            ratios[case] = ([rows_[-1]["set_m"] / rows_[0]["set_m"] for rows_ in group.blows[case].values()],
                            [b[0] / a[0] for a, b in at_depths if a and b])
        table(["P4", "last set over the first", f"set at {last:.2f} m over that at {first:.2f} m"],
              [[title(case), *(spread(values, 2) for values in ratios[case])] for case in found] +
              [[f"{title(case)} less GCA", *(difference(a, b, 2) for a, b in zip(ratios[case], ratios[f"{sand}_gca"]))]
               for case in found if not case.endswith("_gca") and f"{sand}_gca" in ratios])


def report_rings(group):
    last = max(row["blow"] for rows in group.blows.values() for member in rows.values() for row in member)
    columns = [(f"ring_{ring + 1}_{what}", digits, factor) for what, digits, factor in
               (("stress_kPa", 1, 1), ("void_ratio", 3, 1), ("free_share", 0, 100)) for ring in range(len(RINGS))]

    def values(case, column, factor=1):
        return group.mean_of_blows(case, lambda row: factor * row[column], (last,))

    rows = []
    for case in cases(group):
        at_rest = K0 * unit_weight(SANDS[case.split("_")[0]])
        rows.append([title(case), *(spread(values(case, column, factor), digits) for column, digits, factor in columns),
                     spread(values(case, "ring_level_m", -at_rest), 1)])
    for sand in SANDS:
        for contact in ("fca", "surface"):
            if group.count(f"{sand}_{contact}") > 1 and group.count(f"{sand}_gca") > 1:
                rows.append([f"{sand}, {NAMES[contact]} less GCA",
                             *(difference(values(f"{sand}_{contact}", column, factor), values(f"{sand}_gca", column, factor), digits)
                               for column, digits, factor in columns), ""])
    rings = [f"{inner:g}–{outer:g} D" for inner, outer in RINGS]
    table([f"P3, after blow {last:.0f}", *(f"σ_rr [kPa] {ring}" for ring in rings), *(f"e {ring}" for ring in rings),
           *(f"stress-free [%] {ring}" for ring in rings), "K0 γ z [kPa]"], rows)


def report_void_ratio(group):
    def thresholds(case, side):
        return " / ".join(spread(group.end(case, f"{side}_{change:g}_D"), 1) for change in CHANGES)
    table([f"P5, Δe of {' / '.join(f'{change:g}' for change in CHANGES)}", "denser beside the shaft [D]", "looser at the tip [D]",
           "sand in the pile (loaded), most"],
          [[title(case), thresholds(case, "denser"), thresholds(case, "looser"),
            f"{max(group.end(case, 'inside_pile')):.0f} ({max(group.end(case, 'inside_pile_loaded')):.0f})"]
           for case in cases(group)])


# Of each blow from the end of the hammer's force on: what, digits, value.
AFTER = (("of the set [%]", 0, lambda row: 100 * (row["on_m"] - row["back_m"] + row["again_m"]) / row["set_m"]),
         ("on until it stops [mm]", 1, lambda row: 1e3 * row["on_m"]),
         ("back [mm]", 1, lambda row: 1e3 * row["back_m"]),
         ("down again [mm]", 1, lambda row: 1e3 * row["again_m"]),
         ("smallest R [kN]", 0, lambda row: row["least_kN"]),
         ("of the hammer's impulse in the pile at first [%]", 0, lambda row: 100 * row["momentum_share"]),
         ("its kinetic energy then [J]", 0, lambda row: row["kinetic_J"]),
         ("R − W takes until it stops [J]", 0, lambda row: row["resisted_J"]))


def report_after_hammer(group):
    table(["after the hammer's force", *(what for what, _, _ in AFTER)],
          [[title(case), *(spread(group.mean_of_blows(case, value), digits) for _, digits, value in AFTER)]
           for case in cases(group)])


def design_stress(row, void_ratio):
    """Radial stress after installation by ICP-05 and UWA-05 [kPa], at the level of the rings: q_c is what the tip meets; of
    sands, a closed end, the shaft above the tip by at least 8 radii and 2 diameters, as the methods take it."""
    q = row["tip_kN"] / (math.pi * RADIUS**2)
    level = -row["ring_level_m"]
    overburden = unit_weight(void_ratio) * level
    above = max(0.0, 0.5 + row["from_m"] + row["set_m"] - level)
    icp = 0.029 * q * (overburden / 100.0)**0.13 * max(above / RADIUS, 8.0)**-0.38
    uwa = 0.03 * q * max(above / DIAMETER, 2.0)**-0.5
    return icp, uwa


def report_shaft(group):
    last = max(row["blow"] for rows in group.blows.values() for member in rows.values() for row in member)
    rows = []
    for case in cases(group):
        void_ratio = SANDS[case.split("_")[0]]
        rows.append([title(case), spread(group.mean_of_blows(case, lambda row: row["tip_kN"], (last,)), 0),
                     spread(group.mean_of_blows(case, lambda row: row["shaft_kN"], (last,)), 1),
                     spread(group.mean_of_blows(case, lambda row: row["shaft_kN"], (1,)), 1),
                     spread(group.mean_of_blows(case, lambda row: row["ring_1_stress_kPa"], (last,)), 0),
                     *(spread(group.mean_of_blows(case, lambda row: design_stress(row, void_ratio)[k], (last,)), 0)
                       for k in range(2))])
    table([f"blow {last:.0f}", "tip at the largest R [kN]", "shaft then [kN]", "in blow 1", "σ_rr, 0–0.25 D [kPa]", "ICP-05 [kPa]",
           "UWA-05 [kPa]"], rows)


def report_grids(groups):
    """What the cells change, of dense sand."""
    coarse, base = (groups[name] for name in ("coarse", "base"))
    values = (("self-weight [mm]", 0, lambda g, c: g.end(c, "self_weight_m", 1e3)),
              ("driven [mm]", 0, lambda g, c: g.end(c, "driven_m", 1e3)),
              *((what, digits, lambda g, c, value=value: g.mean_of_blows(c, value)) for what, digits, value in CLAIMS[:5]))
    rows = []
    for case in cases(base):
        if base.count(case) > 1 and coarse.count(case) > 1:
            rows.append([f"{title(case)}, {base.count(case)} runs", *(spread(of(base, case), digits) for _, digits, of in values)])
            rows.append(["less those with 1.4 h", *(difference(of(base, case), of(coarse, case), digits) for _, digits, of in values)])
    if rows:
        table(["cells of the base case", *(what for what, _, _ in values)], rows)


def on_axis(row):
    """Whether the largest cell mean is that of the innermost squares."""
    return row["largest_r_m"] < BIN


# Of each blow one after the other: what, digits, value.
RAPID = (("σ_rr, largest cell mean [kPa]", 0, lambda row: row["stress_kPa"]),
         ("from 0.1 m below the tip on [kPa]", 0, lambda row: row["stress_0.1_m_kPa"]),
         ("σ_rr, mean below the tip [kPa]", 0, lambda row: row["disc_rr_kPa"]),
         ("σ_zz, mean below the tip [kPa]", 0, lambda row: row["disc_zz_kPa"]),
         ("tip at the largest R [kN]", 1, lambda row: row["tip_kN"]),
         ("largest on the axis, r < 50 mm [% of blows]", 0, lambda row: 100.0 * on_axis(row)),
         ("... σ_rr then [kPa]", 0, lambda row: row["stress_kPa"] if on_axis(row) else math.nan),
         ("... σ_rr where it is elsewhere [kPa]", 0, lambda row: math.nan if on_axis(row) else row["stress_kPa"]),
         ("... how far below the tip [mm]", 0, lambda row: 1e3 * row["largest_below_m"]),
         ("... particles in its square", 1, lambda row: row["largest_particles"]),
         ("set [mm]", 1, lambda row: 1e3 * row["set_m"]))


RAPID_KINDS = {"": "as two_blows", "no_mean": "no cell mean", "no_pic": "no PIC", "15": "1.5 cells in the radius",
               "20": "2 cells in the radius", "30": "3 cells in the radius", "published": "published CPDI", "ugimp": "uGIMP",
               "musl": "MUSL", "usf": "USF", "centre_1": "nearest centre, k 1", "centre_2": "nearest centre, k 2"}


def rapid_pair(group, kind):
    """The cases of FCA and GCA of a kind; FCA, which knows no distance, as in two_blows where it is GCA's that changes."""
    case = f"{kind}_fca".removeprefix("_")
    return case if case in group.ends else "fca", case.replace("fca", "gca")


def report_rapid(group):
    kinds = [kind for kind in RAPID_KINDS if rapid_pair(group, kind)[1] in group.ends]
    for kind in kinds:
        pair = rapid_pair(group, kind)
        rows = []
        for what, digits, value in RAPID:
            found = [group.mean_of_blows(case, value, range(1, 11)) for case in pair]
            rows.append([what, *(spread(x, digits) for x in found), difference(*found, digits)])
        counts = " and ".join(str(group.count(case)) for case in pair)
        table([f"{RAPID_KINDS[kind]}, ten blows: {counts} runs", "FCA", "GCA", "difference"], rows)
    rows = []
    for kind in kinds:
        for first, last in ((1, 5), (6, 10), (11, 20)):
            found = [group.mean_of_blows(case, RAPID[0][2], range(first, last + 1)) for case in rapid_pair(group, kind)]
            if all(found):
                rows.append([f"{RAPID_KINDS[kind]}, {first}–{last}", *(spread(values, 0) for values in found),
                             difference(*found, 0)])
    table(["largest cell mean of σ_rr [kPa], blows", "FCA", "GCA", "difference"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    groups = {name: Group(options.folder, name) for name in ("coarse", "base", "rapid") if (options.folder / f"{name}.csv").exists()}
    if not groups:
        sys.exit(f"ensemble_tables.py: {options.folder}: no group of ensemble.py, as measures.py --ensemble leaves them")
    for name in ("coarse", "base"):
        if name in groups:
            print(f"### {name}\n")
            for report in (report_depths, report_claims, report_sets, report_rings, report_void_ratio, report_shaft,
                           report_after_hammer):
                report(groups[name])
    if "coarse" in groups and "base" in groups:
        report_grids(groups)
    if "rapid" in groups:
        print("### rapid\n")
        report_rapid(groups["rapid"])


if __name__ == "__main__":
    main()
