# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What a study finds: errors and costs of its points, the front of the best ones, orders of
convergence.
"""

import os
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional

import numpy as np

from .fits import smallest
from .folder import Run
from .report_entry import is_number
from .runner import COMPLETED, FAILED, NOT_RUN, TOO_LONG, read_record
from .study_points import folder_of
from .study_quantities import Difference, check_columns, difference, reference_values, values_of
from .study_verdict import is_front_sure, judge_uncertainty, verdict

FEWEST = 3  # values of a knob from which an order is fitted
ALIKE = 0.02  # relative difference of errors that count as equal
MOVES = 1.5  # an error that changes by less than this factor does not depend on the knob
GOOD = 0.99  # R² of the logarithms from which an order is told


@dataclass
class Result:
    """A point with what its runs gave."""

    point: Any  # a Point
    runs: list  # one Run or None for every task
    records: list
    differences: dict = field(default_factory=dict)  # {quantity: Difference}
    front: dict = field(
        default_factory=dict
    )  # {quantity: whether no other point is better in error and cost}
    uncertainty: dict = field(default_factory=dict)  # {quantity: what its error may be off by}
    of_one_packing: dict = field(
        default_factory=dict
    )  # {quantity: whether that is judged from the places of one packing}

    @property
    def status(self):
        states = [record["status"] for record in self.records]
        if len(set(states)) == 1:
            return states[0]
        return f"{states.count(COMPLETED)} of {len(states)} completed"

    @property
    def notes(self):
        """Why something is missing, each reason once."""
        found = [record["error"] for record in self.records if "error" in record]
        found += [f"{name}: {one.note}" for name, one in self.differences.items() if one.note]
        return list(dict.fromkeys(found))

    def mean(self, function):
        values = [
            function(run, record) for run, record in zip(self.runs, self.records) if run is not None
        ]
        values = [value for value in values if is_number(value)]
        return float(np.mean(values)) if values else np.nan

    def cost(self, name):
        if name == "peak_memory_bytes":
            return self.mean(lambda run, _: run.summary.get(name))
        return self.mean(lambda _, record: record.get(name))

    @property
    def steps(self):
        return self.mean(lambda run, _: run.summary.get("steps"))

    def per_step(self, column):
        """Mean of a column of the history; the state at the start is no step."""

        def of_run(run, _):
            values = run.history_table.get(column)
            return (
                float(np.nanmean(values[1:]))
                if values is not None and np.isfinite(values[1:]).any()
                else None
            )

        return self.mean(of_run)


@dataclass
class Order:
    """The error of a quantity goes with a power of a knob, other knobs being the same."""

    quantity: str
    knob: str
    others: dict
    order: float
    quality: float  # R² of the logarithms
    values: list
    errors: list

    @property
    def good(self):
        return self.quality >= GOOD and max(self.errors) > MOVES * min(self.errors)


@dataclass
class Findings:
    """All that is to be told of a study."""

    study: Any  # a Study
    results: list
    orders: list

    @property
    def failures(self):
        """How many runs have failed or took too long."""
        return sum(
            record["status"] in (FAILED, TOO_LONG) for one in self.results for record in one.records
        )

    def verdict(self, quantity, level):
        """The cheapest point whose error is at most @level, and whether that is sure."""
        return verdict(self.results, quantity, level, self.study.cost)

    def is_front_sure(self, quantity):
        """
        Whether no best point could be none, and no other one a best, for all that is uncertain.
        """
        return is_front_sure(self.results, quantity.name, self.study.cost)

    def has_one_packing(self, quantity):
        """Whether errors of a quantity are those of one packing."""
        return any(one.of_one_packing.get(quantity.name) for one in self.results)


def open_results(study, points, output):
    results = []
    for point in points:
        records = [read_record(folder_of(output, task)) for task in point.tasks]
        runs: List[Optional[Run]] = [None] * len(records)
        for number, (task, record) in enumerate(zip(point.tasks, records)):
            folder = folder_of(output, task)
            if record["status"] == COMPLETED and os.path.isdir(folder) and Run(folder).finished:
                runs[number] = Run(folder)
            elif record["status"] == COMPLETED:
                records[number] = {"status": NOT_RUN}
        results.append(Result(point, runs, records))
    return results


def evaluate(study, points, output):
    """The Findings of what is there."""
    results = open_results(study, points, output)
    found = next((run for one in results for run in one.runs if run is not None), None)
    if found is not None:  # a run without states counts as empty
        check_columns(found, study.quantities)
    place = next((number for number, one in enumerate(results) if one.point.is_reference), None)
    for quantity in study.quantities:
        found = [
            [values_of(run, quantity) if run is not None else None for run in one.runs]
            for one in results
        ]
        other = found[place] if place is not None else None
        for one, values in zip(results, found):
            one.differences[quantity.name] = compare(quantity, one, values, other)
        judge_uncertainty(results, quantity, study.cost)
    for quantity in study.quantities:
        mark_front(results, quantity.name, study.cost)
    return Findings(study, results, orders_of(study, results))


def compare(quantity, one, values, reference):
    """The Difference of a point; runs that are missing, here or in the reference, do not count."""
    if quantity.needs_run and one.point.is_reference:
        return Difference(
            note="" if any(run is not None for run in one.runs) else "there is no run"
        )
    if quantity.needs_run:
        pairs = [
            (own, other)
            for own, other in zip(values, reference)
            if own is not None and other is not None
        ]
    else:
        pairs = [
            (own, reference_values(quantity, one.point.values)) for own in values if own is not None
        ]
    if not pairs:
        return Difference(
            note=(
                "there is no run"
                if all(own is None for own in values)
                else "there is no reference run"
            )
        )
    return difference(quantity, *map(np.array, zip(*pairs)))


def mark_front(results, quantity, cost):
    """
    A point is on the front when no cheaper one is as near to the reference; errors that differ by a
    fiftieth count as equal, so that rounding and noise make no points of a front.
    """
    reached = np.inf
    for one in sorted(results, key=lambda one: (one.cost(cost), one.differences[quantity].error)):
        error = one.differences[quantity].error
        one.front[quantity] = bool(np.isfinite(one.cost(cost)) and error < (1 - ALIKE) * reached)
        if one.front[quantity]:
            reached = error


def orders_of(study, results):
    orders = []
    knobs = [knob for knob in study.knobs if not knob.average]
    for quantity in study.quantities:
        for knob in knobs:
            groups: Dict[Any, Any] = {}
            for one in results:
                others = tuple(
                    (name, value) for name, value in one.point.values.items() if name != knob.name
                )
                groups.setdefault(others, []).append(one)
            for others, group in groups.items():
                if knob.numeric and (found := order_of(study, quantity, knob, dict(others), group)):
                    orders.append(found)
    return orders


def order_of(study, quantity, knob, others, group):
    """The Order in one knob, None without enough points with an error."""
    found = sorted(
        (float(one.point.values[knob.name]), one.differences[quantity.name].error) for one in group
    )
    found = [
        (value, error) for value, error in found if value > 0 and error > 0 and np.isfinite(error)
    ]
    if len(found) < FEWEST:
        return None
    values, errors = map(np.array, zip(*found))
    # The reference run has an error of its own: with the same other knobs that is known up to its
    # factor.
    end = 0.0
    if quantity.needs_run and {name: study.reference[name] for name in others} == others:
        end = float(study.reference[knob.name])
    order, quality = fit_order(values, errors, end)
    return Order(quantity.name, knob.name, others, order, quality, values.tolist(), errors.tolist())


def fit_order(values, errors, end=0.0):
    """
    (p, R² of the logarithms) of error = C |value^p - end^p|.

    >>> h = np.array([1., 2., 4.])
    >>> [round(one, 6) for one in fit_order(h, 3 * (h**2 - 0.5**2), 0.5)]
    [2.0, 1.0]
    """
    x, y = np.log(values), np.log(errors)

    def left(p):
        shape = np.log(
            np.abs(
                np.exp(p * (x - x[-1])) - (np.exp(p * (np.log(end) - x[-1])) if end > 0 else 0.0)
            )
        )
        return np.std(y - shape)

    order = float(smallest(left, 0.02, 8.0)) if end > 0 else float(np.polyfit(x, y, 1)[0])
    spread = np.std(y)
    return order, float(1 - (left(order) / spread) ** 2) if spread > 0 else 0.0
