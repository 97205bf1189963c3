# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The file of a study: a scene, what is changed in it, what is looked at, and what that is compared
with.

Everything wrong is told as one line with the file, its line, the parameter, its value and what is
allowed.
"""

import difflib
import math
import os
import re
from dataclasses import dataclass, field
from typing import Any, Dict, Optional, Tuple

from .errors import InputError
from .formula import CONSTANTS, FUNCTIONS, Formula
from .prm_file import Item, read_prm

COSTS = ("cpu_seconds", "wall_seconds", "peak_memory_bytes")
NORMS = ("max", "rms", "mean", "of means")
AVERAGES = ("means", "errors")
COMBINATIONS = ("all", "one at a time")
NAME = re.compile(r"[A-Za-z_]\w*")
TOP = ("Scene", "Title", "Reference", "Combinations", "Cost", "Longest run", "Levels")
OF_KNOB = ("Parameter", "Values", "Base", "Average")
OF_QUANTITY = ("Column", "Against", "At", "Between", "Width", "Norm", "Average", "Formula", "Curve")
SECTIONS = ("Settings", "Knobs", "Quantities")
TAKEN = {
    "x",
    "point",
    "reference",
    "runs",
    "steps",
    "status",
    *COSTS,
    *CONSTANTS,
    *FUNCTIONS,
}  # no names for knobs


@dataclass
class Knob:
    """What differs between the points of a study: a parameter, or a name that settings use."""

    name: str
    parameter: str
    values: list  # of texts
    base: str  # value while other knobs change one at a time
    average: bool  # runs that differ in this knob alone are one point with a mean and a scatter
    where: str  # of the values
    named_at: str  # where the parameter is named

    @property
    def numeric(self):
        return all(is_number(value) for value in self.values)


@dataclass
class Quantity:
    """A curve of a run, where it is looked at, and how two curves are compared."""

    name: str
    y: Formula
    x: Formula
    at: list  # values of x; empty with a window
    between: Optional[Tuple[float, ...]]  # window of x, None with single values
    width: float  # y is a mean over x ± width
    norm: str
    average: str = "means"  # of averaged runs the means are compared, or errors are averaged
    formula: Optional[Formula] = None  # of x and the numeric knobs
    curve: Any = None  # table of two columns
    where: str = ""

    @property
    def needs_run(self):
        """Whether it is compared with another run."""
        return self.formula is None and self.curve is None


@dataclass
class Study:
    path: str
    scene: str
    title: str
    settings: dict  # {parameter: (text, where)}
    knobs: list
    quantities: list
    reference: Optional[dict]  # {knob: value}; None without one
    combinations: str
    cost: str
    longest_run: float  # seconds, 0: no limit
    levels: list
    changes: dict = field(default_factory=dict)  # of the command line


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def split_list(text):
    """
    Values separated by semicolons, or by commas when there is no semicolon.

    >>> split_list("1, 2"), split_list("0, 0; 1, 1")
    (['1', '2'], ['0, 0', '1, 1'])
    """
    return [one.strip() for one in text.split(";" if ";" in text else ",") if one.strip()]


class Reader:
    """The entries of a study file; what is wrong with one is told with its line."""

    def __init__(self, path):
        self.path, self.items = path, read_prm(path)

    def refuse(self, key, allowed):
        item = self.items[key]
        raise InputError(
            f"{item.where}: '{'/'.join(key)}' = '{item.text}' is not allowed: {allowed}"
        )

    def where(self, *key):
        return self.items[key].where if key in self.items else self.path

    def text(self, *key, default=None):
        if key not in self.items:
            if default is None:
                raise InputError(f"{self.path}: '{'/'.join(key)}' is missing")
            return default
        if not self.items[key].text and default is None:
            self.refuse(key, "it must not be empty")
        return self.items[key].text

    def choice(self, *key, allowed):
        text = self.text(*key, default=allowed[0]).lower()
        if text not in allowed:
            self.refuse(key, "it must be one of " + ", ".join(allowed))
        return text

    def number(self, *key, default, least, words):
        text = self.text(*key, default=default)
        if not is_number(text) or float(text) < least:
            self.refuse(key, words)
        return float(text)

    def numbers(self, *key, words, default=None):
        texts = split_list(self.text(*key, default=default))
        if not all(is_number(text) for text in texts):
            self.refuse(key, words)
        return [float(text) for text in texts]

    def formula(self, *key, default=None):
        text = self.text(*key, default=default)
        try:
            return Formula(text)
        except InputError as error:
            self.refuse(key, str(error))

    def names(self, section, known):
        """The list Names of a section, and a section for each, with no entry that is not known."""
        names = split_list(self.text(section, "Names"))
        for name in names:
            if not NAME.fullmatch(name) or names.count(name) > 1 or name in TAKEN:
                self.refuse(
                    (section, "Names"),
                    f"names are different words of letters, digits and _, not {name}",
                )
            self.check_names((section, name), known)
        for key, item in self.items.items():
            if (
                key[0] == section
                and len(key) > 1
                and key[1] not in names
                and key != (section, "Names")
            ):
                raise InputError(
                    f"{item.where}: '{'/'.join(key[:2])}' is not among '{section}/Names'"
                )
        return names

    def check_names(self, prefix, known):
        for key, item in self.items.items():
            if key[: len(prefix)] == prefix and (
                len(key) > len(prefix) + 1 or key[-1] not in known
            ):
                near = difflib.get_close_matches(key[len(prefix)], known, 1)
                raise InputError(
                    f"{item.where}: unknown parameter '{'/'.join(key)}'"
                    + (
                        f" (did you mean '{'/'.join((*prefix, near[0]))}'?)"
                        if near
                        else f"; there are {', '.join(known)}"
                    )
                )


def read_study(path, changes=None):
    """The study of a file; @changes {parameter: value} count in every run, more than the file."""
    reader = Reader(path)
    for key, item in reader.items.items():
        if len(key) > 1 and key[0] not in SECTIONS:
            raise InputError(
                f"{item.where}: unknown section '{key[0]}'; there are {', '.join(SECTIONS)}"
            )
    check_top(reader)
    scene = os.path.normpath(os.path.join(os.path.dirname(path), reader.text("Scene")))
    if not os.path.isfile(scene):
        reader.refuse(("Scene",), f"there is no file '{scene}'")
    knobs = [read_knob(reader, name) for name in reader.names("Knobs", OF_KNOB)]
    quantities = [
        read_quantity(reader, name, knobs) for name in reader.names("Quantities", OF_QUANTITY)
    ]
    levels = reader.numbers(
        "Levels", default="0.05, 0.02, 0.005", words="it must be relative errors above 0"
    )
    if not levels or min(levels) <= 0:
        reader.refuse(("Levels",), "it must be relative errors above 0")
    study = Study(
        path,
        scene,
        reader.text("Title", default=os.path.splitext(os.path.basename(path))[0].replace("_", " ")),
        {
            "/".join(key[1:]): Item(item.text, item.where)
            for key, item in reader.items.items()
            if key[0] == "Settings" and len(key) > 1
        },
        knobs,
        quantities,
        None,
        reader.choice("Combinations", allowed=COMBINATIONS),
        reader.choice("Cost", allowed=COSTS),
        reader.number(
            "Longest run", default="0", least=0.0, words="it must be seconds, 0 for no limit"
        ),
        sorted(levels, reverse=True),
        dict(changes or {}),
    )
    study.reference = read_reference(reader, study)
    check_settings(study)
    return study


def check_top(reader):
    for key, item in reader.items.items():
        if len(key) == 1 and key[0] not in TOP:
            near = difflib.get_close_matches(key[0], TOP, 1)
            raise InputError(
                f"{item.where}: unknown parameter '{key[0]}'"
                + (f" (did you mean '{near[0]}'?)" if near else f"; there are {', '.join(TOP)}")
            )


def read_knob(reader, name):
    key = ("Knobs", name)
    values = split_list(reader.text(*key, "Values"))
    if not values or len(set(values)) < len(values):
        reader.refuse(
            (*key, "Values"),
            (
                "it must be different values, separated by commas, or by semicolons where a value "
                "has commas"
            ),
        )
    base = reader.text(*key, "Base", default=values[0])
    if base not in values:
        reader.refuse((*key, "Base"), f"it must be one of the values {'; '.join(values)}")
    return Knob(
        name,
        reader.text(*key, "Parameter", default=""),
        values,
        base,
        reader.choice(*key, "Average", allowed=("false", "true")) == "true",
        reader.where(*key, "Values"),
        reader.where(*key, "Parameter"),
    )


def read_quantity(reader, name, knobs):
    key = ("Quantities", name)
    if ((*key, "At") in reader.items) == ((*key, "Between") in reader.items):
        raise InputError(
            f"{reader.where(*key, 'At')}: 'Quantities/{name}' needs either 'At' or 'Between'"
        )
    at, between = [], None
    if (*key, "At") in reader.items:
        at = reader.numbers(*key, "At", words="it must be numbers")
    else:
        between = tuple(
            reader.numbers(*key, "Between", words="it must be two numbers, the larger last")
        )
        if len(between) != 2 or not between[0] < between[1]:
            reader.refuse((*key, "Between"), "it must be two numbers, the larger last")
    norm = reader.choice(*key, "Norm", allowed=NORMS)
    if norm == "of means" and not between:
        reader.refuse((*key, "Norm"), "the mean of a window needs 'Between'")
    result = Quantity(
        name,
        reader.formula(*key, "Column"),
        reader.formula(*key, "Against", default="time_s"),
        at,
        between,
        reader.number(
            *key, "Width", default="0", least=0.0, words="it must be a number, at least 0"
        ),
        norm,
        reader.choice(*key, "Average", allowed=AVERAGES),
        where=reader.where(*key, "Column"),
    )
    if (*key, "Formula") in reader.items and (*key, "Curve") in reader.items:
        raise InputError(
            f"{reader.where(*key, 'Curve')}: 'Quantities/{name}' has both a 'Formula' and a 'Curve'"
        )
    if (*key, "Formula") in reader.items:
        formula = reader.formula(*key, "Formula")
        result.formula = formula
        known = {"x"} | {knob.name for knob in knobs if knob.numeric and not knob.average}
        if unknown := sorted(formula.names - known):
            reader.refuse(
                (*key, "Formula"),
                f"there is no '{unknown[0]}'; there are {', '.join(sorted(known))}",
            )
    if (*key, "Curve") in reader.items:
        result.curve = read_curve(reader, (*key, "Curve"))
    return result


def read_curve(reader, key):
    """(x, y) of the first two columns of a table."""
    from .tables import read_table

    path = os.path.normpath(os.path.join(os.path.dirname(reader.path), reader.text(*key)))
    if not os.path.isfile(path):
        reader.refuse(key, f"there is no file '{path}'")
    try:
        table = read_table(path)
    except (InputError, UnicodeDecodeError) as error:
        reader.refuse(key, str(error))
    if len(table.columns) < 2 or len(table) < 2:
        reader.refuse(key, f"'{path}' must have two columns and two rows at least")
    x, y = (table[name] for name in table.columns[:2])
    if not (x[1:] > x[:-1]).all():
        reader.refuse(key, f"the first column of '{path}' must rise")
    return x, y


def read_reference(reader, study):
    """
    {knob: value} of the run that others are compared with; None when only formulas and curves are.
    """
    key, compared = ("Reference",), [knob for knob in study.knobs if not knob.average]
    if not any(quantity.needs_run for quantity in study.quantities):
        if key in reader.items:
            reader.refuse(
                key, "every quantity has a formula or a curve, so that no run is compared with"
            )
        return None
    words = "'finest' or a value for every knob, as 'cell = 1e-4; step = 1e-6'"
    if key not in reader.items:
        missing = next(quantity for quantity in study.quantities if quantity.needs_run)
        raise InputError(
            f"{study.path}: 'Quantities/{missing.name}' has neither 'Formula' nor 'Curve', so that"
            f" 'Reference' is needed: {words}"
        )
    text = reader.text("Reference")
    if text.lower() == "finest":
        for knob in compared:
            if not knob.numeric:
                reader.refuse(
                    key,
                    (
                        f"the values of the knob '{knob.name}' are no numbers, of which the"
                        f" smallest would be the finest: {words}"
                    ),
                )
        return {knob.name: min(knob.values, key=float) for knob in compared}
    result = {}
    for part in split_list(text):
        name, equals, value = (one.strip() for one in part.partition("="))
        if (
            not equals
            or not value
            or name in result
            or name not in [knob.name for knob in compared]
        ):
            reader.refuse(
                key, f"it must be {words}; knobs: {', '.join(knob.name for knob in compared)}"
            )
        result[name] = value
    for knob in compared:
        if knob.name not in result:
            reader.refuse(key, f"'{knob.name}' has no value: it must be {words}")
    return {knob.name: result[knob.name] for knob in compared}


IN_BRACES = re.compile(r"\{([^{}]*)\}")


def check_settings(study):
    """Formulas in braces use knobs that exist; every knob is used; no parameter is set twice."""
    knobs, used = {knob.name: knob for knob in study.knobs}, set()
    for name, item in study.settings.items():
        for text in IN_BRACES.findall(item.text):
            if text.strip() in knobs:
                used.add(text.strip())
                continue
            try:
                names = Formula(text).names
            except InputError as error:
                raise InputError(
                    f"{item.where}: 'Settings/{name}' = '{item.text}' is not allowed: {error}"
                ) from error
            for one in sorted(names):
                if one not in knobs or not knobs[one].numeric:
                    raise InputError(
                        f"{item.where}: 'Settings/{name}' = '{item.text}' is not allowed: there is"
                        f" no knob '{one}' with numbers; knobs: {', '.join(knobs)}"
                    )
            used |= names
    taken: Dict[str, Any] = {}
    for knob in study.knobs:
        if not knob.parameter and knob.name not in used:
            raise InputError(
                f"{knob.where}: 'Knobs/{knob.name}' changes nothing: it needs 'Parameter', or a"
                f" setting with {{{knob.name}}}"
            )
        if knob.parameter and (knob.parameter in study.settings or knob.parameter in taken):
            other = taken.get(knob.parameter, "Settings")
            raise InputError(
                f"{knob.where}: 'Knobs/{knob.name}/Parameter' = '{knob.parameter}' is not allowed:"
                f" {other} sets it, too"
            )
        if knob.parameter:
            taken[knob.parameter] = f"the knob '{knob.name}'"
