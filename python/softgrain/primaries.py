# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pieces of pictures of bonded primaries: disks coloured by body, forces as lines between their
centres.
"""

from typing import Any, List, Set

import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection, PathCollection
from matplotlib.colors import to_rgb

from .drawing import INK, outline_path, round_length

PALETTE = (
    "#f0dcae",
    "#bdd5ea",
    "#c3ddb9",
    "#f2c6a4",
    "#d6c6e4",
    "#a9d6cf",
    "#ecc0c4",
    "#cfcdc4",
    "#dfe3a6",
)
REPULSION, ATTRACTION = "#9c1414", "#2b6cb0"
THINNER = 0.5  # lines of attraction, which are many
WALL = -1  # in place of a body or a primary


def of_primaries(points):
    """Whether the points are rigid disks."""
    return points is not None and "radius_m" in points


def between_bodies(contacts):
    """The contacts without those of a body with itself."""
    kept = contacts["body_a"] != contacts["body_b"]
    return contacts if kept.all() else contacts.where(kept)


# --- colours
# -------------------------------------------------------------------------------------------------


def neighbours_of(tables):
    """Pairs of bodies that are close to each other in any of the tables of bodies."""
    pairs = set()
    for bodies in tables:
        body, center = bodies["body"], bodies["center_m"]
        radius = np.sqrt(bodies["area_m2"] / np.pi)
        for i in range(len(body)):
            apart = np.hypot(*(center[i + 1 :] - center[i]).T)
            for j in i + 1 + np.flatnonzero(apart < 1.3 * (radius[i] + radius[i + 1 :])):
                pairs.add((body[i], body[j]))
    return pairs


def colour_numbers(n_bodies, pairs, n_colours=len(PALETTE)):
    """A colour for every body, different from those of its neighbours as far as the colours go."""
    neighbours: List[Set[int]] = [set() for _ in range(n_bodies)]
    for a, b in pairs:
        neighbours[a].add(b)
        neighbours[b].add(a)
    numbers = np.full(n_bodies, -1)
    for body in range(n_bodies):
        taken = [numbers[other] for other in neighbours[body]]
        # Begins at another colour each time, so that a body keeps its own as long as its neighbours
        # let it.
        choices = [(body + k) % n_colours for k in range(n_colours)]
        numbers[body] = min(choices, key=taken.count)
    return numbers


def darker(colour, factor=0.62):
    return tuple(factor * part for part in to_rgb(colour))


def draw_bodies(axes, rings, numbers, colours):
    """Bodies as plain areas."""
    axes.add_collection(
        PathCollection(
            [outline_path(body_rings) for body_rings in rings.values()],
            linewidths=0,
            facecolors=[colours[numbers[body]] for body in rings],
            zorder=2,
        )
    )


def draw_points_of_bodies(axes, points, numbers, colours, points_per_metre):
    """
    Every point a disk in the colour of its body, with an edge where it is large enough to be seen.
    """
    diameter = 2 * np.sqrt(points["area_m2"] / np.pi)
    number = numbers[points["body"]]
    on_paper = np.median(diameter) * points_per_metre
    edge = min(0.5, 0.07 * on_paper) if on_paper > 1.5 else 0.0
    axes.add_collection(
        EllipseCollection(
            diameter - edge / points_per_metre,
            diameter - edge / points_per_metre,
            np.zeros(len(diameter)),
            units="xy",
            offsets=points["position_m"],
            transOffset=axes.transData,
            linewidths=edge,
            zorder=2,
            facecolors=np.array([to_rgb(colour) for colour in colours])[number],
            edgecolors=np.array([darker(colour) for colour in colours])[number],
        )
    )


# --- forces
# --------------------------------------------------------------------------------------------------


class Primaries:
    """Finds the primary of a contact by where its surface is."""

    def __init__(self, points):
        self.points, self.body, self.radius = (
            points["position_m"],
            points["body"],
            points["radius_m"],
        )
        # The centre is at most the difference of two radii beside the guess: always in the four
        # nearest cells.
        self.size = 2 * self.radius.max()
        self.low = self.points.min(axis=0) - 2 * self.size
        cells = np.floor((self.points - self.low) / self.size).astype(int)
        self.n_across = cells[:, 0].max() + 4
        keys = cells[:, 1] * self.n_across + cells[:, 0]
        self.order = np.argsort(keys, kind="stable")
        self.keys = keys[self.order]

    def centers(self, body, place, direction, gap, guess):
        """
        Centres of the primaries of @body whose surface is half a @gap beside @place, on the side of
        @direction.

        Where there is none, the @guess stays.
        """
        result, best = guess.copy(), np.full(len(place), 0.2 * self.radius.min())
        corner = np.floor((guess - self.low) / self.size - 0.5).astype(int)
        for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1)):
            key = (corner[:, 1] + dy) * self.n_across + corner[:, 0] + dx
            begin, end = np.searchsorted(self.keys, key), np.searchsorted(
                self.keys, key, side="right"
            )
            for slot in range(int((end - begin).max(initial=0))):
                rows = np.flatnonzero(begin + slot < end)
                i = self.order[begin[rows] + slot]
                reach = self.radius[i] + 0.5 * gap[rows]
                off = np.hypot(*(place[rows] + reach[:, None] * direction[rows] - self.points[i]).T)
                off[self.body[i] != body[rows]] = np.inf
                closer = off < best[rows]
                best[rows[closer]] = off[closer]
                result[rows[closer]] = self.points[i[closer]]
        return result


def force_lines(contacts, points=None):
    """
    (lines, forces, whether with a wall): a contact as a line between the centres of its primaries,
    or to the wall.

    The force is the normal one, positive when it is repulsive. Without points with radii the lines
    have the lengths that the contacts give.
    """
    normal, gap, place = contacts["normal"], contacts["gap_m"], contacts["place_m"]
    body_a, body_b = contacts["body_a"], contacts["body_b"]
    # The length of a contact inside a body is the distance of the centres, else the sum of the two
    # radii.
    half = 0.5 * contacts["length_m"] + np.where(body_a == body_b, 0.0, 0.5 * gap)
    ends = [place + half[:, None] * normal, place - half[:, None] * normal]
    if of_primaries(points) and len(points):
        primaries = Primaries(points)
        ends[0] = primaries.centers(body_a, place, normal, gap, ends[0])
        ends[1] = primaries.centers(body_b, place, -normal, gap, ends[1])
    on_wall = body_b == WALL
    ends[1][on_wall] = (place - 0.5 * gap[:, None] * normal)[on_wall]
    return np.stack(ends, axis=1), contacts["normal_force_N_per_m"], on_wall


def full_force(forces):
    """The repulsive force of the widest lines: the strongest one in two hundred."""
    repulsive = forces[forces > 0]
    return float(np.percentile(repulsive, 99.5)) if len(repulsive) else 0.0


def draw_force_lines(axes, lines, forces, on_wall, width_per_force, widest, attraction):
    """Lines as wide as the force is large, up to @widest [points]; the strong ones lie on top."""
    kinds: List[Any] = [(forces > 0, REPULSION, width_per_force, 5)]
    if attraction:
        kinds.append((forces < 0, ATTRACTION, THINNER * width_per_force, 4.5))
    for chosen, colour, per_force, order in kinds:
        widths = per_force * np.abs(forces)
        chosen = np.flatnonzero(chosen & (widths > 0.02))  # points; less leaves no trace
        chosen = chosen[np.argsort(widths[chosen], kind="stable")]
        wall = chosen[on_wall[chosen]]
        # A round end would reach into the wall.
        ends = lines[wall].copy()
        ends[:, 1] = ends[:, 0] + 1e-3 * (ends[:, 1] - ends[:, 0])
        for rows, shown, cap in (
            (chosen[~on_wall[chosen]], None, "round"),
            (wall, ends, "round"),
            (wall, None, "butt"),
        ):
            axes.add_collection(
                LineCollection(
                    lines[rows] if shown is None else shown,
                    colors=colour,
                    capstyle=cap,
                    linewidths=np.minimum(widths[rows], widest),
                    zorder=order,
                )
            )


def draw_width_legend(
    figure, axes, width_per_force, full, strongest_attraction=0.0, colour=REPULSION, fill=None
):
    """What the widths mean: a line of a round force for each kind, below the picture."""
    size = figure.get_size_inches()
    left, middle = axes.get_position().x0 * size[0], 0.27  # inches
    entries = [("force", full, colour, width_per_force)]
    if strongest_attraction:
        entries = [
            ("repulsion", full, REPULSION, width_per_force),
            ("attraction", strongest_attraction, ATTRACTION, THINNER * width_per_force),
        ]
    for row, (name, force, colour, per_force) in enumerate(entries):
        shown = round_length(1.001 * force)
        width = per_force * shown
        strokes = [(colour, width)]
        if fill not in (None, colour):  # with an edge, as the lines of the picture
            strokes = [(colour, width + 2 * np.clip(0.35 * width, 0.0, 0.7)), (fill, width)]
        y = (middle + 0.2 * (0.5 * (len(entries) - 1) - row)) / size[1]
        for stroke, thick in strokes:
            figure.add_artist(
                LineCollection(
                    [[(left / size[0], y), ((left + 0.42) / size[0], y)]],
                    colors=stroke,
                    linewidths=[thick],
                    transform=figure.transFigure,
                )
            )
        figure.text(
            (left + 0.54) / size[0],
            y,
            f"{name} {shown:g} N/m",
            ha="left",
            va="center_baseline",
            color=INK,
        )


__all__ = [
    "PALETTE",
    "Primaries",
    "between_bodies",
    "colour_numbers",
    "draw_bodies",
    "draw_force_lines",
    "draw_points_of_bodies",
    "draw_width_legend",
    "force_lines",
    "full_force",
    "neighbours_of",
    "of_primaries",
    "REPULSION",
]
