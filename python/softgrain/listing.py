# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The parameters that the program knows, as it lists them itself: names, defaults, what is allowed,
what they mean.
"""

import functools
import json
import keyword
import os
import re
from dataclasses import dataclass, field
from typing import Dict, Optional

from .programs import call, find_program

NAMES = "Names"  # the parameter of a section whose subsections have names of one's own


@dataclass(frozen=True)
class Entry:
    """A parameter."""

    name: str
    default: str
    allowed: str
    meaning: str


@dataclass
class Listed:
    """
    A section: its parameters and subsections by their names in files, and what a subsection of any
    name has.
    """

    entries: Dict[str, Entry] = field(default_factory=dict)
    sections: Dict[str, "Listed"] = field(default_factory=dict)
    named: Optional["Listed"] = None

    def __deepcopy__(self, _):
        return self  # nobody changes it


def python_name(name: str) -> str:
    """
    The name of a parameter or section as Python can have it.

    >>> [python_name(name) for name in ("Young's modulus", "F-bar", "From")]
    ['youngs_modulus', 'f_bar', 'from_']
    """
    found = re.sub(r"\W+", "_", name.replace("'", "").lower()).strip("_")
    return found + "_" if keyword.iskeyword(found) else found


def read_section(data: dict, names=frozenset()) -> Listed:
    """@names: what stands in the listing for a name of one's own."""
    own = data.get(NAMES, {}).get("value")
    names = names | {own} if own else names
    found = Listed()
    for name, value in data.items():
        if "value" in value and not isinstance(value["value"], dict):
            found.entries[name] = Entry(name, value["default"], value["allowed"], value["meaning"])
        elif name in names:
            found.named = read_section(value, names)
        else:
            found.sections[name] = read_section(value, names)
    return found


@functools.lru_cache(maxsize=None)
def _listed(program: str, model: str, dimension: str, _) -> Listed:
    asked = ["--model", model, "--dimension", dimension, "--format", "json"]
    return read_section(json.loads(call([program, "parameters", *asked])))


def listing(model: str = "mpm", program: Optional[str] = None, dimension: int = 2) -> Listed:
    """All parameters of a model, in the plane or in space."""
    found: str = find_program(program)
    return _listed(found, model, str(dimension), os.stat(found).st_mtime_ns)
