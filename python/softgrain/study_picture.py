# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a study: error against cost, the best points joined."""

from typing import Any, Dict

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from .curves import COLOURS, style_of_axes
from .drawing import STYLE

COST_TEXTS = {
    "cpu_seconds": ("processor time", 1.0, "s"),
    "wall_seconds": ("time", 1.0, "s"),
    "peak_memory_bytes": ("most memory", 2.0**20, "MiB"),
}
MARKERS = "os^Dv<>pPX"
DECADE = 1.6  # axes that span less than this factor are no good logarithmic


def usable(findings, quantity):
    """(result, cost, error) of the points that a picture can show, the cheapest first."""
    study = findings.study
    divisor = COST_TEXTS[study.cost][1]
    found = [
        (one, one.cost(study.cost) / divisor, one.differences[quantity].error)
        for one in findings.results
    ]
    return sorted(
        (
            (one, cost, error)
            for one, cost, error in found
            if np.isfinite(cost) and np.isfinite(error) and cost > 0 and error > 0
        ),
        key=lambda item: item[1],
    )


def bars_of(results, quantity):
    """What the error of every point may be off by; None where nothing is random."""
    found = np.array([one.uncertainty[quantity.name] for one in results])
    found[~np.isfinite(found)] = 0.0
    return found.tolist() if found.any() else None


def groups_of(findings):
    """
    How points are told apart: (knob of the labels, {other values: points}); the knob with most
    values is that of the labels.
    """
    knobs = [knob for knob in findings.study.knobs if not knob.average]
    if not knobs:
        return None, {}
    many = max(knobs, key=lambda knob: len(knob.values))
    groups: Dict[str, Any] = {}
    for one in findings.results:
        others = ", ".join(
            f"{name} = {value}" for name, value in one.point.values.items() if name != many.name
        )
        groups.setdefault(others, []).append(one)
    return many, groups


def literal(text):
    """
    A text that matplotlib draws as it is, and does not take for a formula.

    >>> literal("from 3 $ to 5 $")
    'from 3 \\\\$ to 5 \\\\$'
    """
    return text.replace("$", r"\$")


def draw_study(findings):
    """A figure with a panel for every quantity."""
    study = findings.study
    text, _, unit = COST_TEXTS[study.cost]
    many, groups = groups_of(findings)
    with plt.rc_context(STYLE):
        n = len(study.quantities)
        columns = min(n, 2)
        rows = -(-n // columns)
        figure, panels = plt.subplots(
            rows,
            columns,
            figsize=(6.2 * columns, 4.6 * rows),
            constrained_layout=True,
            squeeze=False,
        )
        for axes in panels.flat[n:]:
            axes.remove()
        for axes, quantity in zip(panels.flat, study.quantities):
            draw_panel(axes, findings, quantity, many, groups)
            axes.set_xlabel(f"{text}  [{unit}]")
            axes.set_ylabel(f"error of {quantity.name.replace('_', ' ')}")
        figure.suptitle(literal(study.title), fontsize="medium")
    return figure


def plain_numbers(axis, values, factor=1.0, unit=""):
    """Numbers as one writes them, at 1, 2 and 5 where there is room for them."""
    axis.set_major_locator(
        LogLocator(subs=(1.0,) if max(values) > 1e3 * min(values) else (1.0, 2.0, 5.0), numticks=20)
    )
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{factor * value:g}{unit}"))
    axis.set_minor_formatter(NullFormatter())


def draw_panel(axes, findings, quantity, many, groups):
    shown = {id(one): (cost, error) for one, cost, error in usable(findings, quantity.name)}
    style_of_axes(axes)
    if not shown:
        axes.text(
            0.5,
            0.5,
            "no point with an error and a cost",
            ha="center",
            va="center",
            transform=axes.transAxes,
        )
        return
    front = sorted(
        shown[id(one)] for one in findings.results if id(one) in shown and one.front[quantity.name]
    )
    if front:
        axes.step(
            *zip(*front),
            where="post",
            color="#8a949e",
            linewidth=1.2,
            linestyle=(0, (4, 2)),
            zorder=2,
            label="best points" if findings.is_front_sure(quantity) else "perhaps the best points",
        )
    for number, (others, group) in enumerate(groups.items()):
        points = [one for one in group if id(one) in shown]
        if not points:
            continue
        x, y = zip(*(shown[id(one)] for one in points))
        colour = COLOURS[number % len(COLOURS)]
        if (bars := bars_of(points, quantity)) is not None:
            # On a logarithmic axis a bar may not reach 0.
            axes.errorbar(
                x,
                y,
                yerr=[np.minimum(bars, 0.9 * np.array(y)), bars],
                fmt="none",
                ecolor=colour,
                elinewidth=1,
                alpha=0.6,
                zorder=3,
            )
        axes.plot(
            x,
            y,
            MARKERS[number % len(MARKERS)],
            color=colour,
            markersize=6.5,
            label=literal(others) or None,
            zorder=4,
            markeredgecolor="white",
            markeredgewidth=0.6,
        )
        for one, a, b in zip(points, x, y):
            axes.annotate(
                literal(one.point.values[many.name]),
                (a, b),
                (5, 4),
                textcoords="offset points",
                fontsize=8,
                color="#3c4650",
                zorder=5,
            )
    errors, costs = [error for _, error in shown.values()], [cost for cost, _ in shown.values()]
    axes.set_yscale("log")
    axes.set_ylim(min(errors) / 2, max(errors) * 2.4)
    plain_numbers(axes.yaxis, errors, 100.0, " %")
    if max(costs) > DECADE * min(costs):
        axes.set_xscale("log")
        axes.set_xlim(min(costs) / 1.3, max(costs) * 1.6)
        plain_numbers(axes.xaxis, costs)
    else:
        axes.set_xlim(0, 1.25 * max(costs))
    for level in findings.study.levels:
        if axes.get_ylim()[0] < level < axes.get_ylim()[1]:
            axes.axhline(level, color="#b9c2cb", linewidth=0.8, zorder=1)
            axes.annotate(
                f"{100 * level:g} %",
                (1, level),
                (-3, 2),
                xycoords=("axes fraction", "data"),
                ha="right",
                textcoords="offset points",
                fontsize=8,
                color="#6b7680",
            )
    handles, labels = axes.get_legend_handles_labels()
    if labels:
        axes.legend(
            handles,
            labels,
            frameon=False,
            fontsize=8,
            title=f"numbers: {many.name}" if many else None,
            title_fontsize=8,
            loc="best",
        )
