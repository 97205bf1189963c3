# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Options that several of the tools have, in one list: what they are called, what they allow, what
their help says.
"""

import argparse

from .errors import InputError


def between(low, high, kind, meaning):
    """The type of an option that takes a number between two limits."""

    def convert(text):
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not low <= value <= high:
            raise argparse.ArgumentTypeError(f"must be {low} to {high} {meaning}, not '{text}'")
        return value

    return convert


SHARED = {
    "field": {
        "help": (
            "field in colour, of the points or of whole bodies (coordination, mean_pressure_Pa;"
            " bodies/NAME where both have it); the unit may be left out; a vector by its length or,"
            " with :x or :y at the end, a component; 'strain' is the equivalent logarithmic strain;"
            " 'body' gives neighbours different colours, 'none' leaves the grains plain; several,"
            " separated by commas, side by side (default: von_mises_Pa; body for primaries)"
        )
    },
    "fps": {
        "type": between(0.1, 120, float, "frames per second"),
        "help": "frames of a film per second (default: %(default)s)",
    },
    "labels": {
        "nargs": "+",
        "metavar": "TEXT",
        "help": "names of the runs (default: of their folders)",
    },
    "title": {"metavar": "TEXT", "help": "text above the picture (default: none)"},
    "dpi": {
        "type": between(10, 2400, int, "dots per inch"),
        "help": "dots per inch (default: %(default)s)",
    },
}


def add_shared(parser, name, **changes):
    """
    Adds an option of the list; @p changes are what this tool has otherwise, such as its default.
    """
    parser.add_argument(f"--{name}", **(SHARED[name] | changes))


def check_labels(arguments):
    if arguments.labels and len(arguments.labels) != len(arguments.directories):
        raise InputError(
            f"--labels gives {len(arguments.labels)} names for {len(arguments.directories)} runs"
        )
