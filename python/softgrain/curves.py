# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of history.csv and measures.csv, of one run or of several side by side."""

import os
import re
from typing import Dict, List

import matplotlib.pyplot as plt
import numpy as np

from .drawing import STYLE
from .errors import InputError
from .units import describe, scaled_unit, split_unit, with_unit

COLOURS = [
    "#0072B2",
    "#D55E00",
    "#009E73",
    "#CC79A7",
    "#E69F00",
    "#56B4E9",
    "#5a5a5a",
]  # told apart by everyone
DASHES = ["-", (0, (5, 1.6)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5))]
DIAMETRAL = "mean_stress_F_over_L_Pa"


class Curves:
    """
    The columns of a run by name, those of measures.csv too, and the stress F/L of a grain between
    two walls.
    """

    def __init__(self, run, label=None):
        self.run, self.label, self.own = (
            run,
            label or os.path.basename(os.path.normpath(run.directory)),
            {},
        )

    def find(self, name):
        """(column, the table that it belongs to)."""
        if name == DIAMETRAL:
            if name not in self.own:
                force, history = self.run.column("bottom_force_N_per_m")
                self.own[name] = force / self.width(history["time_s"]), history
            return self.own[name]
        return self.run.column(name)

    def width(self, times=None):
        return self.run.widths(self.run.history_table["time_s"] if times is None else times)

    def full_name(self, name):
        """The name with its unit."""
        if name == DIAMETRAL:
            return name
        values, table = self.run.column(name)
        return next(full for full in table if table[full] is values)

    def values(self, name):
        return self.find(name)[0]

    def pair(self, x, y):
        """
        x and y row by row, x at the instants of forces where y is one; when one is of measures.csv
        and the other of history.csv, that of history.csv is read at the times of the measures.
        """
        (y_values, table), (x_values, other) = self.find(y), self.find(x)
        if is_force(y) and not is_force(x) and not is_measures(table) and x in table:
            return self.run.at_forces(x), y_values, False
        if x in table:
            return table[x], y_values, table is not other or is_measures(table)
        if table is other:
            return x_values, y_values, is_measures(table)
        if is_measures(table):
            return np.interp(table["time_s"], other["time_s"], x_values), y_values, True
        return x_values, np.interp(other["time_s"], table["time_s"], y_values), True


def is_force(name):
    """Whether a column of history.csv is a force of the step, or made of one."""
    return name == DIAMETRAL or bool(re.search(r"_(force|force_[xy]|torque)_N(_per_m)?$", name))


def is_measures(table):
    return table.title == "measures.csv"


def run_labels(directories):
    """
    Names of the folders, as much of the path as makes them differ.

    >>> run_labels(["a/fine", "a/coarse"]), run_labels(["a/out", "b/out"])
    (['fine', 'coarse'], ['a/out', 'b/out'])
    """
    paths = [os.path.abspath(directory).split(os.sep) for directory in directories]
    for depth in range(1, max(map(len, paths)) + 1):
        labels = ["/".join(path[-depth:]) for path in paths]
        if len(set(labels)) == len(labels):
            return labels
    return [f"{path[-1]} ({number})" for number, path in enumerate(paths, start=1)]


def moves(values):
    return values is not None and np.isfinite(values).any() and np.nanmax(np.abs(values)) > 0


def default_x(curves):
    """The strain when it changes in all runs, else the time."""
    tables = [
        one.run.history_table for one in curves if os.path.exists(one.run.path("history.csv"))
    ]
    if len(tables) == len(curves) and all(moves(table.get("axial_strain")) for table in tables):
        return "axial_strain"
    return "time_s"


def usual_columns(curves):
    """
    What is drawn when nothing is asked for, of what every run has: the force on the bottom wall, on
    any wall, or energies.
    """
    tables = [
        (
            one.run.history_table
            if os.path.exists(one.run.path("history.csv"))
            else one.run.measures_table
        )
        for one in curves
    ]
    common = [name for name in tables[0] if all(name in table for table in tables)]
    if "bottom_force_N_per_m" in common:
        return ["bottom_force_N_per_m"]
    columns = [name for name in common if re.search(r"(?<!normal)_force_N(_per_m)?$", name)]
    columns = columns or [
        name for name in common if name.endswith(("_energy_J_per_m", "_energy_J"))
    ]
    if not columns:
        raise InputError(
            "the runs have neither a wall's force nor an energy in common: choose with --y among "
            + (", ".join(common) or "their columns, of which they share none")
        )
    return columns


def label_of(name):
    return r"Stress $\sigma = F/L$" if name == DIAMETRAL else describe(name)


def panels_of(columns):
    """
    Columns by their unit, in the order they were asked for; pure numbers each for themselves.

    >>> panels_of(["top_force_N_per_m", "coordination", "bottom_force_N_per_m"])
    [['top_force_N_per_m', 'bottom_force_N_per_m'], ['coordination']]
    """
    panels: Dict[str, List[str]] = {}
    for column in columns:
        unit = split_unit(column)[1]
        panels.setdefault(unit if unit else column, []).append(column)
    return list(panels.values())


def text_of_axis(columns):
    if len(columns) == 1:
        return label_of(columns[0])
    kinds = {split_unit(c)[0].rsplit("_", 1)[-1] for c in columns}
    return kinds.pop().capitalize() if len(kinds) == 1 else ""


def style_of_axes(axes):
    axes.minorticks_on()
    axes.tick_params(which="both", top=True, right=True)
    axes.grid(color="#d9d9d9", linewidth=0.6, zorder=0)
    axes.set_axisbelow(True)


def draw_panel(axes, curves, x, columns, **style):
    """
    The columns of one unit of all runs; returns (scale of x, scale of y, text of the x axis,
    whether y is below 0).
    """
    pairs = {
        (number, column): one.pair(x, column)
        for number, one in enumerate(curves)
        for column in columns
    }
    scale, unit = scaled_unit(
        split_unit(columns[0])[1], largest_of(pair[1] for pair in pairs.values())
    )
    x_scale, x_unit = scaled_unit(split_unit(x)[1], largest_of(pair[0] for pair in pairs.values()))
    for (number, column), (x_values, y_values, sparse) in pairs.items():
        position = columns.index(column)
        if len(curves) == 1:
            colour, dashes, label = COLOURS[position % len(COLOURS)], "-", label_of(column)
            if len(columns) == 1:
                label = curves[0].label
        else:
            colour, dashes = COLOURS[number % len(COLOURS)], DASHES[position % len(DASHES)]
            label = (
                curves[number].label
                if len(columns) == 1
                else f"{curves[number].label}: {label_of(column)}"
            )
        points = {"marker": "o", "markersize": 3.2} if sparse and len(y_values) <= 200 else {}
        axes.plot(
            x_values / x_scale,
            y_values / scale,
            **{
                "color": colour,
                "linestyle": dashes,
                "linewidth": 1.8,
                "label": label,
                "zorder": 3,
                **points,
                **style,
            },
        )
    axes.set_ylabel(with_unit(text_of_axis(columns), unit).strip())
    style_of_axes(axes)
    lowest = min(np.nanmin(pair[1], initial=0) for pair in pairs.values())
    negative = lowest < -1e-9 * largest_of(pair[1] for pair in pairs.values())
    return x_scale, scale, with_unit(describe(x), x_unit), negative


def in_lines(text, width=28):
    """
    A long text in lines; formulas, which stand between dollar signs, stay whole.

    >>> in_lines("Coordination number $Z$ of bodies alone")
    'Coordination number $Z$ of\\nbodies alone'
    """
    lines = [""]
    for word in re.split(r" +(?=(?:[^$]*\$[^$]*\$)*[^$]*$)", text):
        if lines[-1] and len(lines[-1]) + len(word) >= width:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word
    return "\n".join(lines)


def largest_of(arrays):
    return max((np.nanmax(np.abs(values), initial=0) for values in arrays), default=0)


def plot_columns(run, columns, x=None, axes=None, style=None):
    """Run.plot()."""
    curves = [Curves(run)]
    x = curves[0].full_name(x) if x else default_x(curves)
    columns = [curves[0].full_name(name) for name in columns] or usual_columns(curves)
    if len(panels_of(columns)) > 1 and len({split_unit(c)[1] for c in columns}) > 1:
        raise InputError("one picture has columns of one unit: call plot() once for each unit")
    with plt.rc_context(STYLE):
        if axes is None:
            axes = plt.figure(figsize=(6.4, 4.4), constrained_layout=True).add_subplot()
        *_, text, negative = draw_panel(axes, curves, x, columns, **(style or {}))
        axes.set_xlabel(text)
        if not negative:
            axes.set_ylim(bottom=0)
        if len(axes.lines) > 1:
            axes.legend(frameon=False)
    return axes
