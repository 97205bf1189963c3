#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Runs a scene with all values of some parameters and shows what accuracy costs: a table, a picture
and a page.
"""

import argparse
import os
import sys

from needed import packages_of

with packages_of("study"):
    from softgrain import InputError
    from softgrain.command import Parser, run_tool, save_figure
    from softgrain.runner import heeding_signals
    from softgrain.study import Session
    from softgrain.study_page import study_page
    from softgrain.study_picture import draw_study
    from softgrain.study_text import print_findings

INTERRUPTED, FAILED = 3, 1


def parse_arguments():
    parser = Parser(
        prog="study",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog=(
            "The file names a scene, values of its parameters, and what is compared with what;"
            " doc/studies.md explains\nit. Runs that are finished are used again, interrupted ones"
            " go on, failed ones are kept as failed.\nExit codes: 0 done, 1 a run failed, 2 bad"
            " input, 3 interrupted (the same command goes on).\n\nexamples:\n  study.py study.prm  "
            "                          output/studies/study/study.html\n  study.py study.prm --list"
            "                     the points, and what has become of them\n  study.py study.prm"
            ' --jobs 4                   four runs at a time\n  study.py study.prm --set "Stop/End'
            ' time=0.1"  all runs shorter\n'
        ),
    )
    parser.add_argument("file", metavar="FILE", help="study file: .prm")
    parser.add_argument(
        "--output",
        metavar="DIR",
        help="folder of the study (default: output/studies/NAME for NAME.prm)",
    )
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PATH=VALUE",
        dest="changes",
        help="change a parameter in all runs; counts more than the file; may be repeated",
    )
    parser.add_argument(
        "--jobs",
        type=int,
        default=1,
        metavar="N",
        help=(
            "runs at a time (default: %(default)s); seconds are those of an idle machine only"
            " with 1"
        ),
    )
    parser.add_argument(
        "--threads",
        type=int,
        default=1,
        metavar="N",
        help="threads of a run, 0 for one per core (default: %(default)s)",
    )
    parser.add_argument(
        "--retry", action="store_true", help="run again what failed or took too long"
    )
    parser.add_argument("--no-run", action="store_true", help="run nothing, tell what there is")
    parser.add_argument(
        "--no-pictures", action="store_true", help="a smaller page, without pictures of the states"
    )
    parser.add_argument(
        "--list", action="store_true", help="print the points and their folders, do nothing"
    )
    arguments = parser.parse_args()
    if arguments.jobs < 1:
        raise InputError(f"--jobs {arguments.jobs}: it must be at least 1")
    if arguments.threads < 0:
        raise InputError(f"--threads {arguments.threads}: it must be at least 0")
    arguments.changes = dict(assignment(text) for text in arguments.changes)
    return arguments


def assignment(text):
    name, equals, value = (part.strip() for part in text.partition("="))
    if not equals or not name:
        raise InputError(f'--set {text}: it must be PATH=VALUE, as "Mesh/Cell size=1e-4"')
    return name, value


def print_list(session):
    for task, status in session.statuses():
        print(f"{status:12s} runs/{task.name}")


def main():
    arguments = parse_arguments()
    session = Session(arguments.file, arguments.output, arguments.changes)
    if arguments.list:
        print_list(session)
        return 0
    with session.lock(), heeding_signals():
        whole = arguments.no_run or session.run(
            arguments.jobs, arguments.threads, arguments.retry, lambda line: print(line, flush=True)
        )
        findings = session.findings()
        print_findings(findings)
        picture, page = (os.path.join(session.output, name) for name in ("study.png", "study.html"))
        save_figure(draw_study(findings), picture, 160)
        study_page(findings, not arguments.no_pictures).write(page)
    for path in (os.path.join(session.output, "study.csv"), picture, page):
        print(path)
    if not whole:
        print("interrupted; the same command goes on", file=sys.stderr)
        return INTERRUPTED
    return FAILED if findings.failures else 0


if __name__ == "__main__":
    run_tool(main)
