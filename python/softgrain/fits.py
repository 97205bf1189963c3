# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Fits: lines, powers and exponentials, and the laws of chapter 4 of Nguyen (2016); None where the
data do not reach.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Dict

import numpy as np

FEWEST = 5  # points below which nothing is fitted
LOOSE = 0.68  # packing below which bodies hardly touch


POOR = 0.9  # R² below which a law does not describe the data


def quality(values, rms):
    """
    R² of a fit that leaves the root mean square @rms of the @values: 1 is perfect, 0 no better than
    their mean.

    >>> round(quality(np.array([1., 2., 3.]), 0.1), 3)
    0.985
    """
    spread = np.var(values)
    return float(1 - rms**2 / spread) if spread > 0 else float(rms == 0)


def smallest(function, lower, upper, steps=60):
    """
    Where a function of one number is smallest: the best of a row of values, then the golden
    section.
    """
    row = np.linspace(lower, upper, steps)
    best = int(np.argmin([function(x) for x in row]))
    a, b = row[max(best - 1, 0)], row[min(best + 1, steps - 1)]
    ratio = 0.5 * (np.sqrt(5) - 1)
    while b - a > 1e-9 * (1 + abs(a)):
        c, d = b - ratio * (b - a), a + ratio * (b - a)
        if function(c) < function(d):
            b = d
        else:
            a = c
    return 0.5 * (a + b)


@dataclass
class Curve:
    """A fitted curve y = a + b shape(x): its constants {name: number}, its formula, R²."""

    constants: dict
    formula: str
    quality: float
    shape: Callable
    at_limit: bool = (
        False  # c is at the end of the values that are tried: the data do not say what it is
    )

    def __call__(self, x):
        return self.constants["a"] + self.constants["b"] * self.shape(np.asarray(x, dtype=float))


def curve(x, y, kind):
    """
    Least squares in y of a 'line' a + b x, a 'power' a + b (x - x0)^c or an 'exponential' a + b
    exp(c (x - x0)), x0 being the smallest x; None for too few points.

    >>> x = np.linspace(1, 2, 20)
    >>> found = curve(x, 3 + 2 * (x - 1)**0.5, "power")
    >>> {name: round(value, 3) for name, value in found.constants.items()}, round(found.quality, 6)
    ({'a': 3.0, 'b': 2.0, 'x0': 1.0, 'c': 0.5}, 1.0)
    """
    known = np.isfinite(x) & np.isfinite(y)
    x, y = np.asarray(x)[known], np.asarray(y)[known]
    if len(x) < FEWEST or not np.ptp(x) > 0:
        return None
    start, extent = x.min(), np.ptp(x)
    shapes: Dict[str, Any] = {
        "line": (lambda c: lambda v: v, None, "a + b x"),
        "power": (
            lambda c: lambda v: np.maximum(v - start, 0.0) ** c,
            (0.05, 5.0),
            "a + b (x - x0)^c",
        ),
        "exponential": (
            lambda c: lambda v: np.exp(c * (v - start)),
            (-20 / extent, 20 / extent),
            "a + b exp(c (x - x0))",
        ),
    }
    shape_of, limits, formula = shapes[kind]

    def solve(c):
        basis = np.stack([np.ones_like(x), shape_of(c)(x)], axis=1)
        numbers = np.linalg.lstsq(basis, y, rcond=None)[0]
        return numbers, float(np.sqrt(np.mean((y - basis @ numbers) ** 2)))

    best = smallest(lambda c: solve(c)[1], *limits) if limits else 1.0
    (a, b), rms = solve(best)
    constants = {
        "a": float(a),
        "b": float(b),
        **({"x0": float(start), "c": float(best)} if limits else {}),
    }
    at_limit = bool(limits) and min(best - limits[0], limits[1] - best) < 1e-3 * (
        limits[1] - limits[0]
    )
    return Curve(constants, formula, quality(y, rms), shape_of(best), at_limit)


def means(x, y, width):
    """Means of x and y over equal pieces of x, so that every part of a curve weighs the same."""
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    if not len(x):
        return x, y
    piece = np.floor(x / width + 1e-9).astype(int)
    piece -= piece.min()
    count = np.bincount(piece)
    filled = count > 0
    return (
        np.bincount(piece, x)[filled] / count[filled],
        np.bincount(piece, y)[filled] / count[filled],
    )


def value_at(x, y, place, width):
    """
    y at a place by a straight line through the data within a width; None when the place is not
    among them.
    """
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    if len(x) < 2 or not x.min() <= place <= x.max():
        return None
    near = np.abs(x - place) <= width
    if near.sum() >= 3 and np.ptp(x[near]) > 0:
        slope, height = np.polyfit(x[near] - place, y[near], 1)
        return float(height)
    order = np.argsort(x)
    return float(np.interp(place, x[order], y[order]))


def first_crossing(x, y, level):
    """x where y first reaches a level, between two points; None when it never does."""
    for i in range(1, len(y)):
        if y[i - 1] < level <= y[i]:
            return float(x[i - 1] + (level - y[i - 1]) / (y[i] - y[i - 1]) * (x[i] - x[i - 1]))
    return None


def slope_through_origin(x, y):
    """(slope, root mean square of what is left) of y = slope x."""
    if len(x) < FEWEST or not np.dot(x, x) > 0:
        return None
    slope = np.dot(x, y) / np.dot(x, x)
    return float(slope), float(np.sqrt(np.mean((y - slope * x) ** 2)))


def exponential_packing(stress, packing, reference):
    """
    (alpha, r.m.s. in packing) of (4.1), packing = 1 - (1 - reference) exp(-alpha (stress - 1)).
    """
    if len(stress) < FEWEST or not np.ptp(stress) > 0:
        return None

    def left(log_alpha):
        return np.sqrt(
            np.mean(
                (packing - 1 + (1 - reference) * np.exp(-np.exp(log_alpha) * (stress - 1))) ** 2
            )
        )

    best = smallest(left, np.log(1e-4), np.log(1e2))
    return float(np.exp(best)), float(left(best))


def power_of_coordination(packing, coordination, reference):
    """
    (exponent, Z0, Z1, r.m.s. in Z) of Z = Z0 + (Z1 - Z0) ((packing - reference) / (1 -
    reference))^exponent.

    Z0 is fitted too: it rises steeply at the reference, and a mean over states around it is too
    large.
    """
    above = packing >= reference
    if above.sum() < FEWEST:
        return None
    x, y = (packing[above] - reference) / (1 - reference), coordination[above]

    def line(exponent):
        basis = np.stack([np.ones_like(x), x**exponent], axis=1)
        return basis, np.linalg.lstsq(basis, y, rcond=None)[0]

    def left(exponent):
        basis, numbers = line(exponent)
        return np.sqrt(np.mean((y - basis @ numbers) ** 2))

    best = smallest(left, 0.05, 3.0)
    if not 0.06 < best < 2.9:
        return None
    lower, rise = line(best)[1]
    return float(best), float(lower), float(lower + rise), float(left(best))


def three_regimes(packing, values):
    """
    ((first limit, second limit), (three slopes)) of the broken line that fits best; None without
    data on all parts.

    The line is continuous; limits are searched in steps of 0.005. Loose states, before any regime,
    do not count.
    """
    known = np.isfinite(packing) & np.isfinite(values) & (packing >= LOOSE)
    packing, values = packing[known], values[known]
    best = None
    if len(packing) < 3 * FEWEST:
        return None
    ones = np.ones_like(packing)
    for first in np.arange(LOOSE + 0.02, 0.90, 0.005):
        for second in np.arange(first + 0.05, 0.99, 0.005):
            parts = [
                (packing < first).sum(),
                ((packing >= first) & (packing < second)).sum(),
                (packing >= second).sum(),
            ]
            if min(parts) < 3:
                continue
            basis = np.stack(
                [ones, packing, np.maximum(packing - first, 0), np.maximum(packing - second, 0)],
                axis=1,
            )
            numbers = np.linalg.lstsq(basis, values, rcond=None)[0]
            left = np.sum((values - basis @ numbers) ** 2)
            if best is None or left < best[0]:
                best = (
                    left,
                    (float(first), float(second)),
                    tuple(float(s) for s in np.cumsum(numbers[1:])),
                )
    return best[1:] if best else None


def force_density(force, gamma):
    """(2.32)-(2.33)."""
    beta = (1 + gamma) * np.log1p(1 / gamma)
    decay = np.exp(-beta * force) / gamma
    return beta * (1 + gamma) * decay / (1 + decay) ** 2
