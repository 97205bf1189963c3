# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Figures of publications, drawn from runs. A set of figures is a module of this folder with a
function main(words) and a line in SETS; nothing else knows its name. It is imported when it is
asked for.
"""

from __future__ import annotations

import difflib
import importlib
import sys

SETS = {
    "thesis-3": "section 3.4 of Nguyen (2016), one grain: softgrain figures thesis-3 DIR...",
    "thesis-4": "chapter 4 of Nguyen (2016), compaction: softgrain figures thesis-4 DIR...",
    "thesis-5": (
        "chapter 5 of Nguyen (2016), biaxial compression: softgrain figures thesis-5 DIR..."
    ),
}

EXAMPLES = """Examples:
  softgrain figures thesis-4 output/uniaxial_compaction_mpm
  softgrain figures thesis-5 output/biaxial_thirty_grains_mpm
  softgrain figures thesis-3 --help
"""


def help_text() -> str:
    """The help of `softgrain figures`, in the form of those that the program itself prints."""
    sets = "".join(f"  {name:<27} {text}\n" for name, text in SETS.items())
    return (
        "draw the figures of a publication from runs\n"
        "Usage: softgrain figures [OPTIONS] SUBCOMMAND\n\n"
        "Options:\n  -h,--help                   Print this help message and exit\n\n"
        f"Subcommands:\n{sets}\n{EXAMPLES}"
    )


def mistake_of(words: list[str]) -> str | None:
    """What is wrong with the name of the set; None where it is one."""
    if not words:
        return f"no command after 'figures'; there are {', '.join(SETS)}"
    if words[0] in SETS:
        return None
    near = difflib.get_close_matches(words[0], SETS, 1)
    guess = f" (did you mean '{near[0]}'?)" if near else ""
    return f"'figures' has no command '{words[0]}'{guess}; there are {', '.join(SETS)}"


def main() -> int:
    words = sys.argv[1:]
    if words and words[0] in ("-h", "--help"):
        print(help_text(), end="")
        return 0
    if mistake := mistake_of(words):
        print(f"softgrain: error: {mistake} (softgrain --help shows examples)", file=sys.stderr)
        return 2
    module = importlib.import_module(f".{words[0].replace('-', '_')}", __name__)
    return module.main(words[1:])
