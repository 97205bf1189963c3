# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of runs in space (Dimension = 3): vectors of three components, surfaces of triangles."""

from functools import cached_property, partial

import numpy as np

from .contacts import PairRows, coordination_of
from .errors import InputError
from .fields import INDICES, read_grid
from .snapshots import SnapshotSource
from .state import State
from .tables import Table

TENSOR = ("xx", "yy", "zz", "xy", "xz", "yz")


class SpaceTable(Table):
    """A table whose vectors have three components."""

    COMPONENTS = {
        3: ("x", "y", "z"),
        6: TENSOR,
        9: ("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"),
    }


WIDTHS = {
    "position_m": 3,
    "velocity_m_per_s": 3,
    "center_m": 3,
    "place_m": 3,
    "normal": 3,
    "force_N": 3,
    "point_m": 3,
    "pivot_m": 3,
    "vertices_m": 3,
    "triangles": 3,
    "stress_Pa": 6,
    "mean_stress_Pa": 6,
    "deformation_gradient": 9,
}


def pressure(stress):
    """
    Mean of the normal stresses, compression positive, of rows xx, yy, zz, xy, xz, yz.

    >>> pressure(np.array([[-1.0, -2.0, -3.0, 5.0, 0.0, 0.0]]))
    array([2.])
    """
    return -stress[:, :3].mean(axis=1)


def von_mises(stress):
    """
    Von Mises stress of the same rows.

    >>> von_mises(np.array([[3.0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 1.0, 0]])).round(3)
    array([3.   , 1.732])
    """
    x, y, z = stress[:, :3].T
    shear = (stress[:, 3:] ** 2).sum(axis=1)
    return np.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3 * shear)


def logarithmic_strains(gradient):
    """
    Logarithms of the three principal stretches, the largest first, of rows F_xx, F_xy, …, F_zz.

    >>> logarithmic_strains(np.array([[1.0, 0, 0, 0, 2.0, 0, 0, 0, 0.5]]))[0].round(3)
    array([ 0.693,  0.   , -0.693])
    """
    with np.errstate(divide="ignore"):
        return np.log(np.linalg.svd(gradient.reshape(-1, 3, 3), compute_uv=False))


def equivalent_strain(logarithmic):
    """sqrt(2/3 e:e) of the deviator of the logarithmic strain."""
    deviator = logarithmic - logarithmic.mean(axis=1, keepdims=True)
    return np.sqrt(2 / 3 * (deviator**2).sum(axis=1))


def pairs_of(contacts):
    """
    One row per pair that touches, seen from the body with the smaller number: force, place weighted
    by it, normal and number of rows.

    >>> rows = Table({"body_a": np.array([1, 0]), "body_b": np.array([0, 1]),
    ...               "wall": np.array([-1, -1]), "place_m": np.array([[0., 1., 0.], [0., 3., 0.]]),
    ...               "normal": np.array([[1., 0., 0.], [-1., 0., 0.]]),
    ...               "force_N": np.array([[2., 0., 0.], [-2., 0., 0.]])})
    >>> pair = pairs_of(rows)
    >>> pair.body_a, pair.body_b, pair.normal_force_N, pair.place_m
    (array([0]), array([1]), array([4.]), array([[0., 2., 0.]]))
    """
    rows = PairRows(contacts, "force_N")
    keys, forces, normals = rows.keys, rows.total(rows.force), rows.total(rows.normal)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    return SpaceTable(
        {
            "body_a": keys[:, 0],
            "body_b": keys[:, 1],
            "wall": keys[:, 2],
            "place_m": rows.places(),
            "normal": normals,
            "force_N": forces,
            "normal_force_N": (forces * normals).sum(axis=1),
            "rows": rows.count.astype(int),
        },
        "pairs",
    )


class Surfaces:
    """
    The surfaces of the bodies: ``surfaces[b]`` is (vertices [m], triangles), whose corners run
    counter-clockwise when seen from outside. Those of obstacles are sheets.
    """

    def __init__(self, parts, one="body", several="bodies"):
        self.parts, self.one, self.several = parts, one, several

    def __getitem__(self, index):
        if not 0 <= index < len(self.parts):
            raise InputError(
                f"there is no surface of a {self.one} {index}; there are {len(self.parts)}"
                f" {self.several}"
            )
        return self.parts[index]

    def __len__(self):
        return len(self.parts)

    def __repr__(self):
        triangles = sum(len(t) for _, t in self.parts)
        return f"<surfaces of {len(self)} {self.several}, {triangles} triangles>"


class SpaceSnapshotSource(SnapshotSource):
    """One step of snapshots.h5 of a run in space."""

    widths, table_type = WIDTHS, SpaceTable

    def triangles(self, part):
        first, begin = (
            self.read(f"{part}/{name}") for name in ("vertex_offsets", "triangle_offsets")
        )
        vertices = np.split(self.read(f"{part}/vertices_m"), first[1:-1])
        triangles = np.split(self.read(f"{part}/triangles"), begin[1:-1])
        return list(zip(vertices, triangles))

    def surfaces(self):
        return Surfaces(self.triangles("surfaces"))

    def obstacle_surfaces(self):
        return Surfaces(self.triangles("obstacles"), "sheet", "obstacles")

    def vertices(self):
        return self.read("surfaces/vertices_m")


class SpaceFieldSource:
    """One frame of fields.pvd of a run in space; it has no walls and no energies."""

    FILES = {"bodies": "outlines", "surfaces": "outlines"}

    def __init__(self, frame):
        self.frame, self.grids = frame, {}

    def has(self, part):
        return part != "walls" and self.FILES.get(part, part) in self.frame.files

    def path(self, part):
        return self.frame.files.get(self.FILES.get(part, part), f"frame {self.frame.number}")

    def forget(self):
        self.grids.clear()

    def grid(self, part):
        name = self.FILES.get(part, part)
        if name not in self.grids:
            self.grids[name] = read_grid(self.frame.files[name], 3)
        return self.grids[name]

    def table(self, part):
        grid = self.grid(part)
        if part in ("bodies", "obstacles"):
            number = grid.cell_data["body" if part == "bodies" else "obstacle"].astype(int)
            first = np.unique(number, return_index=True)[1]
            data = {name: values[first] for name, values in grid.cell_data.items()}
        else:
            place = {"points": "position_m"}.get(part, "place_m")
            data = {place: grid.points, **grid.point_data}
        if "stress_Pa" in data:  # a tensor of nine components in the file
            data["stress_Pa"] = data["stress_Pa"][:, [0, 4, 8, 1, 2, 5]]
        data = {n: v.astype(int) if n in INDICES else v for n, v in data.items()}
        return SpaceTable(data, part, self.path(part))

    def triangles(self, part, number):
        grid = self.grid(part)
        owner = grid.cell_data[number].astype(int)
        triangles = np.array(grid.cells, dtype=int).reshape(-1, 3)
        parts = []
        for b in range(int(owner.max(initial=-1)) + 1):
            own = triangles[owner == b]
            used, corners = np.unique(own, return_inverse=True)
            parts.append((grid.points[used], corners.reshape(-1, 3)))
        return parts

    def surfaces(self):
        return Surfaces(self.triangles("surfaces", "body"))

    def obstacle_surfaces(self):
        return Surfaces(self.triangles("obstacles", "obstacle"), "sheet", "obstacles")

    def vertices(self):
        return self.grid("surfaces").points


class SpaceState(State):
    """
    A written state of a run in space. Vectors have three components, stresses six: xx, yy, zz, xy,
    xz, yz.
    """

    dimension = 3

    def forget(self):
        super().forget()
        self.__dict__.pop("surfaces", None)
        self.__dict__.pop("obstacle_surfaces", None)

    @cached_property
    def points(self):
        """Material points, one row each."""
        table = self.part("points")
        if "stress_Pa" in table:
            table.offer("von_mises_Pa", lambda: von_mises(table["stress_Pa"]))
            table.offer("pressure_Pa", lambda: pressure(table["stress_Pa"]))
            for i, name in enumerate(TENSOR):
                table.offer(f"stress_{name}_Pa", partial(lambda i: table["stress_Pa"][:, i], i))
        if "deformation_gradient" in table:

            def strains():
                return logarithmic_strains(table["deformation_gradient"])

            table.offer("equivalent_strain", lambda: equivalent_strain(strains()))
            table.offer("volume_strain", lambda: strains().sum(axis=1))
        return table

    @cached_property
    def bodies(self):
        """Bodies, one row each: place, volume, mean stress, number of contacts."""
        table = self.part("bodies")
        if "mean_stress_Pa" in table:
            table.offer("mean_pressure_Pa", lambda: pressure(table["mean_stress_Pa"]))
            table.offer("mean_von_mises_Pa", lambda: von_mises(table["mean_stress_Pa"]))
        if self.has("contacts"):
            table.offer("coordination", lambda: coordination_of(table["body"], self.pairs))
        return table

    @cached_property
    def contacts(self):
        """One row per place where surfaces meet; -1 stands for no body and no wall."""
        table = self.part("contacts")
        table.offer("normal_force_N", lambda: (table["force_N"] * table["normal"]).sum(axis=1))
        return table

    @cached_property
    def pairs(self):
        """One row for two bodies, or a body and a wall, that touch."""
        return pairs_of(self.contacts)

    @cached_property
    def walls(self):
        """Walls, one row each."""
        return self.part("walls")

    @cached_property
    def surfaces(self):
        """Surfaces of the bodies."""
        if not self.has("surfaces"):
            self.part("surfaces")  # says that there are none
        return self.source.surfaces()

    @cached_property
    def obstacle_surfaces(self):
        """The sheets of the obstacles; none in a scene without obstacles."""
        if not self.has("obstacles"):
            return Surfaces([], "sheet", "obstacles")
        return self.source.obstacle_surfaces()

    def box(self):
        """
        Lengths between the walls left and right, front and back, bottom and top [m]; None without
        them.
        """
        if not self.has("walls"):
            return None
        sides = (("left", "right"), ("front", "back"), ("bottom", "top"))
        row = {name: i for i, name in enumerate(self.walls["name"].tolist())}
        if not all(side in row for pair in sides for side in pair):
            return None
        point, normal = self.walls["point_m"], self.walls["normal"]
        return tuple(float((point[row[b]] - point[row[a]]) @ normal[row[a]]) for a, b in sides)

    def refuse(self, what):
        raise InputError(f"{what} of runs in space ('Dimension' = '3') is not there yet")

    @property
    def outlines(self):
        """Bodies in space have surfaces."""
        return self.refuse("an outline")

    @property
    def loads(self):
        """Not there yet: pairs have the forces."""
        return self.refuse("a table of loads")

    @property
    def contact_pressures(self):
        """Not there yet."""
        return self.refuse("the pressure along contacts")

    def contact_profile(self, body, partner, smooth=True):
        """Not there yet."""
        return self.refuse("the pressure along a contact")

    def to_pyvista(self, part="points"):
        """Not there yet: fields.pvd can be opened."""
        return self.refuse("a mesh")

    to_vtk = to_pyvista

    def to_vtp(self, path, part="points"):
        """Not there yet: fields.pvd can be opened."""
        return self.refuse("a file for ParaView")

    def to_xarray(self):
        """Not there yet."""
        return self.refuse("a dataset")

    def to_lammps_dump(self, path):
        """Of primaries, which are in the plane."""
        return self.refuse("a LAMMPS dump")


__all__ = ["SpaceFieldSource", "SpaceSnapshotSource", "SpaceState", "Surfaces"]
