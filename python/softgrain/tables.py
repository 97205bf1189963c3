# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Tables of numpy columns: history.csv, measures.csv, and what a state has per body, point or contact.
"""

import csv
import os
from typing import Any, List

import numpy as np

from .errors import InputError, MissingName, told_instead
from .units import full_name, split_unit

WORDS = ("material", "name", "shape")  # columns of tables that are no numbers
COMPONENTS = {2: ("x", "y"), 3: ("xx", "yy", "xy"), 4: ("xx", "xy", "yx", "yy")}


class Table:
    """
    Columns by name, each a numpy array with one row per thing; ``units`` tells the units. Where the
    name is clear, the unit may be left out. Columns are read when they are asked for.

    >>> t = Table({"center_m": np.array([[0., 0.], [1., 2.]]),
    ...            "area_m2": np.array([3., 4.])}, "bodies")
    >>> t["area_m2"], t.area
    (array([3., 4.]), array([3., 4.]))
    >>> t.units
    {'center_m': 'm', 'area_m2': 'm²'}
    >>> len(t)
    2
    >>> list(t.flat())
    ['center_x_m', 'center_y_m', 'area_m2']
    """

    COMPONENTS = COMPONENTS  # names of the components of rows of so many numbers

    def __init__(self, columns, title="table", path="", units=None):
        self._columns, self._title, self._path, self._units = (
            dict(columns),
            title,
            path,
            dict(units or {}),
        )

    def __getitem__(self, name):
        full = self.resolve(name)
        if full is None:
            where = f"{self._title} of {self._path}" if self._path else self._title
            raise MissingName(f"there is no '{name}' in {where}; {told_instead(name, self)}")
        value = self._columns[full]
        if callable(value):
            value = self._columns[full] = value()
        return value

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except MissingName as error:
            raise AttributeError(str(error)) from None

    def __dir__(self):
        return [
            *super().__dir__(),
            *self._columns,
            *(split_unit(name)[0] for name in self._columns),
        ]

    def __setitem__(self, name, values):
        self._columns[name] = values

    def offer(self, name, values):
        """Sets a column where there is none of this name."""
        if name not in self._columns:
            self._columns[name] = values

    def __contains__(self, name):
        return name in self._columns

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self[next(iter(self._columns))]) if self._columns else 0

    def __repr__(self):
        lines = [f"<{self._title}: {len(self)} rows>"]
        for name in self._columns:
            unit, shape = self.unit(name), np.shape(self[name])[1:]
            lines.append(
                f"  {name}"
                + (f" ({' x '.join(map(str, shape))})" if shape else "")
                + (f" [{unit}]" if unit else "")
            )
        return "\n".join(lines)

    def resolve(self, name):
        """The full name of a column, with its unit; None when there is no such column."""
        return full_name(name, self._columns)

    def keys(self):
        return self._columns.keys()

    def items(self):
        return [(name, self[name]) for name in self._columns]

    def get(self, name, default=None):
        return self[name] if self.resolve(name) else default

    @property
    def path(self):
        """The file it was read from."""
        return self._path

    @property
    def title(self):
        """Name of the file or part."""
        return self._title

    @property
    def columns(self):
        """Names of the columns."""
        return list(self._columns)

    @property
    def units(self):
        """Unit of every column, '' for pure numbers."""
        return {name: self.unit(name) for name in self._columns}

    def unit(self, name):
        """The unit that the file gives to a column, else that which the end of its name says."""
        return self._units.get(name, split_unit(name)[1])

    def where(self, mask):
        """The rows for which @mask is true, as a table."""
        return type(self)(
            {name: values[mask] for name, values in self.items()},
            self._title,
            self._path,
            self._units,
        )

    def flat(self):
        """
        {name: column} with vectors and tensors taken apart: center_m becomes center_x_m and
        center_y_m.
        """
        result = {}
        for name, values in self.items():
            if values.ndim == 1:
                result[name] = values
                continue
            base, unit = split_unit(name)
            suffix = name[len(base) :] if unit else ""
            labels = self.COMPONENTS.get(values.shape[1], [str(i) for i in range(values.shape[1])])
            for i, label in enumerate(labels):
                result[f"{base}_{label}{suffix}"] = values[:, i]
        return result

    def to_csv(self, path):
        """
        Writes a table of commas, one row per thing, whole or not at all; numbers are written in
        full.
        """
        flat = self.flat()
        temporary = os.path.join(os.path.dirname(path), ".part-" + os.path.basename(path))
        with open(temporary, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(flat)
            for row in zip(*(column.tolist() for column in flat.values())):
                writer.writerow(
                    ["" if value != value else value for value in row]
                )  # not a number: empty
        os.replace(temporary, path)
        return path

    def to_pandas(self):
        """
        A pandas.DataFrame that finds columns as this table does; ``attrs["units"]`` holds the
        units.
        """
        try:
            import pandas  # noqa: F401

            from .frame import Frame
        except ImportError as error:
            from .errors import need

            raise need("python3-pandas", error) from error
        flat = self.flat()
        frame = Frame(flat)
        frame.attrs["units"] = {name: split_unit(name)[1] for name in flat}
        return frame


def as_frame(table):
    """A pandas.DataFrame when pandas is installed, else the table itself."""
    try:
        import pandas  # noqa: F401
    except ImportError:
        return table
    return table.to_pandas()


def number(text):
    return float(text) if text else np.nan


def read_table(path):
    """
    A file like history.csv, or the table of a packing; fields that are empty are NaN, and the
    columns WORDS hold words.

    A last row that is still being written is left out.
    """
    folder, name = os.path.split(path)
    if not os.path.isdir(folder or "."):
        raise InputError(f"there is no folder {folder}")
    if not os.path.exists(path):
        raise InputError(f"{folder} has no {name}")
    with open(path, newline="", encoding="utf-8") as file:
        text = file.read()
    rows = list(csv.reader(text.splitlines()))
    if not rows:
        raise InputError(f"{path} is empty")
    names = [name.strip() for name in rows[0]]
    kinds: List[Any] = [str if name in WORDS else number for name in names]
    values = []
    for line, row in enumerate(rows[1:], start=2):
        if len(row) != len(names):
            if line == len(rows):
                break
            raise InputError(
                f"{path} line {line} has {len(row)} fields where the first line names {len(names)}"
            )
        if line == len(rows) and not text.endswith("\n"):
            break  # its last number may not be whole
        try:
            values.append([kind(item.strip()) for kind, item in zip(kinds, row)])
        except ValueError as error:
            raise InputError(f"{path} line {line}: {error}") from error
    columns = zip(*values) if values else [()] * len(names)
    return Table(
        {
            one: np.array(column, dtype=str if one in WORDS else float)
            for one, column in zip(names, columns)
        },
        name,
        path,
    )
