# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a study: what is changed in each, and the runs that it takes."""

import itertools
import os
from dataclasses import dataclass

from .errors import InputError
from .formula import Formula
from .made_by import PATHS, Origin, moved
from .programs import folder_name
from .study_file import IN_BRACES, is_number

EMPTY = '""'  # how a value is written that empties a parameter


@dataclass
class Task:
    """One run: the values of all knobs, the parameters that they change, its folder."""

    values: dict  # {knob: text}
    changes: dict  # {parameter: text}
    name: str  # of the folder
    origin: Origin

    def words(self, knobs):
        return ", ".join(f"{knob.name} = {self.values[knob.name]}" for knob in knobs) or "the scene"


@dataclass
class Point:
    """Runs that differ in averaged knobs alone, and that count as one."""

    values: dict  # {knob: text} of the other knobs
    tasks: list
    is_reference: bool = False
    is_added: bool = False  # only the reference asks for it

    @property
    def label(self):
        return ", ".join(f"{name} = {value}" for name, value in self.values.items()) or "the scene"


def filled(text, values):
    """
    A setting with its formulas in braces worked out.

    >>> filled("{-2*h}, {kind}", {"h": "0.5", "kind": "fine"})
    '-1, fine'
    """
    numbers = {name: float(value) for name, value in values.items() if is_number(value)}

    def one(match):
        inside = match.group(1).strip()
        if inside in values:
            return values[inside]
        return f"{float(Formula(inside)(numbers)):.12g}"

    return IN_BRACES.sub(one, text)


def task_of(study, values, origins):
    """
    The run for a value of every knob; the same run has the same folder in every study of the scene.
    """
    changes = {name: filled(item.text, values) for name, item in study.settings.items()}
    changes.update({knob.parameter: values[knob.name] for knob in study.knobs if knob.parameter})
    folder = os.path.dirname(study.path)
    changes = {
        name: moved(text, folder) if name in PATHS and folder and text != EMPTY else text
        for name, text in changes.items()
    }
    changes.update(study.changes)
    changes = {name: "" if value == EMPTY else str(value) for name, value in changes.items()}
    origin = origins.of(changes)
    return Task(values, changes, folder_name(values, origin), origin)


def combinations(study, knobs):
    """Values of some knobs, all combinations or one knob after the other."""
    if study.combinations == "all":
        return [
            dict(zip([knob.name for knob in knobs], values))
            for values in itertools.product(*(knob.values for knob in knobs))
        ]
    base = {knob.name: knob.base for knob in knobs}
    found = [base] + [
        {**base, knob.name: value} for knob in knobs for value in knob.values if value != knob.base
    ]
    return found


def points_of(study, origins):
    """The points of a study, the reference too; @origins: the Origins of runs of its scene."""
    compared = [knob for knob in study.knobs if not knob.average]
    averaged = [knob for knob in study.knobs if knob.average]
    repeats = [
        dict(zip([knob.name for knob in averaged], values))
        for values in itertools.product(*(knob.values for knob in averaged))
    ]
    rows = combinations(study, compared)
    if study.reference is not None and study.reference not in rows:
        rows.append(study.reference)
    added = (
        study.reference is not None
        and rows[-1] == study.reference
        and study.reference not in combinations(study, compared)
    )
    points = []
    for number, values in enumerate(rows):
        tasks = [task_of(study, {**values, **repeat}, origins) for repeat in repeats]
        points.append(
            Point(values, tasks, values == study.reference, added and number == len(rows) - 1)
        )
    names = [task.name for point in points for task in point.tasks]
    if len(set(names)) < len(names):
        raise InputError(
            f"{study.path}: two points of the study are the same run, {max(names, key=names.count)}"
        )
    return points


def folder_of(output, task):
    return os.path.join(output, "runs", task.name)
