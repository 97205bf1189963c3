#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Makes one page of finished or running runs: numbers, pictures, a film, curves to zoom into,
contacts, parameters.
"""

import argparse
import os
from dataclasses import fields

from needed import packages_of

with packages_of("report"):
    from softgrain import InputError, Run
    from softgrain.command import Parser, run_tool
    from softgrain.options import add_shared, between, check_labels
    from softgrain.report import Choices, report


def parse_arguments():
    parser = Parser(
        prog="softgrain report",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog=(
            "The page is one file that any browser opens, without a network.\n\n"
            "examples:\n"
            "  softgrain report out                              out/report.html\n"
            "  softgrain report fine coarse --output both.html   two runs side by side\n"
            "  softgrain report out --field pressure --frames 80\n"
            "  softgrain report out --no-film                    in a few seconds\n"
        ),
    )
    parser.add_argument("directories", metavar="DIR", nargs="+", help="output folder of a run")
    parser.add_argument(
        "--output", metavar="FILE", help="page to write (default: report.html in the first folder)"
    )
    add_shared(parser, "title", help="heading of the page (default: name of the run)")
    add_shared(parser, "labels")
    add_shared(parser, "field")
    parser.add_argument(
        "--film",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="a film of the states, by ffmpeg or Pillow (default: with a film)",
    )
    parser.add_argument(
        "--frames",
        type=between(2, 10000, int, "frames (without a film: --no-film)"),
        default=40,
        help="most frames of a film (default: %(default)s)",
    )
    add_shared(parser, "fps", default=8)
    arguments = parser.parse_args()
    check_labels(arguments)
    if arguments.output and not arguments.output.endswith((".html", ".htm")):
        raise InputError(f"--output {arguments.output}: the ending must be .html")
    return arguments


def main():
    arguments = parse_arguments()
    runs = [Run(directory) for directory in arguments.directories]
    for run in runs:
        if not any(
            os.path.exists(run.path(name))
            for name in ("history.csv", "summary.json", "parameters.prm")
        ):
            raise InputError(f"{run.directory} is no output folder of a run: it has no history.csv")
    choices = Choices(**{item.name: getattr(arguments, item.name) for item in fields(Choices)})
    path = arguments.output or os.path.join(arguments.directories[0], "report.html")
    report(runs, choices).write(path)
    print(path)
    return 0


if __name__ == "__main__":
    run_tool(main)
