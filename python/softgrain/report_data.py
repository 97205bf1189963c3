# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of runs as a page holds them."""

import os

import numpy as np

from .units import describe, html_of, scaled_unit, split_unit

MOST_ROWS = 3000  # of a curve; a page that holds more than can be seen is slow


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
        label = "Mean pressure" if column == "mean_pressure_Pa" else html_of(describe(column))  # of the box, not of a grain
        page.columns[column] = {"label": label, "unit": unit, "divisor": divisor}
    return result
