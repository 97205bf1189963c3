#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes one page of finished or running runs: numbers, pictures, a film, curves to zoom into, contacts, parameters."""

import argparse
import os
import sys

try:
    import matplotlib
    matplotlib.use("Agg")  # no display is needed
    from softgrain import InputError, Run
    from softgrain.command import Parser, run_tool
    from softgrain.report import Choices, report
except ImportError as missing:
    package = f"python3-{(missing.name or 'matplotlib').split('.')[0]}"
    print(f"report: Debian's package {package} is needed: apt install {package} ({missing})", file=sys.stderr)
    sys.exit(2)


def parse_arguments():
    parser = Parser(
        prog="report", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="The page is one file that any browser opens, without a network.\n\n"
               "examples:\n"
               "  report.py out                              out/report.html\n"
               "  report.py fine coarse --output both.html   two runs side by side\n"
               "  report.py out --field pressure --frames 80\n"
               "  report.py out --no-film                    in a few seconds\n")
    parser.add_argument("directories", metavar="DIR", nargs="+", help="output folder of a run")
    parser.add_argument("--output", metavar="FILE", help="page to write (default: report.html in the first folder)")
    parser.add_argument("--title", metavar="TEXT", help="heading of the page (default: name of the run)")
    parser.add_argument("--labels", nargs="+", metavar="TEXT", help="names of the runs (default: of their folders)")
    parser.add_argument("--field", help="field in colour, as for 'softgrain render' (default: as there)")
    parser.add_argument("--film", action=argparse.BooleanOptionalAction, default=True,
                        help="a film of the states, by ffmpeg or Pillow (default: with a film)")
    parser.add_argument("--frames", type=int, default=40, help="most frames of a film (default: %(default)s)")
    parser.add_argument("--fps", type=float, default=8, help="frames of a film per second (default: %(default)s)")
    arguments = parser.parse_args()
    if arguments.labels and len(arguments.labels) != len(arguments.directories):
        raise InputError(f"--labels gives {len(arguments.labels)} names for {len(arguments.directories)} runs")
    if arguments.frames < 2:
        raise InputError("--frames must be at least 2; without a film: --no-film")
    if not 0.1 <= arguments.fps <= 120:
        raise InputError("--fps must be 0.1 to 120 frames per second")
    if arguments.output and not arguments.output.endswith((".html", ".htm")):
        raise InputError(f"--output {arguments.output}: the ending must be .html")
    return arguments


def main():
    arguments = parse_arguments()
    runs = [Run(directory) for directory in arguments.directories]
    for run in runs:
        if not any(os.path.exists(run.path(name)) for name in ("history.csv", "summary.json", "parameters.prm")):
            raise InputError(f"{run.directory} is no output folder of a run: it has no history.csv")
    choices = Choices(**{name: getattr(arguments, name) for name in ("title", "field", "labels", "film", "frames", "fps")})
    path = arguments.output or os.path.join(arguments.directories[0], "report.html")
    report(runs, choices).write(path)
    print(path)
    return 0


if __name__ == "__main__":
    run_tool(main)
