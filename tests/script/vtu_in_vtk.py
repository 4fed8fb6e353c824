#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of grit mpm as VTK's own reader sees them, which is ParaView's: vtu_in_vtk.py GRIT PROJECT WORK. 77: no VTK."""
import pathlib
import subprocess
import sys

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkCellCenters
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as error:
    print(f"skipped, python3-vtk9 is missing: {error}")
    sys.exit(77)
import numpy

QUADRILATERAL, HEXAHEDRON = 9, 12


class Frame:
    """Cells of a file: their kind, size, centre and columns."""

    def __init__(self, file):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        problems = []
        reader.AddObserver("ErrorEvent", lambda *_: problems.append("error"))
        reader.Update()
        grid = reader.GetOutput()
        assert not problems and reader.GetErrorCode() == 0, f"{file.name}: VTK cannot read it"
        assert grid.GetNumberOfCells() > 0, f"{file.name}: no cells"
        self.kinds = {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}
        self.size = self.measured(grid)
        centres = vtkCellCenters()
        centres.SetInputData(grid)
        centres.Update()
        self.centre = vtk_to_numpy(centres.GetOutput().GetPoints().GetData())
        data = grid.GetCellData()
        self.columns = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
        for name, values in self.columns.items():
            assert len(values) == grid.GetNumberOfCells(), f"{file.name}: {name} has another length"

    @staticmethod
    def measured(grid):
        size = vtkCellSizeFilter()
        size.SetInputData(grid)
        size.Update()
        out = size.GetOutput().GetCellData()
        name = "Volume" if grid.GetCellType(0) == HEXAHEDRON else "Area"
        return vtk_to_numpy(out.GetArray(name))


def close(value, expected, share, what):
    assert numpy.allclose(value, expected, rtol=share, atol=0.0), f"{what}: {value}, expected {expected}"


def run(grit, case, work):
    subprocess.run([grit, "mpm", case, "--out", work, "--no-plot"], check=True, stdout=subprocess.DEVNULL)
    return {file.stem: Frame(file) for file in sorted(work.glob("*.vtu"))}


def main():
    grit, project, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    space = run(grit, project / "verification/mpm/every_key_in_space.toml", work / "space")
    for name, frame in space.items():
        assert frame.kinds == {HEXAHEDRON}, f"{name}: kinds {frame.kinds}"
        assert frame.size.min() > 0.0, f"{name}: a volume of {frame.size.min()}"
    soil = space["every_key_in_space_000000_soil"]
    close(soil.size.sum(), 0.6 * 0.6 * 0.4, 1e-12, "volume of the soil")
    weight = 2.65 / 1.65 * 9.81  # kN/m3, below a surcharge of 2 kPa
    close(soil.columns["stress_zz [kPa]"], weight * soil.centre[:, 2] - 2.0, 1e-6, "stress at rest [kPa]")
    plane = run(grit, project / "tests/script/falling.toml", work / "plane")
    for name, frame in plane.items():
        assert frame.kinds == {QUADRILATERAL}, f"{name}: kinds {frame.kinds}"
        assert frame.size.min() > 0.0, f"{name}: an area of {frame.size.min()}"
    close(plane["falling_000000_soil"].size.sum(), 0.2 * 0.48, 1e-12, "area of the soil")
    print(f"{len(space)} files in space and {len(plane)} in the plane, as VTK reads them")


if __name__ == "__main__":
    main()
