# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grains of states of a run from its snapshots: figure 4.1 of Nguyen (2016)."""

from __future__ import annotations

import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection, PathCollection

from ..drawing import INK, outline_path
from .tool import NotDrawn

STATES = (0.75, 0.85, 0.95)  # packing fractions
FILLS = ("#cfe3f2", "#f6d9c4", "#cfe8dc", "#efd7e4", "#f5e6bd", "#dfdfdf")


def read_frame(state):
    """(outlines of every body, places and sizes of points or None, box) of a snapshot."""
    points = None
    if state.has("points") and len(state.points):
        points = state.points["position_m"], state.points["area_m2"], state.points["body"]
    walls = dict(zip(state.walls["name"], state.walls["position_m"]))
    return list(state.outlines), points, walls


def frames_near(run, times):
    """Index and packing fraction of the snapshots next to the packings of STATES, each once."""
    at = (
        np.interp(times, run.measures["time_s"], run.measures["packing_fraction"])
        if run.measures
        else None
    )
    if at is None:
        return []
    chosen: list[tuple[int, float]] = []
    for state in STATES:
        index = int(np.argmin(np.abs(at - state)))
        if index not in [c[0] for c in chosen]:
            chosen.append((index, at[index]))
    return chosen


def draw_grains(axes, frame, disks, zoom):
    """
    Bodies of a frame as polygons; in a zoom also the primaries or material points they are made of.
    """
    outlines, points, walls = frame
    paths = [outline_path(body) for body in outlines if body]
    colours = [FILLS[b % len(FILLS)] for b, body in enumerate(outlines) if body]
    axes.add_collection(
        PathCollection(paths, facecolors=colours, edgecolors=INK, linewidths=0.9 if zoom else 0.35)
    )
    if points is not None and (zoom or disks):
        places, sizes, _ = points
        # A material point is drawn smaller than the area it stands for, so that it stays a point.
        diameter = 2 * np.sqrt(sizes / np.pi) * (1.0 if disks else 0.35)
        axes.add_collection(
            EllipseCollection(
                diameter,
                diameter,
                np.zeros(len(diameter)),
                units="xy",
                offsets=places,
                transOffset=axes.transData,
                facecolors="none" if disks else INK,
                edgecolors=INK,
                linewidths=0.25 if disks else 0,
                alpha=0.9 if zoom else 0.35,
            )
        )
    left, right, bottom, top = (walls[name] for name in ("left", "right", "bottom", "top"))
    axes.plot(
        [left, right, right, left, left],
        [bottom, bottom, top, top, bottom],
        color=INK,
        linewidth=1.2,
    )
    axes.set_aspect("equal")
    axes.axis("off")
    if zoom:
        half = 0.17 * max(right - left, top - bottom)
        x, y = (left + right) / 2, (bottom + top) / 2
        axes.set(xlim=(x - half, x + half), ylim=(y - half, y + half))
    else:
        slack = 0.02 * (right - left)
        axes.set(xlim=(left - slack, right + slack), ylim=(bottom - slack, top + slack))


def states(groups):
    """Three states of the smoothest run of every model, and a part of the last one enlarged."""
    rows = []
    for model in dict.fromkeys(group[0].model for group in groups):
        run = next(group[0] for group in groups if group[0].model == model)
        if not os.path.exists(run.output.path("snapshots.h5")):
            continue
        snapshots = run.output.snapshots
        frames = frames_near(run, snapshots.times)
        rows.append((run, [(read_frame(snapshots[index]), packing) for index, packing in frames]))
    rows = [row for row in rows if row[1]]
    if not rows:
        raise NotDrawn("no run has snapshots.h5 and measures.csv")
    n = 1 + max(len(frames) for _, frames in rows)
    figure, axes = plt.subplots(
        len(rows),
        n,
        squeeze=False,
        constrained_layout=True,
        figsize=(3.4 * n, 0.5 + 3.3 * len(rows)),
    )
    for (run, frames), row in zip(rows, axes):
        for one in row:
            one.axis("off")
        for one, (frame, packing) in zip(row, frames):
            draw_grains(one, frame, run.model != "mpm", False)
            one.set_title(f"{run.label}, Φ = {packing:.2f}", fontsize=10)
        draw_grains(row[-1], frames[-1][0], run.model != "mpm", True)
        row[-1].set_title("the same, enlarged", fontsize=10)
    figure.suptitle("Fig. 4.1: states of compaction", fontsize=11)
    return figure
