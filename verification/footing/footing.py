#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""footing.py [--grit FILE] [--out DIR] [--again] [--jobs N] [--elements FILE] [--least-edge X] [--most-jump X]
[CASE ...]: strips of this folder and the tables of docs/footing.md; profiles.csv and loads.csv for footing.gp. Exit
status 1: a load is above the capacity, or an edge carries less or jumps are larger than X.

CASE: files of this folder without .toml; default: all. What has ended in DIR (results/footing) is not run again. FILE of
--elements: footing_large.csv that script/calculix leaves."""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from results import Frame, History  # noqa: E402
from studies import chosen, command_line, run_all  # noqa: E402

HALF, WIDTH = 0.5, 1.0  # of the strip [m]
SETTLEMENTS = (0.02, 0.05, 0.1, 0.15)  # [m]
PROFILES = (0.05, 0.1)  # settlements at which profiles are taken [m]
ROWS = 4  # of particles below the base
G = 10.0  # [m/s2]
PHI_C = 33.0  # of Lausitz sand [deg]
SANDS = {False: (0.60, 1.6, 20.0), True: (0.55, 1.71, 0.0)}  # free: e, density [t/m3], surcharge [kPa]


def is_free(case):
    return case.startswith("free")


def has_ended(file):
    return file.exists() and "ended by its depth" in file.read_text()


def at_settlement(depths, values, wanted):
    """Linear between rows; the last one if it is nearly there."""
    for i in range(1, len(depths)):
        if depths[i] >= wanted:
            share = (wanted - depths[i - 1]) / (depths[i] - depths[i - 1])
            return values[i - 1] + share * (values[i] - values[i - 1])
    return values[-1] if depths[-1] > 0.999 * wanted else math.nan


def pressures(history):
    """Below the strip [kPa], means of five rows."""
    force = history["under_force"]
    return [sum(force[max(i - 2, 0):i + 3]) / len(force[max(i - 2, 0):i + 3]) / HALF for i in range(len(force))]


class Below:
    """The particles that were below the strip at the start, at a settlement: for each row from the base downwards
    [(distance from the axis [m], sigma_zz [kPa], pressing)]; and the mean p [kPa] within a width of the strip."""

    def __init__(self, out, case, settlement):
        frames = sorted(out.glob(f"{case}_??????_strip.vtu"))
        base = [min(z for quad in Frame(file).corners for _, z in quad) for file in frames]
        nearest = min(range(len(frames)), key=lambda i: abs(base[i] + settlement))
        self.settlement = -base[nearest]
        start = Frame(str(frames[0]).replace("_strip", "_sand"))
        now = Frame(str(frames[nearest]).replace("_strip", "_sand"))
        columns = {}
        for i, (r, z) in enumerate(start.centres()):
            if r < HALF:
                columns.setdefault(round(r, 5), []).append((-z, i))
        places, areas = now.centres(), now.areas()
        self.rows = [[] for _ in range(ROWS)]
        for r in sorted(columns):
            for row, (_, i) in enumerate(sorted(columns[r])[:ROWS]):
                self.rows[row].append((places[i][0], -now["stress_zz"][i]))
        zone = [i for i, (r, z) in enumerate(places) if r < WIDTH and z > base[nearest] - WIDTH]
        area = sum(areas[i] for i in zone)
        self.p = sum(areas[i] * now["p"][i] for i in zone) / area

    def cells(self, row):
        """Means of the two particles of a cell, from the axis outwards."""
        stress = [s for _, s in self.rows[row]]
        return [0.5 * (a + b) for a, b in zip(stress[::2], stress[1::2])]

    def mean(self):
        return mean(self.cells(0))

    def edge(self):
        """What the outermost cell carries, by the mean."""
        return self.cells(0)[-1] / self.mean()

    def jumps(self):
        """Mean difference of neighbouring particles of the first row, by the mean."""
        stress = [s for _, s in self.rows[0]]
        return mean([abs(b - a) for a, b in zip(stress, stress[1:])]) / self.mean()


def mean(values):
    return sum(values) / len(values)


def peak_friction(grit, void_ratio, pressure):
    """Largest mobilised friction in a drained biaxial test [deg]."""
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "peak.toml"
        case.write_text(f"[sand]\nname = \"lausitz\"\n[start]\npressure_kPa = {pressure}\nvoid_ratio = {void_ratio}\n"
                        "intergranular_strain = \"mobilised\"\n[[stage]]\ntest = \"biaxial_drained\"\n"
                        "axial_strain = -0.2\n")
        subprocess.run([grit, "element", str(case), "--out", folder, "--no-plot", "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        rows = csv.DictReader(line for line in (pathlib.Path(folder) / "peak.csv").read_text().splitlines()
                              if not line.startswith("#"))
        return max(float(row["mobilised_friction [deg]"]) for row in rows)


def capacity(phi, unit_weight, surcharge):
    """q N_q + gamma B N_gamma / 2 of a rough strip [kPa]: N_q of Prandtl and Reissner, N_gamma as Hjiaj, Lyamin & Sloan
    (2005), doi 10.1016/j.ijsolstr.2004.08.002, fit their bounds, which differ by less than 3.5 %."""
    t = math.tan(math.radians(phi))
    n_q = math.exp(math.pi * t) * math.tan(math.radians(45 + phi / 2))**2
    n_gamma = math.exp((math.pi + 3 * math.pi**2 * t) / 6) * t**(2 * math.pi / 5)
    return surcharge * n_q + 0.5 * unit_weight * WIDTH * n_gamma


def print_table(columns, rows):
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def elements(path):
    rows = [[float(x) for x in line.split(",")] for line in path.read_text().splitlines() if not line.startswith("#")]
    return [row[0] for row in rows], [row[1] for row in rows]


def print_loads(cases, histories, of_elements):
    rows = []
    for case in cases:
        depths, q = histories[case]["depth"], pressures(histories[case])
        found = [at_settlement(depths, q, s) for s in SETTLEMENTS]
        rows.append([case] + ["" if math.isnan(x) else f"{x:.0f}" for x in found])
    if of_elements:
        found = [at_settlement(*of_elements, s) for s in SETTLEMENTS]
        rows.append(["finite elements"] + ["" if math.isnan(x) else f"{x:.0f}" for x in found])
    print_table(["pressure below the strip [kPa] at"] + [f"{1e3 * s:.0f} mm" for s in SETTLEMENTS], rows)


def print_profiles(cases, below):
    rows = []
    for case in cases:
        for settlement in PROFILES:
            b = below[case, settlement]
            least = min(s for _, s in b.rows[0]) / b.mean()
            rows.append([case, f"{1e3 * b.settlement:.0f}", f"{b.edge():.2f}", f"{least:.2f}", f"{b.jumps():.2f}",
                         ", ".join(f"{mean(b.cells(k)):.0f}" for k in range(ROWS))])
    print_table(["", "at [mm]", "outermost cell / mean", "least particle / mean", "mean jump / mean",
                 "mean of the first, second ... row [kPa]"], rows)


def print_bounds(cases, histories, below, grit):
    rows, outside = [], 0
    for case in cases:
        e, density, surcharge = SANDS[is_free(case)]
        settlement = PROFILES[-1]
        b = below[case, settlement]
        load = at_settlement(histories[case]["depth"], pressures(histories[case]), settlement)
        around = surcharge + G * density * settlement
        phi = peak_friction(grit, e, b.p)
        least, most = (capacity(f, G * density, q) for f, q in ((PHI_C, surcharge), (phi, around)))
        verdict = "below" if load < least else "above" if load > most else "between"
        outside += load > most
        rows.append([case, f"{b.p:.0f}", f"{least:.0f}", f"{load:.0f}", f"{phi:.1f}", f"{most:.0f}", verdict])
    print_table(["", "mean p [kPa]", "capacity with phi_c, surface [kPa]", f"load at {1e3 * PROFILES[-1]:.0f} mm",
                 "peak phi [deg]", "capacity with it, embedded", ""], rows)
    return outside


def write_pictures(out, cases, histories, below, of_elements):
    with (out / "profiles.csv").open("w") as file:
        for case in cases:  # one index of gnuplot each
            b = below[case, PROFILES[-1]]
            file.write(f"# {case}\n" + "".join(f"{r:.5g},{s / b.mean():.5g}\n" for r, s in b.rows[0]) + "\n\n")
    with (out / "loads.csv").open("w") as file:
        for case in cases:
            file.write(f"# {case}\n" + "".join(f"{1e3 * d:.5g},{q:.5g}\n" for d, q in zip(
                histories[case]["depth"], pressures(histories[case]))) + "\n\n")
        if of_elements:
            file.write("# finite elements\n" +
                       "".join(f"{1e3 * d:.5g},{q:.5g}\n" for d, q in zip(*of_elements)) + "\n\n")


def main():
    parser = command_line(__doc__, "footing")
    parser.add_argument("--again", action="store_true", help="run what has ended too")
    parser.add_argument("--elements", type=pathlib.Path)
    parser.add_argument("--least-edge", type=float, default=-math.inf)
    parser.add_argument("--most-jump", type=float, default=math.inf)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    args = parser.parse_args()
    cases = chosen(args.cases, sorted((file.stem for file in HERE.glob("*.toml")), key=lambda c: (is_free(c), c)))
    run_all(args, [HERE / f"{case}.toml" for case in cases if args.again or not has_ended(args.out / f"{case}.csv")])
    histories = {case: History(args.out / f"{case}.csv") for case in cases}
    below = {(case, s): Below(args.out, case, s) for case in cases for s in PROFILES}
    of_elements = elements(args.elements) if args.elements else None
    print_loads(cases, histories, of_elements)
    print_profiles(cases, below)
    outside = print_bounds(cases, histories, below, args.grit)
    write_pictures(args.out, cases, histories, below, of_elements)
    poor = [b for b in below.values() if b.edge() < args.least_edge or b.jumps() > args.most_jump]
    sys.exit(1 if outside or poor else 0)


if __name__ == "__main__":
    main()
