# SPDX-License-Identifier: LGPL-2.1-or-later
"""States as meshes of VTK and pyvista."""

import os
from xml.sax.saxutils import quoteattr

import numpy as np

from .errors import InputError, need, need_pip
from .profiles import pressures_on_outlines

PARTS = ("points", "outlines", "contacts", "contact_pressures", "walls")


def three(values):
    """Vectors of the plane with a third component, as VTK wants them."""
    return (
        np.column_stack([values, np.zeros(len(values))])
        if values.ndim == 2 and values.shape[1] == 2
        else values
    )


def to_vtk(state, part):
    """
    A vtkPolyData of a part of a state: points, contacts and pressures along them as vertices,
    outlines and walls as closed and open lines. The vertices of outlines have the pressure and the
    traction of contact, where contacts were written.
    """
    if part not in PARTS:
        raise InputError(f"there is no mesh of '{part}'; there are {', '.join(PARTS)}")
    try:
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    except ImportError as error:
        raise need("python3-vtk9", error) from error
    places, lines, data = mesh_of(state, part)
    of_places = {} if lines else data
    mesh, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(three(places), deep=1))
    mesh.SetPoints(points)
    offsets = (
        np.concatenate([[0], np.cumsum([len(line) for line in lines])])
        if lines
        else np.arange(len(places) + 1)
    )
    numbers = np.concatenate(lines) if lines else np.arange(len(places))
    cells.SetData(
        *(
            numpy_to_vtkIdTypeArray(np.ascontiguousarray(a, dtype=np.int64), deep=1)
            for a in (offsets, numbers)
        )
    )
    (mesh.SetLines if lines else mesh.SetVerts)(cells)
    if part == "outlines" and state.has("contacts"):
        of_places = dict(pressures_on_outlines(state).items())
    for target, columns in (
        (mesh.GetPointData(), of_places),
        (mesh.GetCellData(), data if lines else {}),
    ):
        for name, values in columns.items():
            if values.dtype.kind in "US" or values.ndim > 2:
                continue
            array = numpy_to_vtk(np.ascontiguousarray(three(values), dtype=float), deep=1)
            array.SetName(name)
            target.AddArray(array)
    return mesh


def mesh_of(state, part):
    """(places, lines as numbers of places or nothing, data)."""
    if part in ("points", "contacts", "contact_pressures"):
        table = getattr(state, part)
        key = "position_m" if part == "points" else "place_m"
        return table[key], [], {name: values for name, values in table.items() if name != key}
    if part == "walls":
        ends = state.walls["ends_m"].reshape(-1, 2)
        return ends, list(np.arange(len(ends)).reshape(-1, 2)), dict(state.walls.items())
    places, lines, rows, start = [], [], [], 0
    for body, rings in state.outlines.items():
        for ring in rings:
            places.append(ring)
            lines.append(np.append(np.arange(start, start + len(ring)), start))
            rows.append(body)
            start += len(ring)
    row_of = {int(body): row for row, body in enumerate(state.bodies["body"])}
    chosen = np.array([row_of[body] for body in rows], dtype=int)
    data = {name: values[chosen] for name, values in state.bodies.items()}
    return (np.concatenate(places) if places else np.zeros((0, 2))), lines, data


def hidden_beside(path):
    return os.path.join(os.path.dirname(path), ".part-" + os.path.basename(path))


def write_vtp(state, part, path):
    """Writes a part of a state as a file of ParaView, whole or not at all."""
    mesh = to_vtk(state, part)
    try:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    except ImportError as error:
        raise need("python3-vtk9", error) from error
    if not path.endswith(".vtp"):
        raise InputError(
            f"the name of a file of lines and places for ParaView ends with .vtp, not {path}"
        )
    writer, temporary = vtkXMLPolyDataWriter(), hidden_beside(path)
    writer.SetInputData(mesh)
    writer.SetFileName(temporary)
    if not writer.Write():
        raise InputError(f"{path} cannot be written")
    os.replace(temporary, path)
    return path


def write_pvd(run, part, path):
    """
    Writes a part of all states of a run as files beside @path, a series that ParaView plays; @path
    is the last that is written.
    """
    if not path.endswith(".pvd"):
        raise InputError(f"the name of a series for ParaView ends with .pvd, not {path}")
    stem = path[: -len(".pvd")]
    lines = []
    for number, state in enumerate(run):
        name = os.path.basename(write_vtp(state, part, f"{stem}-{number:06d}.vtp"))
        lines.append(f'<DataSet timestep="{state.time!r}" name="{part}" file={quoteattr(name)}/>')
    text = "\n".join(
        [
            '<?xml version="1.0"?>',
            '<VTKFile type="Collection" version="1.0">',
            "<Collection>",
            *lines,
            "</Collection>",
            "</VTKFile>",
            "",
        ]
    )
    temporary = hidden_beside(path)
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(temporary, path)
    return path


def to_pyvista(state, part):
    """The same wrapped by pyvista."""
    try:
        import pyvista
    except ImportError as error:
        raise need_pip("pyvista", error) from error
    return pyvista.wrap(to_vtk(state, part))
