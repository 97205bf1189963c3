# SPDX-License-Identifier: LGPL-2.1-or-later
"""parameters.prm, the parameters of a run with all defaults."""

import os
import re
from collections.abc import Mapping

from .errors import InputError, MissingName, near_names


def plain(name):
    """'Neo-Hookean' and 'neo_hookean' are one law."""
    return re.sub(r"[^a-z0-9]", "", name.lower())


def as_value(text):
    """
    A number or a truth value where the text is one, else the text.

    >>> as_value("10e6"), as_value("3"), as_value("true"), as_value("0, 0")
    (10000000.0, 3, True, '0, 0')
    """
    if text in ("true", "false"):
        return text == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def read_entries(path):
    """Entries of a parameter file as {(section, ..., name): text}."""
    entries, sections = {}, []
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].strip()
            if match := re.match(r"subsection\s+(.*)", line):
                sections.append(match.group(1).strip())
            elif line == "end" and sections:
                sections.pop()
            elif match := re.match(r"set\s+([^=]+?)\s*=\s*(.*)", line):
                entries[(*sections, match.group(1))] = match.group(2).strip()
    return entries


class Parameters(Mapping):
    """
    Parameters by the names that ``--set`` has, with sections before them.

    >>> p = Parameters({("Model",): "bpm", ("Contact", "Friction"): "0.3"})
    >>> p["Contact/Friction"], p["Model"]
    (0.3, 'bpm')
    """

    def __init__(self, entries, path="parameters.prm"):
        self.entries = {"/".join(key): value for key, value in entries.items()}
        self.path = path

    def __getitem__(self, name):
        return as_value(self.text(name))

    def __iter__(self):
        return iter(self.entries)

    def __len__(self):
        return len(self.entries)

    def __contains__(self, name):
        return name in self.entries

    def __repr__(self):
        return f"<{len(self)} parameters of {self.path}>"

    def text(self, name):
        """A parameter as it stands in the file."""
        if name not in self.entries:
            last = plain(name.rsplit("/", 1)[-1])
            near = [key for key in self.entries if plain(key.rsplit("/", 1)[-1]) == last]
            told = " or ".join(near[:4]) or near_names(name, self.entries)
            raise MissingName(
                f"there is no parameter '{name}' in {self.path}"
                + (f"; did you mean {told}?" if told else "")
            )
        return self.entries[name]

    def names(self, section):
        """The list 'Names' of Materials, Bodies or Walls."""
        return [
            name.strip()
            for name in self.entries.get(f"{section}/Names", "").split(",")
            if name.strip()
        ]

    def section(self, prefix):
        """
        The parameters below a section.

        >>> Parameters({("Contact", "Friction"): "0.3", ("Model",): "mpm"}).section("Contact")
        {'Friction': 0.3}
        """
        start = prefix.rstrip("/") + "/"
        return {key[len(start) :]: self[key] for key in self.entries if key.startswith(start)}

    def find_number(self, name, group):
        """
        The number called @name in the first subsection of @group that has it, in that of its law if
        it says one; None when there is none.
        """
        found = [
            (key.split("/"), value)
            for key, value in self.entries.items()
            if key.split("/")[0] == group and plain(key.rsplit("/", 1)[-1]) == plain(name)
        ]
        for key, value in found:
            law = self.entries.get(f"{group}/{key[1]}/Law")
            if law is None or len(key) < 4 or plain(law) == plain(key[2]):
                try:
                    return float(value)
                except ValueError:
                    return None
        return None


def read_parameters(directory):
    """Parameters of an output folder; none when it has no parameters.prm."""
    path = os.path.join(directory, "parameters.prm")
    if not os.path.exists(path):
        return Parameters({}, path)
    try:
        return Parameters(read_entries(path), path)
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is no text: {error}") from error
