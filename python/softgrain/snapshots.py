# SPDX-License-Identifier: LGPL-2.1-or-later
"""snapshots.h5: states in full precision."""

import os
from functools import partial
from typing import Any, Callable, Dict

import numpy as np

from .errors import InputError, MissingName, need
from .tables import Table

NOBODY = 4294967295
WIDTHS = {
    "position_m": 2,
    "velocity_m_per_s": 2,
    "center_m": 2,
    "place_m": 2,
    "normal": 2,
    "force_N_per_m": 2,
    "point_m": 2,
    "points_m": 2,
    "pivot_m": 2,
    "image_m": 2,
    "stress_Pa": 3,
    "mean_stress_Pa": 3,
    "deformation_gradient": 4,
}
# Arrays that tell where obstacles are, for all of them together.
LINES = (
    "line_offsets",
    "points_m",
    "vertex_offsets",
    "triangle_offsets",
    "vertices_m",
    "triangles",
)
# Names of arrays in files of softgrain 0.2.0 and before, and those that fields.pvd and history.csv
# have.
OLD_NAMES = {
    "size_m2": "area_m2",
    "kinetic_J_per_m": "kinetic_energy_J_per_m",
    "elastic_J_per_m": "elastic_energy_J_per_m",
    "dissipated_J_per_m": "dissipated_energy_J_per_m",
}


def shown_name(name):
    """The name of an array in a table, whatever the version of the file."""
    return OLD_NAMES.get(name, name.removeprefix("extra/"))


class Energies(dict):
    """Energies by their names; one that does not exist is told with those that do."""

    def __missing__(self, name):
        raise MissingName(
            f"there is no energy '{name}'; "
            + (
                f"did you mean '{shown_name(name)}'?"
                if name in OLD_NAMES
                else f"there are {', '.join(self)}"
            )
        )


def open_file(path):
    try:
        import h5py
    except ImportError as error:
        raise need("python3-h5py", error) from error
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise InputError(f"{path} is damaged: {error}") from error


def read_times(directory):
    """Times of the snapshots; none without snapshots.h5."""
    path = os.path.join(directory, "snapshots.h5")
    if not os.path.exists(path):
        return np.zeros(0)
    with open_file(path) as file:
        try:
            return np.array(file["time_s"][()], dtype=float)
        except KeyError as error:
            raise InputError(f"{path} is damaged: {error}") from error


class SnapshotSource:
    """One step of snapshots.h5 as a source of a state; arrays are read when they are asked for."""

    widths, table_type = WIDTHS, Table

    def __init__(self, directory, number):
        self.file = os.path.join(directory, "snapshots.h5")
        self.number = number
        self.group = f"steps/{number:06d}"

    def path(self, _part):
        return f"{self.file}, step {self.number}"

    def read(self, name):
        with open_file(self.file) as file:
            try:
                return self.converted(name, file[f"{self.group}/{name}"][()])
            except (KeyError, OSError) as error:
                raise InputError(f"{self.file} is damaged: {error}") from error

    @classmethod
    def converted(cls, name, values):
        if values.dtype.kind in "OS":
            return np.array(
                [item.decode() if isinstance(item, bytes) else item for item in values.ravel()]
            )
        width = cls.widths.get(name.rsplit("/", 1)[-1])
        if values.dtype.kind == "u":
            signed = values.astype(np.int64)
            signed = np.where(signed == NOBODY, -1, signed)
            return signed.reshape(-1, width) if width else signed
        if name in ("walls/position_m", "walls/velocity_m_per_s"):  # along the normal
            return values
        return values.reshape(-1, width) if width else values

    def forget(self):
        """Nothing is kept here."""

    def units(self, part):
        """Units that the file gives to its arrays; files of softgrain 0.1 give none."""
        found = {}

        def note(name, item):
            if "units" in getattr(item, "attrs", ()):
                text = item.attrs["units"]
                text = text.decode() if isinstance(text, bytes) else str(text)
                found[shown_name(name)] = (
                    ""
                    if text == "1"
                    else text.replace("^2", "²").replace("^3", "³").replace("byte", "B")
                )

        with open_file(self.file) as file:
            if part in file[self.group]:
                file[self.group][part].visititems(note)
        return found

    def names(self, part):
        with open_file(self.file) as file:
            try:
                group = file[self.group]
            except (KeyError, OSError) as error:
                raise InputError(f"{self.file} is damaged: {error}") from error
            if part not in group:
                return {}
            found = {}
            for name, item in group[part].items():
                if name == "extra":
                    found.update({f"extra/{other}": len(values) for other, values in item.items()})
                elif name != "extra_names":
                    found[name] = len(item)
            return found

    def has(self, part):
        return bool(self.names(part))

    def table(self, part):
        sizes = self.names(part)
        key = {
            "points": "position_m",
            "bodies": "center_m",
            "contacts": "place_m",
            "walls": "name",
            "obstacles": "name",
        }[part]
        n_rows = sizes.get(key, max(sizes.values(), default=0))
        columns: Dict[str, Callable[[], Any]] = {}
        for name, size in sorted(
            sizes.items(), key=lambda item: (item[0] not in (key, "name"), shown_name(item[0]))
        ):
            if size == 0 and n_rows > 0:
                continue  # what this model does not have
            if part == "obstacles" and name in LINES:
                continue  # see lines() and, in space, obstacle_surfaces()
            columns[shown_name(name)] = partial(self.read, f"{part}/{name}")
        if part == "bodies":
            columns = {"body": lambda: np.arange(n_rows), **columns}
        if part == "walls":
            columns["wall"] = lambda: np.arange(n_rows)
        return self.table_type(columns, part, self.path(part), self.units(part))

    def lines(self):
        """The lines of the obstacles."""
        offsets = self.read("obstacles/line_offsets")
        return np.split(self.read("obstacles/points_m"), offsets[1:-1])

    def rings(self):
        vertices, rings, bodies = (
            self.read(f"outlines/{name}") for name in ("points_m", "ring_offsets", "body_offsets")
        )
        return {
            b: [vertices[rings[r] : rings[r + 1]] for r in range(bodies[b], bodies[b + 1])]
            for b in range(len(bodies) - 1)
            if bodies[b + 1] > bodies[b]
        }

    def energies(self):
        return Energies(
            {
                shown_name(name): float(np.ravel(self.read(f"energies/{name}"))[0])
                for name in self.names("energies")
            }
        )

    def vertices(self):
        return self.read("outlines/points_m")
