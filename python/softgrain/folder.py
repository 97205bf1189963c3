# SPDX-License-Identifier: LGPL-2.1-or-later
"""An output folder of softgrain, of a run that has ended or still goes on."""

import json
import os
from typing import Any, Dict

import numpy as np

from .errors import InputError, MissingName, near_names
from .fields import FieldSource, read_series
from .parameters import read_parameters
from .snapshots import SnapshotSource, read_times
from .space import SpaceFieldSource, SpaceSnapshotSource, SpaceState
from .state import State
from .tables import as_frame, read_table


def stamp(path):
    """What changes when a file does; None when there is none."""
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


class Run:
    """
    The output folder of a run. What is asked for is read anew when the files have changed, so that
    a run may be watched.

    >>> example.parameters["Materials/gel/Law"]
    'neo_hookean'
    >>> len(example) == len(example.times) and bool(example.times[0] == 0)
    True
    >>> example[0]  # doctest: +ELLIPSIS
    <state 0 of ... at t = 0 s>
    >>> float(max(example.history["top_force_N_per_m"])) > 0
    True

    States come from snapshots.h5, in full precision, or without it from fields.pvd; `fields` and
    `snapshots` are the run with the states of either.
    """

    def __init__(self, directory, source=None):
        self.directory = os.fspath(directory)
        if not os.path.isdir(self.directory):
            raise InputError(f"there is no folder {self.directory}")
        if source not in (None, "snapshots", "fields"):
            raise InputError(f"source is '{source}'; it can be 'snapshots' or 'fields'")
        self._source = source
        self._cache: Dict[str, Any] = {}
        self.log: Any = None  # what the program said, of a run that was started from here
        self.changes: Any = None  # of a run of a sweep

    def __repr__(self):
        return (
            f"<run {self.directory}: {len(self)} states in {self.source or 'no file'},"
            f" {self.status or 'no summary'}>"
        )

    def path(self, name):
        return os.path.join(self.directory, name)

    def cached(self, name, read):
        """What @read makes of a file, made again when the file is another one."""
        key = stamp(self.path(name))
        if name not in self._cache or self._cache[name][0] != key:
            self._cache[name] = key, read()
        return self._cache[name][1]

    # --- tables ---

    def table(self, name):
        """A file of the folder like history.csv as columns of numpy arrays."""
        return self.cached(name, lambda: read_table(self.path(name)))

    @property
    def history_table(self):
        """history.csv as columns of numpy arrays."""
        return self.table("history.csv")

    @property
    def measures_table(self):
        """measures.csv as columns of numpy arrays."""
        if not os.path.exists(self.path("measures.csv")):
            raise InputError(
                f"{self.directory} has no measures.csv: set Output/Measures, or run 'softgrain"
                f" measure {self.directory}' when there are snapshots"
            )
        return self.table("measures.csv")

    @property
    def history(self):
        """
        history.csv: a pandas.DataFrame when pandas is installed, else a table of numpy columns.
        """
        return as_frame(self.history_table)

    @property
    def measures(self):
        """measures.csv, as history."""
        return as_frame(self.measures_table)

    def column(self, name):
        """
        (column, table it is from) by its name in history.csv or measures.csv; the unit may be left
        out.

        A column that measures.csv does not have but history.csv has belongs to history.csv.
        """
        tables = [self.history_table] if os.path.exists(self.path("history.csv")) else []
        tables += [self.measures_table] if os.path.exists(self.path("measures.csv")) else []
        for table in tables:
            if full := table.resolve(name):
                return table[full], table
        known = [one for table in tables for one in table]
        near = near_names(name, known)
        text = f"there is no column '{name}' in {self.path('history.csv')}" + (
            " and measures.csv" if len(tables) > 1 else ""
        )
        if near:
            text += f"; did you mean {near}?"
        elif tables:
            text += f"; there are {', '.join(tables[0])}" + (
                "; 'softgrain plot DIR --list' names those of measures.csv, too"
                if len(tables) > 1
                else ""
            )
        raise MissingName(text)

    @property
    def parameters(self):
        """parameters.prm with all defaults, by names as 'Contact/Friction'."""
        return self.cached("parameters.prm", lambda: read_parameters(self.directory))

    @property
    def summary(self):
        """summary.json, None without it."""
        try:
            with open(self.path("summary.json"), encoding="utf-8") as file:
                found = json.load(file)
        except FileNotFoundError:
            return None
        except ValueError as error:
            raise InputError(f"{self.path('summary.json')} is damaged: {error}") from error
        if not isinstance(found, dict):
            raise InputError(f"{self.path('summary.json')} is damaged: it holds no object")
        return found

    @property
    def status(self):
        """
        'running', 'completed', 'interrupted' or 'failed', as summary.json says; None without it. A
        run that was killed had no time to say so: it is still 'running'.
        """
        return (self.summary or {}).get("status")

    @property
    def finished(self):
        """Whether the run has come to its end."""
        return self.status == "completed"

    @property
    def dimension(self):
        """2, or 3 of a run in space."""
        if not os.path.exists(self.path("parameters.prm")):
            return 2
        return int(self.parameters.get("Dimension", 2))

    @property
    def model(self):
        """'mpm' or 'bpm'."""
        return str(self.parameters.get("Model", "mpm")).lower()

    # --- states ---

    @property
    def source(self):
        """Where states come from: 'snapshots', 'fields', or None when neither is there."""
        if self._source:
            return self._source
        if os.path.exists(self.path("snapshots.h5")):
            return "snapshots"
        return "fields" if os.path.exists(self.path("fields.pvd")) else None

    @property
    def fields(self):
        """This run with the states of fields.pvd."""
        return Run(self.directory, "fields")

    @property
    def snapshots(self):
        """This run with the states of snapshots.h5."""
        return Run(self.directory, "snapshots")

    def for_pictures(self):
        """The run with the states of fields.pvd, or of snapshots.h5 when there are no fields."""
        if self.dimension == 3 and len(self):
            return self
        if (
            self.source == "snapshots"
            and os.path.exists(self.path("fields.pvd"))
            and len(self.fields)
        ):
            return self.fields
        if self.source is None:
            self.fields.frames()  # says what is missing
        if len(self) == 0:
            raise InputError(f"{self.path('fields.pvd')} has no frames yet")
        return self

    @property
    def times(self):
        """Times of the states [s]."""
        if self.source == "snapshots":
            return self.cached("snapshots.h5", lambda: read_times(self.directory))
        if self.source == "fields" and os.path.exists(self.path("fields.pvd")):
            return np.array([frame.time for frame in self.frames()])
        return np.zeros(0)

    def frames(self):
        return self.cached("fields.pvd", lambda: read_series(self.directory))

    def __len__(self):
        return len(self.times)

    def __getitem__(self, number):
        if isinstance(number, slice):
            return [self[i] for i in range(*number.indices(len(self)))]
        n = len(self)
        if n == 0:
            missing = {
                "snapshots": "no snapshots",
                "fields": "no frames in fields.pvd",
                None: "no states",
            }[self.source]
            raise InputError(
                f"{self.directory} has {missing} yet: see Output/Snapshots every and Output/Fields"
                " every"
            )
        if not -n <= number < n:
            raise IndexError(f"{self.directory} has the states 0 to {n - 1}, not {number}")
        number = int(number) % n
        if self.dimension == 3:
            from_file = self.source == "snapshots"
            space = (
                SpaceSnapshotSource(self.directory, number)
                if from_file
                else SpaceFieldSource(self.frames()[number])
            )
            return SpaceState(self, space, number, float(self.times[number]))
        if self.source == "snapshots":
            return State(
                self, SnapshotSource(self.directory, number), number, float(self.times[number])
            )
        frame = self.frames()[number]
        return State(
            self,
            FieldSource(frame, self.parameters.names("Walls"), self.parameters.names("Obstacles")),
            number,
            frame.time,
        )

    def __iter__(self):
        return (self[i] for i in range(len(self)))

    def at(self, time):
        """The state whose time is nearest."""
        return self[int(np.argmin(np.abs(self.times - time)))] if len(self) else self[0]

    # --- what several commands need ---

    def value_at(self, column, time):
        """
        A column of history.csv or measures.csv at a time, by a straight line between rows; None
        when it does not say.
        """
        try:
            values, table = self.column(column)
            times = table["time_s"]
        except InputError:
            return None
        known = np.isfinite(values)
        return float(np.interp(time, times[known], values[known])) if known.any() else None

    def at_forces(self, name):
        """
        A column of history.csv at the instants that the forces in its rows belong to, by straight
        lines between rows: draw forces against this.

        With inertia the force of a row is one for all of the step before it, and belongs to some
        instant within (column force_time_s); all else in the row is of the end of the step.

        >>> strain, table = example.at_forces("axial_strain"), example.history_table
        >>> bool((strain <= table["axial_strain"]).all())
        True
        """
        values, table = self.column(name)
        if table is not self.history_table or "force_time_s" not in table:
            return values
        known = np.isfinite(values)
        if not known.any():
            return values
        found = np.interp(table["force_time_s"], table["time_s"][known], values[known])
        return np.where(np.isfinite(table["force_time_s"]) & known, found, values)

    def strain_at(self, time):
        """ln(h0/h) at a time; None when history.csv does not say."""
        return self.value_at("axial_strain", time)

    @property
    def coordinate(self):
        """
        The column that the scene itself goes by: 'packing_fraction', 'axial_strain' or
        'shear_strain', by what ends it, or what changes; None where there is only the time.
        """
        from .coordinate import coordinate_of

        return coordinate_of(self)

    def widths(self, times):
        """
        How far the bodies reach from left to right at @times [m]: from a column width_m of
        history.csv, or from the outlines of the states.
        """
        if os.path.exists(self.path("history.csv")) and "width_m" in self.history_table:
            return np.interp(times, self.history_table["time_s"], self.history_table["width_m"])
        for states in (self.snapshots, self.fields):
            if not os.path.exists(
                self.path({"snapshots": "snapshots.h5", "fields": "fields.pvd"}[states.source])
            ):
                continue
            found = [
                (state.time, np.ptp(points[:, 0]))
                for state in states
                if state.has("outlines") and len(points := state.source.vertices())
            ]
            if found:
                return np.interp(times, *zip(*found))
        raise InputError(
            f"{self.directory} does not say how wide the grain is: neither a column width_m in"
            " history.csv nor outlines in snapshots.h5 or fields.pvd"
        )

    def loads_on(self, body):
        """
        What a body, by its number or name, feels from each partner in all states, as a table:
        time_s, partner_name, force, torque.
        """
        from .loads import loads_on

        return loads_on(self, body)

    def plot(self, *columns, x=None, axes=None, **style):
        """
        Columns of history.csv or measures.csv as curves; returns matplotlib's axes. Without a name:
        those that `softgrain plot` would take.
        """
        from .curves import plot_columns

        return plot_columns(self, columns, x, axes, style)

    def to_xarray(self):
        """
        Bodies and walls of all states as an xarray.Dataset with the dimensions time, body and wall.
        """
        from .export import run_to_xarray

        return run_to_xarray(self)

    def to_pvd(self, path, part="outlines"):
        """
        A part of all states, see State.to_vtp, as a series that ParaView plays:
        `run.to_pvd("pressures.pvd", "outlines")`.
        """
        from .vtk import write_pvd

        return write_pvd(self, part, path)

    def to_lammps_dump(self, path):
        """A LAMMPS dump of the primaries of all states, which OVITO opens as a film."""
        from .lammps import write_dump

        return write_dump(list(self), path)


def open_run(directory, source=None):
    """
    Opens an output folder; see Run.

    >>> run = open_run(example.directory)
    >>> run.finished
    True
    """
    return Run(directory, source)
