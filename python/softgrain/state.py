# SPDX-License-Identifier: LGPL-2.1-or-later
"""One state of a run: bodies, points, contacts, walls and outlines at one time."""

from functools import cached_property

import numpy as np

from . import contacts as pairing
from . import kinematics
from .errors import InputError
from .loads import loads_of, resultants
from .outlines import Outlines
from .profiles import pressures_of, profile_of


class State:
    """
    A written state of a run, from snapshots.h5 or fields.pvd. Its tables have numpy columns with
    the unit in the name:

    >>> state = example[-1]
    >>> state.bodies.center_m.shape
    (2, 2)
    >>> state.bodies.units["area_m2"]
    'm²'
    >>> sorted(state.walls.name.tolist())
    ['bottom', 'left', 'right', 'top']
    >>> bool(state.points.von_mises_Pa.max() > 0)
    True
    """

    dimension = 2

    def __init__(self, run, source, number, time):
        self.run, self.source, self.number, self.time = run, source, number, time

    def __repr__(self):
        return f"<state {self.number} of {self.run.directory} at t = {self.time:g} s>"

    def has(self, part):
        """
        Whether 'bodies', 'points', 'contacts', 'walls', 'obstacles' or 'outlines' were written.
        """
        return self.source.has("contacts" if part == "contact_pressures" else part)

    def forget(self):
        """Frees what was read: of a long film only one state stays in memory."""
        for name in (
            "points",
            "bodies",
            "outlines",
            "contacts",
            "pairs",
            "loads",
            "contact_pressures",
            "walls",
            "obstacles",
            "obstacle_lines",
            "energies",
        ):
            self.__dict__.pop(name, None)
        self.source.forget()

    def part(self, name):
        if not self.has(name):
            raise InputError(
                f"state {self.number} of {self.run.directory} has no {name}: they were not written"
                " (see the section Output of its parameters)"
            )
        return self.source.table(name)

    @cached_property
    def points(self):
        """Material points or primaries, one row each."""
        table = self.part("points")
        kinematics.add_stresses(table)
        kinematics.add_strains(table)
        return table

    @cached_property
    def bodies(self):
        """
        Bodies, one row each: place of the centre of mass, velocity, area, mean stress, number of
        contacts.
        """
        table = self.part("bodies")
        if "mean_stress_Pa" in table:
            table["mean_pressure_Pa"] = lambda: -table["mean_stress_Pa"][:, :2].mean(axis=1)
        if self.has("contacts") and "body" in table:
            table["coordination"] = lambda: pairing.coordination_of(table["body"], self.pairs)
            for column, name in (
                ("contact_force_N_per_m", "force_N_per_m"),
                ("contact_torque_N", "torque_N"),
            ):
                table[column] = lambda name=name: resultants(table["body"], self.loads, name)
        return table

    @cached_property
    def contacts(self):
        """One row per place where surfaces meet; -1 stands for no body and no wall."""
        table = self.part("contacts")
        if "force_N_per_m" in table and "normal" in table:

            def along(turn):
                force, normal = table["force_N_per_m"], table["normal"]
                return (
                    force[:, 0] * normal[:, turn]
                    + (-1 if turn else 1) * force[:, 1] * normal[:, 1 - turn]
                )

            for name, turn in (("normal_force_N_per_m", 0), ("tangential_force_N_per_m", 1)):
                if name not in table:
                    table[name] = lambda turn=turn: along(turn)
        return table

    @cached_property
    def pairs(self):
        """
        Contacts as the measures count them: one row for two bodies, or a body and a wall, that
        touch.
        """
        return pairing.pairs_of(self.contacts)

    @cached_property
    def loads(self):
        """
        What each body feels from each of its partners: force, and torque about its centre of mass.
        """
        return loads_of(self)

    @cached_property
    def contact_pressures(self):
        """Pressure and traction along all contacts, see :func:`softgrain.profiles.pressures_of`."""
        return pressures_of(self)

    def contact_profile(self, body, partner, smooth=True):
        """
        Pressure and traction along the contact of a body with another one, a wall or an obstacle,
        told by their names: see :func:`softgrain.profiles.profile_of`.
        """
        return profile_of(self, body, partner, smooth)

    @cached_property
    def walls(self):
        """Walls, one row each; ``ends_m`` is the line that a picture shows."""
        table = self.part("walls")
        if "ends_m" not in table and "point_m" in table:
            table["ends_m"] = lambda: kinematics.wall_ends(table, self.outlines.points_m)
        return table

    @cached_property
    def obstacles(self):
        """Obstacles, one row each: place of the pivot, angle, force, torque."""
        return self.part("obstacles")

    @cached_property
    def obstacle_lines(self):
        """The line of every obstacle, arrays of x, y [m]; none in a scene without obstacles."""
        return self.source.lines() if self.has("obstacles") else []

    @cached_property
    def outlines(self):
        """Outlines of the bodies."""
        if not self.has("outlines"):
            self.part("outlines")  # says that there are none
        return Outlines(self.source.rings())

    @cached_property
    def energies(self):
        """Energies of a snapshot {name: J/m}."""
        if not hasattr(self.source, "energies"):
            raise InputError(
                f"energies are in snapshots.h5 and history.csv, and state {self.number} is of"
                " fields.pvd"
            )
        return self.source.energies()

    @property
    def measures(self):
        """The row of measures.csv of this time, {name: number}."""
        table = self.run.measures_table
        row = int(np.argmin(np.abs(table["time_s"] - self.time))) if len(table) else -1
        if row < 0 or abs(table["time_s"][row] - self.time) > 1e-9 * max(
            abs(self.time), table["time_s"].max()
        ):
            raise InputError(
                f"{self.run.directory}/measures.csv has no row at t = {self.time:g} s: measures are"
                " taken with snapshots"
            )
        return {name: float(values[row]) for name, values in table.items()}

    @property
    def strain(self):
        """Axial strain ln(h0/h), of history.csv; None when it does not say."""
        return self.run.strain_at(self.time)

    def box(self):
        """Width and height between the walls left, right, bottom and top [m]; None without them."""
        names = list(self.walls["name"]) if "name" in self.walls else []
        if not {"left", "right", "bottom", "top"} <= set(names):
            return None
        center = (
            self.walls["point_m"] if "point_m" in self.walls else self.walls["ends_m"].mean(axis=1)
        )
        row = {name: names.index(name) for name in ("left", "right", "bottom", "top")}
        return tuple(
            float((center[row[b]] - center[row[a]]) @ self.walls["normal"][row[a]])
            for a, b in (("left", "right"), ("bottom", "top"))
        )

    def plot(self, field=None, **options):
        """
        A picture of the grains as `softgrain render` draws it; returns the matplotlib figure.
        Options are those of the command: field, contacts, attraction, style, range, colours, zoom,
        title, width, in space view and cut; of a list of fields there is a picture each, one beside
        the other.
        """
        from .picture import Options, picture_of

        field = field if field is None or isinstance(field, str) else ",".join(field)
        return picture_of(Options(field=field, **options), [self]).figure(self)

    def to_xarray(self):
        """
        An xarray.Dataset with the dimensions body, point, contact and wall, and units as
        attributes.
        """
        from .export import state_to_xarray

        return state_to_xarray(self)

    def to_pyvista(self, part="points"):
        """
        A pyvista mesh of the 'points', 'outlines', 'contacts', 'contact_pressures' or 'walls' with
        all data that they have.
        """
        from .vtk import to_pyvista

        return to_pyvista(self, part)

    def to_vtk(self, part="points"):
        """The same as VTK's own vtkPolyData, which needs no pyvista."""
        from .vtk import to_vtk

        return to_vtk(self, part)

    def to_vtp(self, path, part="points"):
        """
        The same as a file that ParaView opens: `state.to_vtp("pressures.vtp",
        "contact_pressures")`.
        """
        from .vtk import write_vtp

        return write_vtp(self, part, path)

    def to_lammps_dump(self, path):
        """A LAMMPS dump of the primaries, which OVITO opens."""
        from .lammps import write_dump

        return write_dump([self], path)


__all__ = ["Outlines", "State"]
