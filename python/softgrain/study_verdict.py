# SPDX-License-Identifier: LGPL-2.1-or-later
"""
How sure a study is of what it found.

Several packings have a scatter, and their mean a standard error. One packing has none: grains that
rearrange a little earlier or later change a curve at one place and not at the next, and an error
that is made of such jumps would be another one with the next packing. How much of an error is made
at single places is found by leaving out one place after the other (the jackknife); errors of
different packings scatter several times as much, because what differs between them also differs at
all places alike.
"""

from dataclasses import dataclass
from typing import Any, List

import numpy as np

from .study_quantities import norm_of, places

BLOCKS = 8  # of a window: neighbouring places are no witnesses of their own
FEWEST = 3  # packings whose scatter says something
MOST = 100  # packings beyond which nobody is told how many
OF_PACKINGS = (
    4.0  # scatter of packings over what leaving out places shows of one: measured, doc/studies.md
)
ALONE = 0.5  # share of what is uncertain from which on a place makes it alone


@dataclass
class Verdict:
    """What a study says of a level of the error."""

    result: Any  # the cheapest point within it, None without one
    # whether its error and those of cheaper points are on their sides of the level, with what is
    # uncertain of each
    sure: bool
    in_doubt: list  # the points whose errors may be on the other side
    safe: Any = (
        None  # the cheapest point whose error is within the level with all that is uncertain of it
    )
    # packings, or runs, of every point that would decide, about; inf: more than anybody makes, 0:
    # none
    needed: float = 0.0


def blocks_of(quantity, signed):
    """
    The places, or the parts of a window, as pairs (text of the place, numbers of the differences).
    """
    x = places(quantity)
    if quantity.at:
        return (
            [(f"{place:g}", np.array([number])) for number, place in enumerate(x)]
            if len(signed) == len(x)
            else []
        )
    if len(signed) < len(x):
        return []  # a mean of the whole window
    return [
        (f"{x[part[0]]:.3g} to {x[part[-1]]:.3g}", part)
        for part in np.array_split(np.arange(len(x)), BLOCKS)
    ]


def by_place(quantity, found):
    """
    {place: (relative difference there, its standard error over runs)} of a Difference, of a window
    the mean of each part. One run has no standard error: NaN.

    >>> from softgrain.study_file import Quantity
    >>> from softgrain.study_quantities import Difference
    >>> of = Quantity("q", None, None, [1., 2.], None, 0., "rms")
    >>> by_place(of, Difference(signed=np.array([0.01, -0.08])))
    {'1': (0.01, nan), '2': (-0.08, nan)}
    >>> by_place(of, Difference(signed=np.array([0.02, -0.08]),
    ...                         of_runs=np.array([[0.01, -0.08], [0.03, -0.08]])))
    {'1': (0.02, 0.01), '2': (-0.08, 0.0)}
    """
    result = {}
    for place, part in blocks_of(quantity, found.signed):
        runs = [] if found.of_runs is None else np.mean(found.of_runs[:, part], axis=1)
        off = float(np.std(runs, ddof=1) / np.sqrt(len(runs))) if len(runs) > 1 else np.nan
        result[place] = (float(np.mean(found.signed[part])), off)
    return result


def left_out(quantity, signed):
    """What an error is without one place, or part of a window, after the other."""
    return np.array(
        [norm_of(quantity.norm, np.delete(signed, part)) for _, part in blocks_of(quantity, signed)]
    )


def deciding_place(quantity, signed):
    """
    The place that alone makes most of what is uncertain of the error of one packing, as text; empty
    where none does.

    >>> from softgrain.study_file import Quantity
    >>> of = Quantity("q", None, None, [1., 2., 3., 4.], None, 0., "rms")
    >>> (deciding_place(of, np.array([0.08, 0.001, 0.002, -0.001])),
    ...  deciding_place(of, np.array([0.03, -0.001, 0.03, 0.001])))
    ('1', '')
    """
    parts = blocks_of(quantity, signed)
    if len(parts) < 3:
        return ""
    away = (left_out(quantity, signed) - norm_of(quantity.norm, signed)) ** 2
    worst = int(np.argmax(away))
    return parts[worst][0] if away[worst] > ALONE * away.sum() else ""


def spread_over_places(quantity, signed):
    """
    Standard error of an error by leaving out one place, or part of a window, after the other; inf
    where there is one place.

    >>> from softgrain.study_file import Quantity
    >>> of = Quantity("q", None, None, [1., 2., 3., 4.], None, 0., "rms")
    >>> even, jump = np.array([0.02, -0.02, 0.02, 0.02]), np.array([0.08, 0.001, 0.002, -0.001])
    >>> spread_over_places(of, even), round(spread_over_places(of, jump), 3)
    (0.0, 0.034)
    """
    n = len(blocks_of(quantity, signed))
    if n < 2:
        return np.inf
    left = left_out(quantity, signed)
    return float(np.sqrt((n - 1) / n * np.sum((left - left.mean()) ** 2)))


def has_packing(run):
    """Whether the grains of a run come from a packing, of which there could be others."""
    given = run.parameters
    return (
        bool(given.get("Packing/File"))
        or given.get("Packing/Number", 0) not in (0, "")
        or given.get("Packing/Method", "automatic") != "automatic"
    )


def uncertainty(quantity, result):
    """
    What an error may be off by; 0 where runs have nothing random. @return (number, whether one
    packing stands for all)
    """
    found, runs = result.differences[quantity.name], [run for run in result.runs if run is not None]
    if len(runs) > 1 and np.isfinite(found.scatter):
        return float(found.scatter / np.sqrt(len(runs))), False
    if not runs or found.signed is None or not has_packing(runs[0]):
        return 0.0, False
    return OF_PACKINGS * spread_over_places(quantity, found.signed), True


def judge_uncertainty(results, quantity, cost):
    """
    Fills in what each error may be off by. Of one packing a point knows no more than the dearer,
    finer ones: where these still jump, a coarser one that does not was lucky.
    """
    largest = 0.0
    for one in sorted(
        results, key=lambda one: (-one.cost(cost) if np.isfinite(one.cost(cost)) else -np.inf)
    ):
        off, single = uncertainty(quantity, one)
        largest = max(largest, off) if single else largest
        one.uncertainty[quantity.name], one.of_one_packing[quantity.name] = (
            largest if single else off
        ), single


def interval(result, name):
    error, off = result.differences[name].error, result.uncertainty[name]
    return error - off, error + off


def packings_needed(one, name, level):
    """
    How many runs would bring what an error may be off by below its distance from a level: it falls
    with the root of their number.
    """
    off, gap = one.uncertainty[name], abs(one.differences[name].error - level)
    if not np.isfinite(off):
        return FEWEST
    runs = sum(run is not None for run in one.runs)
    needed = np.ceil(runs * (off / gap) ** 2) if gap > 0 else np.inf
    return max(FEWEST, needed) if needed <= MOST else np.inf


def verdict(results, quantity, level, cost):
    """The Verdict about the cheapest point whose error is at most @level."""
    name = quantity.name
    known = [
        one
        for one in results
        if np.isfinite(one.differences[name].error) and np.isfinite(one.cost(cost))
    ]
    chosen, doubtful = None, []
    for one in sorted(known, key=lambda one: one.cost(cost)):
        least, most = interval(one, name)
        within = one.differences[name].error <= level
        if most > level if within else least <= level:
            doubtful.append(one)
        if within:
            chosen = one
            break
    needed = max((packings_needed(one, name, level) for one in doubtful), default=0.0)
    safe: List[Any] = [one for one in known if interval(one, name)[1] <= level]
    return Verdict(
        chosen,
        not doubtful,
        doubtful,
        min(safe, key=lambda one: one.cost(cost), default=None),
        float(needed),
    )


def is_front_sure(results, name, cost):
    """
    Whether every point is on the front, or off it, with all that is uncertain of its error and of
    the others'.
    """
    known = [
        one
        for one in results
        if np.isfinite(one.differences[name].error) and np.isfinite(one.cost(cost))
    ]
    if all(one.uncertainty[name] == 0 for one in known):
        return True
    for one in known:
        least, most = interval(one, name)
        cheaper = [interval(other, name) for other in known if other.cost(cost) < one.cost(cost)]
        if one.front[name] and any(other[0] < most for other in cheaper):
            return False
        if not one.front[name] and not any(other[1] < least for other in cheaper):
            return False
    return True
