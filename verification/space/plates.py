#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A square plate on sand in space, dry and below the water table: plates.py DIR CASE..., names of plate_*.toml that grit mpm has run
in DIR

prints the force on the whole plate over its way, and of the last frame of those with water the pore pressures of cells, their means,
and what of them alternates along x, y or z (saturated/alternating.py, "one way"), by what the plate presses with."""
import math
import pathlib
import sys

from vtkmodules.vtkFiltersCore import vtkCellCenters
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "saturated"))
from alternating import in_a_row  # noqa: E402
from quarter import rows_of  # noqa: E402

WAYS = (0.002, 0.005, 0.01, 0.02)  # [m]
CELL, WIDTH = 0.1, 0.8  # of the grid and of the plate [m]
BELOW = (0, 0, -3)  # the cell 0.2 to 0.3 m below the middle
DIRECTIONS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def pore_pressures(file):
    """Means of cells [kPa], by their numbers from the origin."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    centres = vtkCellCenters()
    centres.SetInputConnection(reader.GetOutputPort())
    centres.Update()
    points = centres.GetOutput()
    of_particles = points.GetPointData().GetArray("pore_pressure [kPa]")
    if of_particles is None:
        return {}
    in_cells = {}
    for i in range(points.GetNumberOfPoints()):
        cell = tuple(math.floor(x / CELL) for x in points.GetPoint(i))
        in_cells.setdefault(cell, []).append(of_particles.GetValue(i))
    return {cell: sum(some) / len(some) for cell, some in in_cells.items()}


def row(folder, case):
    history = rows_of(folder / f"{case}.csv")
    forces = [4.0 * min(history, key=lambda r, way=way: abs(r["depth"] - way))["contact_force_z"] for way in WAYS]
    out = f"| {case} | " + " | ".join(f"{force:.0f}" for force in forces)
    values = pore_pressures(max(folder.glob(f"{case}_*_sand.vtu")))
    if not values:
        return out + " | – | – | – |"
    most = max(part for cell in values for direction in DIRECTIONS if (part := in_a_row(values, cell, direction)) is not None)
    share = 100 * most / (forces[-1] / WIDTH ** 2)
    return out + f" | {min(values.values()):.0f} … {max(values.values()):.0f} | {values[BELOW]:.0f} | {most:.2f}, {share:.2f} % |"


def main():
    print("| force [kN] after | " + " | ".join(f"{1e3 * way:g} mm" for way in WAYS)
          + " | pore pressure [kPa] | 0.25 m below the middle [kPa] | alternates, most [kPa] |\n" + "|---" * (len(WAYS) + 4) + "|")
    for case in sys.argv[2:]:
        print(row(pathlib.Path(sys.argv[1]), case))


if __name__ == "__main__":
    main()
