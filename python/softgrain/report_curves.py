# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a page about runs: the tables that it holds, and what is drawn of them."""

import os
import re

import numpy as np

from .curves import COLOURS, moves
from .page import escape
from .units import describe, html_of, scaled_unit, split_unit

MOST_ROWS = 3000  # of a curve; a page that holds more than can be seen is slow
PLOTLY_DASHES = ["solid", "dash", "dot", "dashdot"]


def thinned(table, most=MOST_ROWS):
    """
    Columns with at most so many rows, evenly chosen, the first and the last among them.

    >>> thinned({"step": np.arange(10)}, 4)["step"].tolist()
    [0, 3, 6, 9]
    """
    n = len(next(iter(table.values()), ()))
    if n <= most:
        return dict(table.items())
    rows = np.linspace(0, n - 1, most).astype(int)
    return {name: values[rows] for name, values in table.items()}


def add_tables(page, entries):
    """
    history.csv and measures.csv of every run become tables of the page; returns {number of the run: names of its tables}.
    Rows of measures.csv get the strain that the history has at their time.
    """
    result, largest = {}, {}
    for number, entry in enumerate(entries):
        for file in ("history.csv", "measures.csv"):
            if not os.path.exists(entry.run.path(file)):
                continue
            table = dict(entry.run.table(file).items())
            if file == "measures.csv" and "time_s" in table and "axial_strain" not in table:
                strains = [entry.run.strain_at(time) for time in table["time_s"]]
                if strains and None not in strains:
                    table["axial_strain"] = np.array(strains)
            name = f"{number}/{file.removesuffix('.csv')}"
            page.tables[name] = {column: values.tolist() for column, values in thinned(table).items()}
            result.setdefault(number, []).append(name)
            for column, values in table.items():
                finite = values[np.isfinite(values)]
                largest[column] = max(largest.get(column, 0), np.abs(finite).max(initial=0))
    for column, most in largest.items():
        divisor, unit = scaled_unit(split_unit(column)[1], most)
        label = "Mean pressure" if column == "mean_pressure_Pa" else html_of(escape(describe(column)))  # of the box, not of a grain
        page.columns[column] = {"label": label, "unit": unit, "divisor": divisor}
    return result


PANELS = (  # heading, columns, options
    ("Forces on the walls", r".*(?<!normal)_force_N_per_m$", {}),
    ("Packing fraction", r"packing_fraction$", {}),
    ("Coordination", r"coordination$", {}),
    ("Energies", r"(kinetic|elastic|dissipated)_energy_J_per_m$", {}),
    ("Stress of the box", r"(mean_pressure|deviator)_Pa$", {}),
    ("Anisotropy", r"(contact|normal_force)_anisotropy$", {}),
    ("Work of the solvers", r"(newton_iterations|contact_sweeps)$", {}),
    ("Residual of contact", r"contact_residual$", {"logy": True}),
    ("Time step", r"dt_s$", {}),
)


def add_curves(page, entries):
    tables = add_tables(page, entries)
    if not tables:
        return
    section = page.section("Curves")
    columns = list(dict.fromkeys(name for names in tables.values() for table in names for name in page.tables[table]))
    x_choices = [name for name in ("axial_strain", "time_s", "packing_fraction", "step") if
                 any(moves(np.array(page.tables[table].get(name) or [0], dtype=float))
                     for names in tables.values() for table in names)] or ["time_s"]
    for heading, pattern, options in PANELS:
        shown = [name for name in columns if re.match(pattern, name)]
        shown = [name for name in shown if any(moves(np.array(page.tables[table].get(name) or [0], dtype=float))
                                               for names in tables.values() for table in names)]
        if shown:
            section.curves(heading, series_of(entries, tables, shown, page.columns), x_choices, shown[:1], follow=True,
                           **options)
    every = series_of(entries, tables, [None], page.columns)
    section.curves("Any column against any other", every, first(x_choices[0], columns), first("elastic_energy_J_per_m", columns),
                   wide=True)


def first(name, columns):
    """The columns with one of them before all others."""
    return [one for one in columns if one == name] + [one for one in columns if one != name]


def series_of(entries, tables, columns, described):
    """A run has one colour, a column one way of dashing; of a single run each column has its colour."""
    series = []
    for number, entry in enumerate(entries):
        if number not in tables:
            continue
        for position, column in enumerate(columns):
            label = described[column]["label"] if column else entry.label
            name = label if len(entries) == 1 and column else escape(entry.label) if len(columns) == 1 else \
                f"{escape(entry.label)}: {label}"
            colour = COLOURS[position % len(COLOURS)] if len(entries) == 1 else entry.colour
            dash = "solid" if len(entries) == 1 else PLOTLY_DASHES[position % len(PLOTLY_DASHES)]
            series.append({"name": name, "tables": tables[number], "colour": colour, "dash": dash,
                           **({"y": column} if column else {})})
    return series
