# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands `softgrain render`, `plot` and `figures` share."""

import argparse
import os
import re
import sys

from .errors import InputError


class Parser(argparse.ArgumentParser):
    """
    Its errors are one line, as all others, without the list of options; numbers such as -1e6 are no
    options.
    """

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self._negative_number_matcher = re.compile(
            r"^-(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$", re.IGNORECASE
        )

    def error(self, message):
        raise InputError(f"{message} (--help lists the options)")


def run_tool(main):
    """Runs a command-line tool: errors of the input are one line and exit code 2."""
    name = os.path.splitext(os.path.basename(sys.argv[0]))[0]
    try:
        sys.exit(main())
    except InputError as error:
        print(f"{name}: {error}", file=sys.stderr)
        sys.exit(2)
    except BrokenPipeError:
        sys.exit(0)
    except OSError as error:
        print(f"{name}: {error.strerror}: {error.filename}", file=sys.stderr)
        sys.exit(2)


def warn(name, text):
    """One line on the error stream that does not stop anything."""
    print(f"{name}: warning: {text}", file=sys.stderr)


def save_figure(figure, path, dpi):
    """Writes a picture whole or not at all."""
    folder = os.path.dirname(path)
    if folder:
        os.makedirs(folder, exist_ok=True)
    temporary = os.path.join(folder, ".part-" + os.path.basename(path))
    try:
        figure.savefig(temporary, dpi=dpi, facecolor="white")
    except ValueError as error:  # an ending that matplotlib does not know
        raise InputError(f"cannot write {path}: {str(error).splitlines()[0]}") from error
    os.replace(temporary, path)
