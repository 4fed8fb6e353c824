# SPDX-License-Identifier: BSD-3-Clause
"""A rigid body that is moved in sand in space, beside a formula: what py_curves.py and uplift.py ask a case and its history for."""
import argparse
import pathlib
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pile"))
from figures import block, gnuplot  # noqa: E402,F401  for both
from quarter import rows_of  # noqa: E402


def options_of(doc):
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case")
    parser.add_argument("history")
    parser.add_argument("--friction-angle", type=float, default=40.0, metavar="DEG", help="of the sand in the formula; default: 40")
    parser.add_argument("--to", metavar="PICTURE.svg")
    return parser.parse_args()


class InSand:
    def __init__(self, case, history):
        with open(case, "rb") as file:
            plan = tomllib.load(file)
        self.history = plan["history"]
        self.body = next(each for each in plan["body"] if each["name"] == self.history["body"])
        sand = next(each for each in plan["body"] if "sand" in each)
        self.weight = 9.81e-3 * sand["grain_density_kg_per_m3"] / (1.0 + sand["sand"]["void_ratio"])  # [kN/m3]
        # Whose means are over more than half an interval: the last one of a stage may be that of a step.
        rows = rows_of(history)
        self.rows = [row for before, row in zip(rows, rows[1:]) if row["t"] - before["t"] > 0.5 * self.history["interval_s"]]
