# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a page about runs: the tables that it holds, and what is drawn of them."""

import os
import re
from typing import Any, Dict, Tuple

import numpy as np

from .coordinate import changes
from .curves import COLOURS, moves
from .dissipation import can_be_stacked, column_of, dissipation_of
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
    history.csv and measures.csv of every run become tables of the page; returns {number of the run:
    names of its tables}. Rows of measures.csv get the strain that the history has at their time.
    """
    result: Dict[int, Any] = {}
    largest: Dict[str, Any] = {}
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
            page.tables[name] = {
                column: values.tolist() for column, values in thinned(table).items()
            }
            result.setdefault(number, []).append(name)
            for column, values in table.items():
                finite = values[np.isfinite(values)]
                largest[column] = max(largest.get(column, 0), np.abs(finite).max(initial=0))
    for column, most in largest.items():
        divisor, unit = scaled_unit(split_unit(column)[1], most)
        label = (
            "Mean pressure" if column == "mean_pressure_Pa" else html_of(escape(describe(column)))
        )  # of the box, not of a grain
        page.columns[column] = {"label": label, "unit": unit, "divisor": divisor}
    return result


PANELS: Tuple[Tuple[str, str, dict], ...] = (  # heading, columns, options
    ("Forces on the walls", r".*(?<!normal)_force_N(_per_m)?$", {}),
    ("Packing fraction", r"packing_fraction$", {}),
    ("Coordination", r"coordination$", {}),
    ("Energies", r"(kinetic|elastic|dissipated)_energy_J(_per_m)?$", {}),
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
    columns = list(
        dict.fromkeys(
            name for names in tables.values() for table in names for name in page.tables[table]
        )
    )
    x_choices = [
        name
        for name in first(
            coordinate_of_all(entries), ["axial_strain", "time_s", "packing_fraction", "step"]
        )
        if any(
            moves(np.array(page.tables[table].get(name) or [0], dtype=float))
            for names in tables.values()
            for table in names
        )
    ] or ["time_s"]
    for heading, pattern, options in PANELS:
        shown = [name for name in columns if re.match(pattern, name)]
        shown = [
            name
            for name in shown
            if any(
                moves(np.array(page.tables[table].get(name) or [0], dtype=float))
                for names in tables.values()
                for table in names
            )
        ]
        if shown and shown != x_choices[:1]:  # a column against itself tells nothing
            section.curves(
                heading,
                series_of(entries, tables, shown, page.columns),
                x_choices,
                shown[:1],
                follow=True,
                **options,
            )
        if heading == "Energies":
            add_dissipation(section, entries, page, x_choices)
    every = series_of(entries, tables, [None], page.columns)
    section.curves(
        "Any column against any other",
        every,
        first(x_choices[0], columns),
        first(
            "elastic_energy_J" if "elastic_energy_J" in columns else "elastic_energy_J_per_m",
            columns,
        ),
        wide=True,
    )


def coordinate_of_all(entries):
    """
    The column that all scenes go by; of different ones the strain where it changes in all, else the
    time.
    """
    found = {entry.run.coordinate for entry in entries} - {None}
    if len(found) == 1 and all(changes(entry.run, *found) for entry in entries):
        return found.pop()
    return (
        "axial_strain" if all(changes(entry.run, "axial_strain") for entry in entries) else "time_s"
    )


def add_dissipation(section, entries, page, x_choices):
    """What has become of the energy that is gone, a stack for each run."""
    for number, entry in enumerate(entries):
        if (
            not os.path.exists(entry.run.path("history.csv"))
            or "dissipated_energy_J_per_m" not in entry.run.history_table
        ):
            continue
        kinds, history = dissipation_of(entry.run), entry.run.history_table
        places = [name for name in x_choices if name in history]
        if not kinds or not places:
            continue
        name = f"{number}/dissipation"
        table = {
            **{place: history[place] for place in places},
            **{column_of(kind): values for kind, values in kinds.items()},
        }
        page.tables[name] = {column: values.tolist() for column, values in thinned(table).items()}
        divisor, unit = scaled_unit(
            "J/m", np.nanmax(np.abs(history["dissipated_energy_J_per_m"]), initial=0)
        )
        for kind in kinds:
            page.columns[column_of(kind)] = {
                "label": f"Dissipated by {kind}",
                "unit": unit,
                "divisor": divisor,
            }
        series = [
            {
                "name": kind,
                "tables": [name],
                "y": column_of(kind),
                "colour": COLOURS[place % len(COLOURS)],
                "stack": can_be_stacked(kinds),
            }
            for place, kind in enumerate(kinds)
        ]
        section.curves(
            "Dissipation by kind" + (f", {entry.label}" if len(entries) > 1 else ""),
            series,
            places,
            [column_of(next(iter(kinds)))],
            follow=True,
        )


def first(name, columns):
    """The columns with one of them before all others."""
    return [one for one in columns if one == name] + [one for one in columns if one != name]


def series_of(entries, tables, columns, described):
    """
    A run has one colour, a column one way of dashing; of a single run each column has its colour.
    """
    series = []
    for number, entry in enumerate(entries):
        if number not in tables:
            continue
        for position, column in enumerate(columns):
            label = described[column]["label"] if column else entry.label
            name = (
                label
                if len(entries) == 1 and column
                else escape(entry.label) if len(columns) == 1 else f"{escape(entry.label)}: {label}"
            )
            colour = COLOURS[position % len(COLOURS)] if len(entries) == 1 else entry.colour
            dash = "solid" if len(entries) == 1 else PLOTLY_DASHES[position % len(PLOTLY_DASHES)]
            series.append(
                {
                    "name": name,
                    "tables": tables[number],
                    "colour": colour,
                    "dash": dash,
                    **({"y": column} if column else {}),
                }
            )
    return series
