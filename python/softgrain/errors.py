# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong, each told as one clear line."""


import difflib


class InputError(Exception):
    """What the user asked for cannot be done: one clear line, exit code 2."""


class MissingName(InputError, KeyError):
    """There is no column, field or parameter of this name; the text says which there are."""

    def __str__(self):
        return str(self.args[0]) if self.args else ""


class RunFailed(Exception):
    """The program ended with an error, or not in time; the text is its own line."""


def near_names(name, known):
    """
    Names that look like one that does not exist, as 'a or b'; '' without any. The unit at the end
    of a name may be left out.

    >>> near_names("pressur", ["pressure_Pa", "von_mises_Pa"])
    'pressure_Pa'
    """
    from .units import split_unit

    short = {split_unit(one)[0]: one for one in known}
    found = difflib.get_close_matches(name, [*short, *known], 3, 0.75)
    return " or ".join(dict.fromkeys(short.get(one, one) for one in found))


def told_instead(name, known):
    """
    What is said of a name that does not exist: near ones, or all.

    >>> told_instead("presure", ["pressure_Pa"]), told_instead("x", ["time_s", "step"])
    ('did you mean pressure_Pa?', 'there are time_s, step')
    """
    near = near_names(name, known)
    if near:
        return f"did you mean {near}?"
    return f"there are {', '.join(map(str, known)) or 'none'}"


def need(package, error):
    """The error for a missing Python package, naming Debian's."""
    return InputError(f"Debian's package {package} is needed: apt install {package} ({error})")


def need_pip(package, error):
    """The error for a missing Python package that Debian 12 does not have."""
    return InputError(
        f"the Python package {package} is needed: pip install {package} in a virtual environment"
        f" ({error})"
    )
