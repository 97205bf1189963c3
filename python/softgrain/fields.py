# SPDX-License-Identifier: LGPL-2.1-or-later
"""fields.pvd and its VTU files: what a run writes for pictures, in single precision."""

import os
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from typing import Any, Dict, List

import numpy as np

from .errors import InputError, need
from .tables import Table


@dataclass
class Grid:
    """One VTU file: points, cells as lists of point numbers, data by name."""

    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))
    cells: list = field(default_factory=list)
    point_data: dict = field(default_factory=dict)
    cell_data: dict = field(default_factory=dict)


@dataclass
class FrameFiles:
    """An entry of fields.pvd."""

    number: int
    time: float
    files: dict


def read_series(directory):
    """Frames of fields.pvd in order."""
    if not os.path.isdir(directory):
        raise InputError(f"there is no folder {directory}")
    path = os.path.join(directory, "fields.pvd")
    if not os.path.exists(path):
        raise InputError(
            f"{directory} has no fields.pvd: the run has not written pictures; run it again with"
            " --set 'Output/Fields every=TIME' (or 'Number of field outputs=10' where 'Stop/End"
            " time' is set)"
        )
    try:
        frames: List[Any] = []
        for item in ElementTree.parse(path).iter("DataSet"):
            time = float(item.attrib["timestep"])
            if not frames or frames[-1].time != time:
                frames.append(FrameFiles(len(frames), time, {}))
            file = item.attrib["file"]
            name = item.attrib.get("name") or os.path.basename(file).split("-")[0]
            frames[-1].files[name] = os.path.join(directory, file)
    except (ElementTree.ParseError, KeyError, ValueError) as error:
        raise InputError(f"{path} is damaged: {error}") from error
    return frames


def read_grid(path, dimension=2):
    """One VTU file by VTK's own reader; places with the first @dimension components."""
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError as error:
        raise need("python3-vtk9", error) from error
    if not os.path.exists(path):
        raise InputError(f"{path}, named by fields.pvd, is missing")
    problems = []
    reader = vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: problems.append(path))
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if problems or data is None:
        raise InputError(f"{path} is damaged")
    grid = Grid()
    if data.GetNumberOfPoints():
        grid.points = vtk_to_numpy(data.GetPoints().GetData())[:, :dimension].astype(float)
    if data.GetNumberOfCells():
        offsets = vtk_to_numpy(data.GetCells().GetOffsetsArray())
        connectivity = vtk_to_numpy(data.GetCells().GetConnectivityArray())
        grid.cells = np.split(connectivity, offsets[1:-1])
    for source, target in (
        (data.GetPointData(), grid.point_data),
        (data.GetCellData(), grid.cell_data),
    ):
        for i in range(source.GetNumberOfArrays()):
            target[source.GetArrayName(i)] = vtk_to_numpy(source.GetArray(i)).astype(float)
    return grid


INDICES = ("body", "body_a", "body_b", "wall", "obstacle", "ring")
PLANE = (
    "velocity_m_per_s",
    "center_m",
    "pivot_m",
    "normal",
    "force_N_per_m",
    "image_m",
)  # three components in the file, two that count


def in_plane(name, values):
    """
    A vector without its third component, a number of a body or wall as a whole number.

    >>> in_plane("image_m", np.array([[1., 2., 0.]])).tolist()
    [[1.0, 2.0]]
    """
    if name in INDICES:
        return values.astype(int)
    return values[:, :2] if name in PLANE and values.ndim == 2 else values


def with_stress(data, prefix=""):
    """
    A stress as rows xx, yy, xy. VTU files have it as a tensor of nine components; those of
    softgrain 0.1 had an array for each component.

    >>> new = {"stress_Pa": np.array([[1., 3., 0., 3., 2., 0., 0., 0., 4.]])}
    >>> old = {f"stress_{c}_Pa": np.array([x])
    ...        for c, x in (("xx", 1.), ("yy", 2.), ("xy", 3.), ("zz", 4.))}
    >>> with_stress(new)
    {'stress_Pa': array([[1., 2., 3.]]), 'out_of_plane_stress_Pa': array([4.])}
    >>> sorted(with_stress(old)) == sorted(new)
    True
    >>> bool((old["stress_Pa"] == new["stress_Pa"]).all())
    True
    """
    name = f"{prefix}stress_Pa"
    parts = [f"{prefix}stress_{c}_Pa" for c in ("xx", "yy", "xy")]
    if all(part in data for part in parts):
        data[name] = np.stack([data.pop(part) for part in parts], axis=1)
        if f"{prefix}stress_zz_Pa" in data:
            data["out_of_plane_stress_Pa"] = data.pop(f"{prefix}stress_zz_Pa")
    elif name in data and data[name].ndim == 2 and data[name].shape[1] == 9:
        nine = data[name]
        data[name] = nine[:, [0, 4, 1]]
        if not prefix and nine[:, 8].any():
            data["out_of_plane_stress_Pa"] = nine[:, 8]
    return data


def points_of(grid):
    return with_stress(
        {"position_m": grid.points, **{n: in_plane(n, v) for n, v in grid.point_data.items()}}
    )


def contacts_of(grid):
    return {"place_m": grid.points, **{n: in_plane(n, v) for n, v in grid.point_data.items()}}


def walls_of(grid, names):
    """
    Walls. Their velocity is that along the normal; VTU files have it as a vector, those of
    softgrain 0.1 as a number.

    >>> down = {"normal": np.array([[0., -1., 0.]]), "velocity_m_per_s": np.array([[0., -2., 0.]])}
    >>> walls_of(Grid(cell_data=down), [])["velocity_m_per_s"]
    array([2.])
    """
    data = {n: in_plane(n, v) for n, v in grid.cell_data.items()}
    if data.get("velocity_m_per_s", np.zeros(0)).ndim == 2:
        data["velocity_m_per_s"] = np.einsum("ij,ij->i", data["velocity_m_per_s"], data["normal"])
    data["ends_m"] = np.array([grid.points[cell] for cell in grid.cells], dtype=float).reshape(
        -1, 2, 2
    )
    index = data.get("wall", np.arange(len(grid.cells)))
    if names and len(index) and index.max() < len(names):
        data = {"name": np.array(names)[index], **data}
    return data


def obstacles_of(grid, names):
    data = {n: in_plane(n, v) for n, v in grid.cell_data.items()}
    return {"name": np.array(names), **data} if len(names) == len(grid.cells) else data


def rings_of(grid):
    """{body: [closed outlines]} of a grid of outlines."""
    rings: Dict[int, Any] = {}
    for cell, body in zip(grid.cells, grid.cell_data.get("body", [])):
        vertices = grid.points[cell]
        if len(vertices) > 1 and np.array_equal(vertices[0], vertices[-1]):
            vertices = vertices[:-1]
        rings.setdefault(int(body), []).append(vertices)
    return rings


def bodies_of(grid):
    """One row per body, from the data of its first outline."""
    body = grid.cell_data.get("body", np.zeros(0)).astype(int)
    first = np.unique(body, return_index=True)[1]
    data = {
        n: in_plane(n, v)[first]
        for n, v in grid.cell_data.items()
        if n not in ("ring", "mean_pressure_Pa")
    }
    return with_stress(data, "mean_")


class FieldSource:
    """One frame of fields.pvd as a source of a state."""

    def __init__(self, frame, wall_names=(), obstacle_names=()):
        self.frame, self.wall_names, self.obstacle_names, self.grids = (
            frame,
            wall_names,
            obstacle_names,
            {},
        )

    def has(self, part):
        return {"bodies": "outlines"}.get(part, part) in self.frame.files

    def path(self, part):
        return self.frame.files.get(
            {"bodies": "outlines"}.get(part, part), f"frame {self.frame.number}"
        )

    def grid(self, name):
        if name not in self.grids:
            self.grids[name] = read_grid(self.frame.files[name])
        return self.grids[name]

    def forget(self):
        self.grids.clear()

    def table(self, part):
        make = {
            "points": points_of,
            "contacts": contacts_of,
            "bodies": bodies_of,
            "walls": lambda grid: walls_of(grid, self.wall_names),
            "obstacles": lambda grid: obstacles_of(grid, self.obstacle_names),
        }[part]
        return Table(make(self.grid({"bodies": "outlines"}.get(part, part))), part, self.path(part))

    def lines(self):
        grid = self.grid("obstacles")
        return [grid.points[cell] for cell in grid.cells]

    def rings(self):
        return rings_of(self.grid("outlines"))

    def vertices(self):
        return self.grid("outlines").points
