# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong, each told as one clear line."""


class InputError(Exception):
    """What the user asked for cannot be done: one clear line, exit code 2."""


class MissingName(InputError, KeyError):
    """There is no column, field or parameter of this name; the text says which there are."""

    def __str__(self):
        return str(self.args[0]) if self.args else ""


class RunFailed(Exception):
    """The program ended with an error, or not in time; the text is its own line."""


def need(package, error):
    """The error for a missing Python package, naming Debian's."""
    return InputError(f"Debian's package {package} is needed: apt install {package} ({error})")


def need_pip(package, error):
    """The error for a missing Python package that Debian 12 does not have."""
    return InputError(f"the Python package {package} is needed: pip install {package} in a virtual environment ({error})")
