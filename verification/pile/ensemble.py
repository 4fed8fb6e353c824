#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""ensemble.py GROUP DIR [--list]: case files of an ensemble: members of a case differ by choices that are none. Writes
DIR/CASE-K.toml and prints their names, in the order in which they are worth running; --list: prints only.

Groups:
  base     the cells of dense_gca.toml, dense and loose sand, each contact
  coarse   the same on those of sensitivity/grid_coarse.toml, at a third of the time
  rapid    20 blows one after the other, FCA and GCA, on the grid of two_blows.toml; ten without cell mean, without PIC, and
           with 1.5, 2 and 3 cells in the radius, by other shape functions and schemes, and with the distance to the nearest
           centre
"""
import argparse
import json
import pathlib
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
CONTACTS = ("gca", "fca", "pca", "surface")
SANDS = {"dense": 0.55, "loose": 0.65}  # void ratios; e_c is 0.66 at 350 kPa
MEMBERS = 5


def load(name):
    with (HERE / name).open("rb") as file:
        return tomllib.load(file)


BASE = load("dense_gca.toml")
COARSE = {key: value for key, value in load("sensitivity/grid_coarse.toml")["override"].items() if key.startswith("grid.")}
COARSEST = load("two_blows.toml")["override"]
# Self-weight ends when the pile rests; what comes after it is five blows.
SHORT = {"stage.self_weight.until.time_s": 0.55, "stage.drive.until.blows": 5}
RAPID = {**COARSEST, "traction.1.pulses.interval_s": 0.1, "stage.drive.until.blows": 20, "fields.interval_s": 0.05}
TEN = {"stage.drive.until.blows": 10}
NUMERICS = {"no_mean": {"cell_averaged_volume": False}, "no_pic": {"pic_rate_per_s": 0},
            "published": {"shape_function": "cpdi_published"}, "ugimp": {"shape_function": "ugimp"},
            "musl": {"scheme": "musl"}, "usf": {"scheme": "usf"}}


def phase(overrides, share):
    """The grid moved by a share of its cell along z below and above the pile's way, and the sand's boxes with it."""
    lower, upper = (segment["to_m"] for segment in BASE["grid"]["z"])
    shift = share * (upper - lower) / overrides.get("grid.z.2.cells", BASE["grid"]["z"][1]["cells"])
    way, _, below = BASE["body"][1]["box"][:3]
    return {"grid.z.1.to_m": lower + shift, "grid.z.2.to_m": upper + shift,
            "body.sand.box.1.z_m": [lower + shift, way["z_m"][1]], "body.sand.box.3.z_m": [below["z_m"][0], lower + shift]}


def members(overrides):
    """What makes the members of a case."""
    yield {"body.pile.density_kg_per_m3": BASE["body"][0]["density_kg_per_m3"] * (1.0 + 1e-9)}
    yield {"numerics.cfl": 0.38}
    yield {"numerics.cfl": 0.42}
    yield phase(overrides, 0.25)
    yield phase(overrides, -0.25)


def cells_in_radius(ratio):
    """The pile's way in cells of its radius over ratio; further out they grow as in two_blows.toml."""
    radius = BASE["body"][0]["box"][0]["r_m"][1]
    cell, width = radius / ratio, 2.0 * radius
    return {"grid.r.1.to_m": width, "grid.r.1.cells": round(width / cell), "grid.r.2.cell_m": cell,
            "body.sand.box.1.r_m": [0.0, width], "body.sand.box.2.r_m": [radius, width],
            "body.sand.box.3.r_m": [0.0, width], "body.sand.box.4.r_m": [width, BASE["grid"]["r"][1]["to_m"]]}


def cases(group):
    """(name, base file, overrides) of each case of a group."""
    if group == "rapid":
        for contact in ("fca", "gca"):
            yield f"rapid_{contact}", f"dense_{contact}.toml", RAPID
        for what, numerics in NUMERICS.items():
            for contact in ("fca", "gca"):
                yield (f"rapid_{what}_{contact}", f"dense_{contact}.toml",
                       RAPID | TEN | {f"numerics.{key}": value for key, value in numerics.items()})
        for ratio in (1.5, 2, 3):
            for contact in ("fca", "gca"):
                yield f"rapid_{10 * ratio:.0f}_{contact}", f"dense_{contact}.toml", RAPID | TEN | cells_in_radius(ratio)
        for power in (1, 2):
            yield (f"rapid_centre_{power}_gca", "dense_gca.toml",
                   RAPID | TEN | {"contact.1.distance": "nearest_centre", "contact.1.penalty_power": power})
        return
    for sand, void_ratio in SANDS.items():
        for contact in CONTACTS:
            yield (f"{group}_{sand}_{contact}", f"dense_{contact}.toml",
                   (COARSE if group == "coarse" else {}) | SHORT | {"body.sand.sand.void_ratio": void_ratio})


def text(base, overrides):
    lines = [f"base = {json.dumps(str(HERE / base))}", "[override]"]
    return "\n".join(lines + [f"{json.dumps(key)} = {json.dumps(value)}" for key, value in overrides.items()]) + "\n"


def files(group):
    """{name: text}: the first members of all cases of dense sand come first, then their second ones ..."""
    every = [[(f"{name}-{k + 1}", text(base, overrides | member)) for k, member in enumerate(members(overrides))]
             for name, base, overrides in cases(group)]
    sands = [every] if group == "rapid" else [every[:len(CONTACTS)], every[len(CONTACTS):]]
    return dict(case[k] for sand in sands for k in range(MEMBERS) for case in sand)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("group", choices=("base", "coarse", "rapid"))
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    found = files(options.group)
    if not options.list:
        options.folder.mkdir(parents=True, exist_ok=True)
        for name, content in found.items():
            (options.folder / f"{name}.toml").write_text(content)
    print("\n".join(found))


if __name__ == "__main__":
    main()
