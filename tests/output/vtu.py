# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes pictures as softgrain does, for tests of what reads them."""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLY_LINE, VTK_VERTEX, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter


def write_grid(path, places, cells=None, point_data=None, cell_data=None):
    """Places (rows x, y), cells as lists of their numbers (none: every place is one), data by name."""
    places = np.asarray(places, dtype=float).reshape(-1, 2)
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.column_stack([places, np.zeros(len(places))]), deep=1))
    grid.SetPoints(points)
    for cell in cells if cells is not None else [[i] for i in range(len(places))]:
        grid.InsertNextCell(VTK_POLY_LINE if len(cell) > 1 else VTK_VERTEX, len(cell), list(cell))
    for data, target in ((point_data, grid.GetPointData()), (cell_data, grid.GetCellData())):
        for name, values in (data or {}).items():
            array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=1)
            array.SetName(name)
            target.AddArray(array)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(grid)
    writer.Write()


def write_series(directory, times, parts):
    """fields.pvd of the files fields/PART-NUMBER.vtu."""
    with open(os.path.join(directory, "fields.pvd"), "w", encoding="utf-8") as file:
        file.write('<VTKFile type="Collection"><Collection>\n')
        for number, time in enumerate(times):
            for part in parts:
                file.write(f'<DataSet timestep="{time!r}" name="{part}" file="fields/{part}-{number}.vtu"/>\n')
        file.write("</Collection></VTKFile>\n")
