#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_laboratory.py GRIT FOLDER: a laboratory's sheets, made of element tests of a known sand with scatter.

Writes laboratory.xlsx (by openpyxl, which Debian has) and laboratory.csv into FOLDER; verification/data has what it wrote.
"""
import bisect
import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import openpyxl

SAND = """name = "hochstetten"
granulate_hardness_kPa = 0.82e6
stiffness_exponent = 0.29
pyknotropy_exponent = 0.16
critical_void_ratio = 0.92
"""


def element_test(grit, start, stage):
    """Columns of a test by name."""
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.toml"
        case.write_text(f"[sand]\n{SAND}[start]\n{start}[[stage]]\n{stage}increments = 800\n")
        subprocess.run([grit, "element", case, "--no-plot", "--quiet", "--out", folder], check=True)
        lines = [line for line in (case.with_suffix(".csv")).read_text().splitlines() if line[0] != "#"]
    rows = list(csv.reader(lines))
    return {name.split(" ")[0]: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


def at(x, y, value):
    """y where rising x has this value."""
    i = min(max(bisect.bisect_left(x, value), 1), len(x) - 1)
    share = (value - x[i - 1]) / (x[i] - x[i - 1])
    return y[i - 1] + share * (y[i] - y[i - 1])


def compressions(test):
    return [1 - math.exp(each) for each in test["axial_strain"]]


def main(grit, folder):
    scatter = random.Random(5)
    book = openpyxl.Workbook()
    cover = book.active
    cover.title = "Deckblatt"
    for row in (["Bodenmechanisches Labor"], ["Sand 17/3"], [], ["emax", 0.93], ["emin", 0.60], ["Schüttkegel [Grad]", 33.4]):
        cover.append(row)

    for number, e_0 in ((1, 0.88), (2, 0.66)):
        test = element_test(grit, f"stress_kPa = [-5, -2.277, -2.277, 0, 0, 0]\nvoid_ratio = {e_0}\n",
                            'test = "oedometer"\naxial_stress_kPa = -820\n')
        sheet = book.create_sheet(f"OED {number}")
        for row in ([f"Oedometer {number}"], ["e0 =", e_0], [], ["Spannung [kPa]", "Setzung [mm]", "Stauchung [%]", "Porenzahl [-]"]):
            sheet.append(row)
        for stress in (5, 12.5, 25, 50, 100, 200, 400, 800):
            e = at([-each for each in test["stress_11"]], test["void_ratio"], stress) + scatter.gauss(0, 0.0015)
            shortening = (e_0 - e) / (1 + e_0)
            sheet.append([stress, round(20 * shortening, 3), round(100 * shortening, 3), round(e, 4)])

    lines = ["Versuch;Zellendruck [kPa];eps1 [%];q [kPa];epsv [%]"]
    for name, pressure, e_0 in (("CD1", 100, 0.68), ("CD2", 300, 0.66), ("CD3", 100, 0.85)):
        test = element_test(grit, f"pressure_kPa = {pressure}\nvoid_ratio = {e_0}\n",
                            'test = "triaxial_drained"\naxial_strain = -0.22\n')
        strain = compressions(test)
        for eps in (0, 0.1, 0.2, 0.5, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18):
            q = at(strain, test["axial_deviator"], eps / 100)
            volume = 100 * (1 - math.exp(at(strain, test["volumetric_strain"], eps / 100)))
            if eps > 0:
                q += q * scatter.gauss(0, 0.02) + scatter.gauss(0, 2)
                volume += scatter.gauss(0, 0.05)
            lines.append(f"{name};{pressure};{eps:.2f};{max(q, 0):.1f};{volume:.3f}".replace(".", ","))
    (pathlib.Path(folder) / "laboratory.csv").write_text("\n".join(lines) + "\n", encoding="latin-1")

    test = element_test(grit, "pressure_kPa = 200\nvoid_ratio = 0.80\n", 'test = "triaxial_undrained"\naxial_strain = -0.15\n')
    strain = compressions(test)
    sheet = book.create_sheet("CU 1")
    for row in (["CU-Versuch, konsolidiert bei 200 kPa, e = 0,80, Sättigungsdruck 300 kPa"], [], ["eps1 [%]", "sigma1-sigma3 [kPa]", "u [kPa]"]):
        sheet.append(row)
    for eps in (0, 0.1, 0.3, 0.6, 1, 2, 3, 4, 6, 8, 10, 12):
        q = at(strain, test["axial_deviator"], eps / 100) + (scatter.gauss(0, 3) if eps > 0 else 0)
        u = 300 + at(strain, test["pore_pressure"], eps / 100) + scatter.gauss(0, 3)
        sheet.append([eps, round(q, 1), round(u, 1)])
    book.save(pathlib.Path(folder) / "laboratory.xlsx")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    main(sys.argv[1], sys.argv[2])
