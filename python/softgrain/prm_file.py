# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Files in the form of parameter files, read by the rules of the program, with the line of every
entry.
"""

import difflib
import os
from dataclasses import dataclass
from typing import Any, Dict, List

from .errors import InputError

WORDS = ("set", "subsection", "end", "include")
# As in the program: sections within each other; files on the way of includes, the first counted;
# includes altogether.
MOST_SECTIONS, DEEPEST_INCLUDE, MOST_INCLUDES = 16, 16, 200


@dataclass
class Item:
    """A value and where it stands, as 'file:line'."""

    text: str
    where: str


def read_text(path):
    try:
        with open(path, encoding="utf-8-sig") as file:
            return file.read()
    except FileNotFoundError as error:
        raise InputError(f"there is no file '{path}'") from error
    except IsADirectoryError as error:
        raise InputError(f"'{path}' is a folder, not a file") from error
    except UnicodeDecodeError as error:
        raise InputError(f"'{path}' is no text: {error}") from error


def read_prm(path, including=(), counter=None):
    """
    {(section, ..., name): Item} of a file and of those that it includes. What a file sets itself
    counts more than what it includes, wherever the include stands; of two includes the later
    counts.

    >>> with open("small.prm", "w") as file:
    ...     _ = file.write("subsection Mesh  # cells\\n  set Cell size = 1e-3\\nend\\n")
    >>> read_prm("small.prm")
    {('Mesh', 'Cell size'): Item(text='1e-3', where='small.prm:2')}
    """
    counter = counter if counter is not None else []
    included: Dict[str, Any] = {}
    items: Dict[Any, Any] = {}
    own: Dict[Any, Any] = {}
    sections: List[str] = []
    opened: List[Any] = []
    continued = ""
    number = 0

    def fail(text):
        raise InputError(f"{path}:{number}: {text}")

    for number, line in enumerate(read_text(path).splitlines(), 1):
        line = (continued + line.split("#")[0]).strip()
        continued = ""
        if line.endswith("\\"):
            continued = line[:-1]
            continue
        if not line:
            continue
        word, _, rest = line.replace("\t", " ").partition(" ")
        rest = rest.strip()
        if word == "set":
            name, equals, value = rest.partition("=")
            key = (*sections, name.strip())
            if not equals:
                fail(f"'{line}' has no '='")
            if not name.strip():
                fail(f"'{line}' names no parameter")
            if key in own:
                fail(f"'{'/'.join(key)}' is set twice, first on line {own[key]}")
            own[key] = number
            items[key] = Item(value.strip(), f"{path}:{number}")
        elif word == "subsection":
            if not rest:
                fail("'subsection' needs a name")
            if len(sections) == MOST_SECTIONS:
                fail(f"more than {MOST_SECTIONS} subsections within each other")
            sections.append(rest)
            opened.append(number)
        elif line == "end":
            if not sections:
                fail("'end' closes no subsection")
            sections.pop()
            opened.pop()
        elif word == "include":
            if sections:
                fail("'include' must stand outside of subsections")
            other = os.path.join(os.path.dirname(path), rest)
            if os.path.realpath(other) in (*including, os.path.realpath(path)):
                fail(f"'{rest}' includes itself")
            if not rest or not os.path.isfile(other):
                fail(f"there is no file '{other}' to include")
            if len(including) + 1 == DEEPEST_INCLUDE:
                fail(f"more than {DEEPEST_INCLUDE} files that include each other")
            counter.append(other)
            if len(counter) > MOST_INCLUDES:
                fail(
                    f"this is include number {len(counter)}, and {MOST_INCLUDES} are allowed; a"
                    " file that is included twice counts twice"
                )
            included.update(read_prm(other, (*including, os.path.realpath(path)), counter))
        else:
            near = difflib.get_close_matches(word, WORDS, 1)
            fail(
                f"'{line}' is not understood: a line starts with set, subsection, end or include"
                + (f" (did you mean '{near[0]}'?)" if near else "")
            )
    if continued:
        fail("the file ends within a line continued by '\\'")
    if sections:
        raise InputError(f"{path}:{opened[-1]}: subsection '{sections[-1]}' has no 'end'")
    return {**included, **items}
