#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A column of frames in space, drawn by VTK off screen: picture.py COLUMN PNG FILE.vtu... [--range LOW HIGH] [--from X Y Z]

Files are bodies of one frame; those without the column are grey. COLUMN as ParaView lists it, for example "p [kPa]".
"""
import argparse
import pathlib

from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  letters
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the renderer

VIRIDIS = [(0.27, 0.00, 0.33), (0.23, 0.32, 0.55), (0.13, 0.57, 0.55), (0.37, 0.79, 0.38), (0.99, 0.91, 0.14)]


def bodies(files, column):
    """Surfaces of the files, and whether they have the column."""
    for file in files:
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        surface = vtkGeometryFilter()
        surface.SetInputConnection(reader.GetOutputPort())
        surface.Update()
        data = surface.GetOutput()
        yield data, data.GetCellData().HasArray(column) == 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("column")
    parser.add_argument("png", type=pathlib.Path)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--range", nargs=2, type=float)
    parser.add_argument("--from", dest="view", nargs=3, type=float, default=[1.0, 0.7, 0.5])
    parser.add_argument("--of", nargs="*", default=["sand", "soil"], help="bodies that are coloured; the others are grey")
    parser.add_argument("--zoom", type=float, default=1.0)
    parser.add_argument("--focus", nargs=3, type=float)
    options = parser.parse_args()
    found = [(data, has and any(name in file.stem for name in options.of))
             for file, (data, has) in zip(options.files, bodies(options.files, options.column))]
    if not any(coloured for _, coloured in found):
        parser.error(f"no file of {', '.join(options.of)} has a column {options.column!r}")
    low, high = options.range or (
        min(data.GetCellData().GetArray(options.column).GetRange()[0] for data, coloured in found if coloured),
        max(data.GetCellData().GetArray(options.column).GetRange()[1] for data, coloured in found if coloured))
    colours = vtkColorTransferFunction()
    for i, rgb in enumerate(VIRIDIS):
        colours.AddRGBPoint(low + (high - low) * i / (len(VIRIDIS) - 1), *rgb)
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for data, coloured in found:
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        if coloured:
            mapper.SetScalarModeToUseCellFieldData()
            mapper.SelectColorArray(options.column)
            mapper.SetLookupTable(colours)
            mapper.UseLookupTableScalarRangeOn()
        else:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(0.6, 0.6, 0.62)
        actor.GetProperty().SetAmbient(0.6)
        actor.GetProperty().SetDiffuse(0.4)
        renderer.AddActor(actor)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle(options.column)
    bar.SetNumberOfLabels(5)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0.0, 0.0, 0.0)
        text.ItalicOff()
        text.ShadowOff()
    bar.SetVerticalTitleSeparation(12)
    bar.SetPosition(0.86, 0.15)
    bar.SetWidth(0.1)
    bar.SetHeight(0.7)
    renderer.AddViewProp(bar)
    camera = renderer.GetActiveCamera()
    focus = options.focus or [0.0, 0.0, 0.0]
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(f + v for f, v in zip(focus, options.view)))
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    if options.focus:
        camera.SetFocalPoint(*focus)
        distance = camera.GetDistance()
        size = sum(v * v for v in options.view) ** 0.5
        camera.SetPosition(*(f + v / size * distance for f, v in zip(focus, options.view)))
    camera.Zoom(options.zoom)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(1000, 800)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(options.png))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
