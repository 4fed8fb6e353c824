#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""self_weight.py [--grit FILE] [--out DIR] [--jobs N] [--runs N] [--cfl X ...] [--cells R Z] [LAW ...]: how deep a pile has
sunk by its weight after 0.5 s, with the Geo-contact k = 2 in time (ADR 11), the frictional and the surface contact, and CFL
numbers, on the coarse grid of two_blows.toml or one with R cells in 0.273 m and Z along the pile's way. N runs each, whose
density of the pile differs by 1e-9: mean, and standard error of the mean. What has ended in DIR (results/self_weight) is not run
again.

LAW: published; rate (a relaxation time of 15 us, half the step at CFL 0.4), spring (that, and 0.1 M/h); rate_30us (the whole
step), dashpot_30us (implicit, without a spring worth the name), spring_{3,10,30}_30us (that, and percents of M/h),
spring_10_60us; frictional; surface; surface_{1_1ms,10,10_01ms,10_1ms} (a stiffness of 1 or 10 M/h, a relaxation time of none, 1 or 0.1
ms). With _musl behind it: stresses by velocities mapped back (numerics.scheme). Default: all."""
import math
import pathlib
import statistics

from results import History
from studies import chosen, command_line, run_all

HERE = pathlib.Path(__file__).resolve().parent
END = 0.5  # [s]
LAWS = {
    "published": {},
    "rate": {"contact.1.relaxation_time_s": 15e-6},
    "spring": {"contact.1.relaxation_time_s": 15e-6, "contact.1.modulus_kPa": 5e4,
               "contact.1.contact_stiffness_multiple": 0.1},
}
LAWS["rate_30us"] = {"contact.1.relaxation_time_s": 30e-6}
for name, percent, tau in (("dashpot_30us", 1e-4, 30e-6), ("spring_3_30us", 3, 30e-6), ("spring_10_30us", 10, 30e-6),
                           ("spring_30_30us", 30, 30e-6), ("spring_10_60us", 10, 60e-6)):
    LAWS[name] = {"contact.1.relaxation_time_s": tau, "contact.1.modulus_kPa": 5e4,
                  "contact.1.contact_stiffness_multiple": percent / 100}
LAWS = {law: keys | {"contact.1.gated": "true", "contact.1.penalty_power": 2} for law, keys in LAWS.items()}
CONTACT = 'stiff = "pile", soft = "sand", friction_coefficient = 0.3'
LAWS["frictional"] = {"contact": f'[{{{CONTACT}, law = "frictional", gated = true}}]'}
LAWS["surface"] = {"contact": f'[{{{CONTACT}, law = "surface"}}]'}
for name, multiple, tau in (("surface_1_1ms", 1, 1e-3), ("surface_10", 10, 0), ("surface_10_01ms", 10, 1e-4),
                            ("surface_10_1ms", 10, 1e-3)):
    LAWS[name] = {"contact": f'[{{{CONTACT}, law = "surface", modulus_kPa = 5e4, contact_stiffness_multiple = {multiple}, '
                             f'relaxation_time_s = {tau}}}]'}
LAWS |= {f"{law}_musl": keys | {"numerics.scheme": '"musl"'} for law, keys in LAWS.items()}
ALL = {"stage.self_weight.until.time_s": END, "stage.drive.until.time_s": 1e-4}
CELLS = (4, 90)  # of two_blows.toml


def has_ended(file):
    return file.exists() and "stage drive ended" in file.read_text()


def name_of(law, cells, cfl, member):
    grid = "" if cells == CELLS else "_cells{}_{}".format(*cells)
    return f"{law}{grid}_cfl{1000 * cfl:.0f}_{member}"


def write_case(law, cells, cfl, member, out):
    keys = ALL | LAWS[law] | {"numerics.cfl": cfl, "body.pile.density_kg_per_m3": 8000 * (1 + member * 1e-9),
                              "grid.r.1.cells": cells[0], "grid.z.2.cells": cells[1]}
    case = out / f"{name_of(law, cells, cfl, member)}.toml"
    case.write_text(f'base = "{HERE / "two_blows.toml"}"\n[override]\n' +
                    "".join(f'"{key}" = {value!r}\n'.replace("'", "") for key, value in keys.items()))
    return case


def depth(out, law, cells, cfl, member):
    """At END [mm]."""
    history = History(out / f"{name_of(law, cells, cfl, member)}.csv")
    return 1e3 * next(d for t, d in zip(history["t"], history["depth"]) if t >= END - 1e-3)


def main():
    parser = command_line(__doc__, "self_weight")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--cfl", type=float, nargs="+", default=[0.4, 0.2, 0.1])
    parser.add_argument("--cells", type=int, nargs=2, default=CELLS, metavar=("R", "Z"))
    parser.add_argument("laws", nargs="*", metavar="LAW")
    args = parser.parse_args()
    laws = chosen(args.laws, list(LAWS), "law")
    cells = tuple(args.cells)
    args.out.mkdir(parents=True, exist_ok=True)
    files = [write_case(law, cells, cfl, m, args.out) for m in range(args.runs) for law in laws for cfl in args.cfl]
    run_all(args, [file for file in files if not has_ended(file.with_suffix(".csv"))])
    print("| depth after 0.5 s [mm], CFL | " + " | ".join(f"{cfl:g}" for cfl in args.cfl) + " |")
    print("|---|" + "---|" * len(args.cfl))
    for law in laws:
        row = []
        for cfl in args.cfl:
            found = [depth(args.out, law, cells, cfl, m) for m in range(args.runs)]
            error = f" ± {statistics.stdev(found) / math.sqrt(args.runs):.1f}" if args.runs > 1 else ""
            row.append(f"{statistics.mean(found):.1f}{error}")
        print(f"| {law} | " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
