# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities of a study: a curve of a run at some places, and how far it is from a reference."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from .errors import InputError
from .fits import value_at

WINDOW = 201  # places in a window


@dataclass
class Difference:
    """How far a point is from the reference; relative numbers."""

    error: float = np.nan
    scatter: float = np.nan  # standard deviation of the difference of one run about its mean
    signed: Optional[np.ndarray] = None  # at every place
    of_runs: Optional[np.ndarray] = None  # at every place, a row for each run
    note: str = ""  # why there is no number


def places(quantity):
    """Values of x at which a quantity is looked at."""
    if quantity.at:
        return np.array(quantity.at)
    begin, end = quantity.between
    return np.linspace(begin, end, WINDOW)


def curve_of(run, quantity):
    """
    (x, y) of a run, row by row. Columns of history.csv are read at the times of measures.csv where
    both are used.
    """
    names = quantity.x.names | quantity.y.names
    found = {name: run.column(name) for name in names}
    tables = {id(table): table for _, table in found.values()}
    columns = {name: values for name, (values, _) in found.items()}
    if len(tables) > 1:
        sparse = min(tables.values(), key=len)
        for name, (values, table) in found.items():
            if table is not sparse:
                columns[name] = (
                    sparse[name]
                    if name in sparse
                    else np.interp(sparse["time_s"], table["time_s"], values)
                )
    x, y = (np.asarray(formula(columns), dtype=float) for formula in (quantity.x, quantity.y))
    x, y = np.broadcast_arrays(x, y)
    known = np.isfinite(x) & np.isfinite(y)
    return x[known], y[known]


def value_of(x, y, place, width):
    """
    y where x first reaches a place, or a mean over x ± width; NaN where the curve does not get
    there.

    >>> x, y = np.array([0., 1., 2., 1.]), np.array([0., 2., 4., 9.])
    >>> value_of(x, y, 0.5, 0.), value_of(x, y, 1., 0.), value_of(x, y, 3., 0.)
    (1.0, 2.0, nan)
    """
    if width > 0:
        found = value_at(x, y, place, width)
        return np.nan if found is None else found
    if not len(x):
        return np.nan
    # A place that a sum of steps misses by rounding is there.
    slack = 1e-9 * max(np.abs(x).max(), abs(place))
    if abs(x[0] - place) <= slack:
        return float(y[0])
    above = np.sign(place - x[0]) * (x - place) >= -slack
    if not above.any():
        return np.nan
    i = int(np.argmax(above))
    share = min((place - x[i - 1]) / (x[i] - x[i - 1]), 1.0)
    return float(y[i - 1] + share * (y[i] - y[i - 1]))


def mean_over(x, y, begin, end):
    """
    Mean of y from where x first reaches @begin to where it first reaches @end, every row counted:
    single values of a noisy curve would not do. NaN where the curve does not get there.

    >>> round(mean_over(np.array([0., 1., 2., 3.]), np.array([0., 2., 0., 0.]), 0.5, 2.), 6)
    1.166667
    """
    ends = [value_of(x, y, place, 0.0) for place in (begin, end)]
    if not np.isfinite(ends).all():
        return np.nan
    slack = 1e-9 * max(np.abs(x).max(), abs(end))  # as in value_of()
    inside = slice(int(np.argmax(x > begin)), int(np.argmax(x >= end - slack)))
    along, values = np.concatenate([[begin], x[inside], [end]]), np.concatenate(
        [ends[:1], y[inside], ends[1:]]
    )
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(along)) / (end - begin))


def values_of(run, quantity):
    """y at the places of a quantity; its mean at all of them where means are compared."""
    x, y = curve_of(run, quantity)
    if quantity.norm == "of means":
        return np.full(WINDOW, mean_over(x, y, *quantity.between))
    return np.array([value_of(x, y, place, quantity.width) for place in places(quantity)])


def reference_values(quantity, values, x=None):
    """
    The formula or curve of a quantity at its places or at others; @values {knob: text} of the
    point.
    """
    x = places(quantity) if x is None else x
    if quantity.curve is not None:
        places_of, values_of = quantity.curve
        return np.interp(x, places_of, values_of, left=np.nan, right=np.nan)
    numbers = {name: float(values[name]) for name in quantity.formula.names - {"x"}}
    return np.broadcast_to(np.asarray(quantity.formula({**numbers, "x": x}), dtype=float), x.shape)


def exact_curve(quantity, values):
    """(x, y) of the formula or curve of a quantity, to be drawn."""
    if quantity.curve is not None:
        return quantity.curve
    x = places(quantity)
    x = np.linspace(x.min(), x.max(), WINDOW) if len(x) > 1 else x
    return x, reference_values(quantity, values, x)


def difference(quantity, found, reference):
    """
    The difference of runs from a reference. @found: values of each run at the places; @reference:
    the same of the reference runs, one for each run, or one for all.

    Single places: relative to the reference there. A window: relative to its largest value in the
    window, 'of means': to its mean.
    """
    found, reference = np.atleast_2d(found), np.atleast_2d(reference)
    own, other = found.mean(axis=0), reference.mean(axis=0)
    x = places(quantity)
    for values, whose in ((own, "the run does"), (other, "the reference does")):
        if not np.isfinite(values).all():
            return Difference(
                note=f"{whose} not reach {quantity.x.text} = {x[~np.isfinite(values)][0]:g}"
            )
    if quantity.norm == "of means":
        found, reference = found.mean(axis=1, keepdims=True), reference.mean(axis=1, keepdims=True)
        own, other = found.mean(axis=0), reference.mean(axis=0)
    scale = (
        np.abs(other)
        if quantity.at or quantity.norm == "of means"
        else np.full_like(other, np.abs(other).max())
    )
    if not (scale > 0).all():
        return Difference(note="the reference is 0")
    of_runs = (found - reference) / scale
    if quantity.average == "errors":
        error = float(np.sqrt(np.mean([norm_of(quantity.norm, one) ** 2 for one in of_runs])))
    else:
        error = norm_of(quantity.norm, (own - other) / scale)
    scatter = (
        float(np.sqrt(np.mean(np.var(of_runs, axis=0, ddof=1)))) if len(of_runs) > 1 else np.nan
    )
    return Difference(error, scatter, (own - other) / scale, of_runs)


def norm_of(norm, differences):
    size = np.abs(differences)
    if norm == "rms":
        return float(np.sqrt(np.mean(size**2)))
    return float(size.mean() if norm == "mean" else size.max())


def check_columns(run, quantities):
    """Refuses columns that a finished run does not have."""
    for quantity in quantities:
        try:
            curve_of(run, quantity)
        except InputError as error:
            raise InputError(f"{quantity.where}: 'Quantities/{quantity.name}': {error}") from error
