# SPDX-License-Identifier: LGPL-2.1-or-later
"""What sets of figures share: options, the loop over figures, tables, and writing."""

from __future__ import annotations

import argparse
import json
import os
from typing import Any, Callable, Iterable, Mapping, Sequence

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .. import fits
from ..command import Parser, save_figure, warn
from ..drawing import STYLE
from ..options import add_shared

Draw = Callable[[Any], Figure]


class NotDrawn(Exception):
    """Why a figure cannot be made of these runs."""


def parser_of(
    name: str, about: str, epilog: str, dpi: int, figures: Iterable[str] | None = None
) -> Parser:
    """The options that all sets have; @p figures: those that --only may choose."""
    parser = Parser(
        prog=f"softgrain figures {name}",
        description=about,
        epilog=epilog,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("directories", metavar="DIR", nargs="+", help="output folder of a run")
    parser.add_argument(
        "--output",
        metavar="FOLDER",
        default=name,
        help="for figures, constants.md and constants.json (default: %(default)s)",
    )
    parser.add_argument("--format", choices=("png", "svg", "pdf"), default="png")
    add_shared(parser, "dpi", default=dpi)
    if figures is not None:
        names = list(figures)
        parser.add_argument(
            "--only",
            metavar="NUMBER",
            nargs="+",
            choices=names,
            help="figures to draw, of " + ", ".join(names) + " (default: all)",
        )
    return parser


def draw_all(figures: Mapping[str, Draw], of: Any, options: argparse.Namespace) -> None:
    """Draws the figures that are asked for, and says of the others why they are left out."""
    os.makedirs(options.output, exist_ok=True)
    plt.rcParams.update(STYLE)
    for number in getattr(options, "only", None) or figures:
        try:
            figure = figures[number](of)
        except NotDrawn as reason:
            print(f"figure {number} is left out: {reason}")
            continue
        path = os.path.join(options.output, f"fig-{number}.{options.format}")
        save_figure(figure, path, options.dpi)
        print(path)
        plt.close("all")


def write_constants(table: str, numbers: Mapping[str, Any], options: argparse.Namespace) -> None:
    """Writes what was fitted for readers and for programs, and prints it."""
    for name, text in (
        ("constants.md", table),
        ("constants.json", json.dumps(numbers, indent=1) + "\n"),
    ):
        path = os.path.join(options.output, name)
        temporary = os.path.join(options.output, ".part-" + name)
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(temporary, path)
        print(path)
    print(table, end="")


def markdown(rows: Sequence[Sequence[str]]) -> str:
    """Rows as a table in Markdown whose columns are aligned; the first is its head."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |"
        for row in rows
    ]
    lines.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return "\n".join(lines) + "\n"


def warn_of_poor_fits(name: str, runs: Iterable[Any], texts: Mapping[str, str]) -> None:
    """One line for every law that does not describe the data it was fitted to."""
    for run in runs:
        for fitted, quality in run.quality.items():
            if quality < fits.POOR:
                warn(
                    f"figures {name}",
                    (
                        f"{texts[fitted].strip()} of {run.directory} fits poorly, "
                        f"R² = {quality:.2f}: the law does not describe these data"
                    ),
                )


def axes_of(title: str, n: int = 1, height: float = 4.2) -> tuple[Figure, list[Axes]]:
    """A figure with panels side by side."""
    figure, axes = plt.subplots(
        1, n, squeeze=False, constrained_layout=True, figsize=(1.0 + 4.4 * n, height)
    )
    for one in axes[0]:
        one.minorticks_on()
        one.tick_params(which="both", top=True, right=True)
        one.grid(color="#d9d9d9", linewidth=0.6, zorder=0)
        one.set_axisbelow(True)
    figure.suptitle(title, fontsize=11)
    return figure, list(axes[0])


def finish(axes: Axes, x: str, y: str, fontsize: int = 9, **limits: Any) -> None:
    """Labels and limits of a panel, and its legend where it has one."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.set(**limits)
    if axes.get_legend_handles_labels()[1]:
        axes.legend(frameon=False, fontsize=fontsize, handlelength=2.6 if fontsize > 8 else 2.0)
