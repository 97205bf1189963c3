# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pictures of grains: bodies or a field in colour, outlines, walls, forces; all of a series by the
same scales.
"""

from dataclasses import dataclass, replace
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from . import drawing, primaries
from .cell import SpreadState, cell_of
from .colouring import Scale, colour_map, find_field
from .errors import InputError
from .picture_fill import fill
from .picture_options import Options, save, title_of
from .space_picture import SpacePicture

# In inches: of a picture, of one of several, of the scene in it.
WIDTH, PANEL_WIDTH, LEAST_DRAWN = 7.0, 4.2, 0.8
LEGEND_WIDTH = 3.2  # inches that legend and scale bar need side by side


@dataclass
class Sizes:
    """
    Of a figure, in inches: all of it, then what is left of the scene and below it, and the scene
    itself.
    """

    width: float
    height: float
    margin: float
    bottom: float
    drawn: float
    scene: float


def get(state, part):
    return getattr(state, part) if state.has(part) else None


class Picture:
    """
    What all states share: options, colours of bodies or the colour scale, the view, the force of
    the widest lines.
    """

    def __init__(self, options, states):
        self.options, self.several = options, len(states) > 1
        options.width = options.width if options.width is not None else WIDTH
        first = states[0]
        self.primaries = primaries.of_primaries(get(first, "points"))
        if options.field is None:
            default = "von_mises_Pa" if first.has("points") else "none"
            options.field = "body" if self.primaries and not options.range else default
        self.scale: Any = None
        self.numbers: Any = None
        self.colours: Any = None
        self.contacts = options.contacts
        self.full_force = self.strongest_attraction = 0.0
        self.longest, self.with_legend = max(abs(state.time) for state in states), True
        self.n_bodies = (
            max(1, len(first.outlines))
            if first.has("outlines")
            else len(np.unique(first.points["body"])) if first.has("points") else 1
        )
        self.survey(states)
        if options.attraction and self.contacts != "inner":
            raise InputError("--attraction needs --contacts inner and a run with 'Inner forces'")

    # --- what all states have in common ---

    def survey(self, states):
        field = (
            None
            if self.options.field in ("body", "none")
            else find_field(states[0], self.options.field)
        )
        samples, bodies, highest = [], [], -1
        low, high = np.full(2, np.inf), np.full(2, -np.inf)
        attraction = (
            self.n_bodies <= 3 if self.options.attraction is None else self.options.attraction
        )
        inner = self.primaries and (
            self.contacts == "inner" or (self.contacts == "auto" and field is None)
        )
        if self.contacts == "inner" and not self.primaries:
            raise InputError(
                f"--contacts inner is for primaries: {states[0].source.path('points')} has no"
                " radius_m"
            )
        inner_forces, chain_forces, arrow_forces = [0.0], [0.0], [0.0]
        for state in states:
            if field:
                if not state.has(field.part):
                    raise InputError(f"frame {state.number} has no {field.part} to colour")
                samples.append(field.values(state))
            elif self.options.field == "body":
                if state.has("bodies"):
                    bodies.append(state.bodies)
                    highest = max(highest, state.bodies["body"].max(initial=-1))
                if state.has("points"):
                    highest = max(highest, state.points["body"].max(initial=-1))
            places = self.places(state)
            low, high = np.minimum(low, places.min(axis=0)), np.maximum(high, places.max(axis=0))
            contacts = get(state, "contacts")
            if (
                contacts is not None
                and len(contacts)
                and self.contacts != "none"
                and not self.along(field)
            ):
                forces = contacts["normal_force_N_per_m"]
                if inner:
                    if (contacts["body_a"] == contacts["body_b"]).any():
                        self.contacts = "inner"
                    inner_forces.append(primaries.full_force(forces))
                    if attraction:
                        self.strongest_attraction = max(self.strongest_attraction, -forces.min())
                outside = primaries.between_bodies(contacts)
                if len(outside):
                    chain_forces.append(drawing.strong_force(drawing.pair_forces(outside)[1]))
                    if self.n_bodies <= 3 or self.contacts == "arrows":
                        arrow_forces.append(drawing.strongest_arrow(outside))
            if self.several:
                state.forget()
        if self.contacts == "auto" and self.along(field):
            self.contacts = "none"  # lines would hide the contacts
        elif self.contacts == "auto":
            self.contacts = "arrows" if self.n_bodies <= 3 else "chains"
        self.full_force = max(
            {"inner": inner_forces, "chains": chain_forces, "arrows": arrow_forces, "none": [0.0]}[
                self.contacts
            ]
        )
        self.set_view(low, high)
        if field:
            self.scale = Scale(field, samples, self.options.range, self.options.colours)
        elif self.options.field == "body":
            self.choose_colours(bodies, highest, states[0].number)

    def along(self, field):
        """Whether the colours are those of contacts, and nothing else is asked of these."""
        return field is not None and field.part == "contact_pressures" and self.contacts == "auto"

    @staticmethod
    def places(state):
        # Of a cell that repeats what lies between its sides is shown.
        places = [state.outlines.points_m] if state.has("outlines") and not cell_of(state) else []
        if state.has("walls"):
            places.append(state.walls["ends_m"].reshape(-1, 2))
        places += state.obstacle_lines
        if not state.has("outlines") and state.has("points"):
            places.append(state.points["position_m"])
        places = [p for p in places if len(p)]
        if not places:
            raise InputError(f"frame {state.number} has neither outlines nor points")
        return np.concatenate(places)

    def set_view(self, low, high):
        """The part that is shown, the same for all states."""
        self.extent = max(high - low)
        self.thickness = 0.03 * self.extent  # of walls
        low, high = low - self.thickness, high + self.thickness
        self.magnified = 1.0
        if zoom := self.options.zoom:
            if len(zoom) == 1:
                middle, half = (low + high) / 2, (high - low) / 2 / zoom[0]
                zoom = (*(middle - half), *(middle + half))
            corners = np.array(zoom, dtype=float).reshape(2, 2)
            if not (corners[1] > corners[0]).all():
                raise InputError(
                    "--zoom X0 Y0 X1 Y1: the second corner must be above and to the right of the"
                    " first"
                )
            if (corners[0] >= high).any() or (corners[1] <= low).any():
                raise InputError(
                    f"--zoom shows nothing: the grains are between {low[0]:.4g} {low[1]:.4g} and "
                    f"{high[0]:.4g} {high[1]:.4g} m"
                )
            self.magnified = max(high - low) / max(corners[1] - corners[0])
            low, high = corners
        self.low, self.high = low, high

    def choose_colours(self, bodies, highest, number):
        """Colours of bodies that stay the same in all states."""
        if highest < 0:
            raise InputError(f"frame {number} has neither outlines nor points")
        self.colours = primaries.PALETTE
        if self.options.colours:
            cmap = colour_map(self.options.colours)
            listed = getattr(cmap, "colors", ())
            self.colours = listed if 2 < len(listed) <= 32 else cmap(np.linspace(0.05, 0.95, 8))
        self.numbers = primaries.colour_numbers(
            int(highest) + 1, primaries.neighbours_of(bodies), len(self.colours)
        )

    # --- one state ---

    def save(self, state, path, dpi):
        """Writes the picture of a state."""
        save(self, state, path, dpi)
        if self.several:
            state.forget()

    def figure(self, state):
        """The picture of a state as a matplotlib figure."""
        with plt.rc_context(drawing.STYLE):
            sizes = self.sizes()
            figure = plt.figure(figsize=(sizes.width, sizes.height))
            self.draw(figure, 0.0, state, sizes)
            return figure

    def draw(self, figure, left, state, sizes, alone=True):
        """
        The picture of a state, so many inches from the left of a figure; when it is not @alone
        others beside it have the same title, and the first the scale bar and what the widths of
        forces mean.
        """
        title, cell = self.title(state), cell_of(state)
        if cell:
            state = SpreadState(state, cell, self.low, self.high)
        numbers = self.numbers[state.owner] if cell and self.numbers is not None else self.numbers
        axes, bar_axes = self.make_axes(figure, left, sizes)
        points_per_metre = 72 * sizes.drawn / (self.high[0] - self.low[0])
        rings = state.outlines.rings if state.has("outlines") else {}
        if state.has("walls") and len(state.walls):
            drawing.draw_walls(axes, state.walls, self.thickness)
        drawing.draw_obstacles(axes, state.obstacle_lines)
        fill(self, axes, state, rings, numbers, points_per_metre)
        if self.scale:
            self.scale.draw_bar(figure, bar_axes)
        width = np.clip(9 * min(self.magnified, 4) / np.sqrt(max(1, len(rings))), 0.6, 1.5)
        drawing.draw_outlines(axes, rings, float(width))
        contacts, self.with_legend = get(state, "contacts"), alone or left == 0
        if contacts is not None and self.full_force:
            {"inner": self.draw_inner, "chains": self.draw_chains, "arrows": self.draw_arrows}[
                self.contacts
            ](figure, axes, state, contacts, points_per_metre)
        if alone or left == 0:
            size = max(self.high - self.low)
            margin = self.thickness if self.magnified == 1 else 0.0
            drawing.draw_scale_bar(axes, self.high[0] - margin, self.low[1] - 0.03 * size, size)
        if alone:
            axes.set_title(title, pad=10, fontsize=12)

    def sizes(self, room=None):
        """
        What a figure needs, as high as the scene, in inches; @room: that of a colour bar, which
        others beside it may have.
        """
        width, low, high = self.options.width, self.low, self.high
        margin, top, bottom = 0.15, 0.45, 0.55
        room = self.bar_room if room is None else room
        drawn = width - 2 * margin - room
        if drawn < LEAST_DRAWN:
            raise InputError(
                f"--width {width:g} leaves no room for a picture: at least"
                f" {width - drawn + LEAST_DRAWN:g} inches are needed"
            )
        height = drawn * (high[1] - low[1]) / (high[0] - low[0])
        if height > 1.6 * width:  # a tall scene: the height is the limit
            drawn, height = drawn * 1.6 * width / height, 1.6 * width
        bottom = max(
            bottom, 0.042 * max(drawn, height) + 0.24
        )  # for the scale bar below and its text
        margin += (
            max(0.0, LEGEND_WIDTH - drawn - 2 * margin - room) / 2
            if self.full_force and self.contacts != "arrows"
            else 0.0
        )
        return Sizes(
            drawn + 2 * margin + room, height + top + bottom, margin, bottom, drawn, height
        )

    @property
    def bar_room(self):
        return 1.25 if self.scale else 0.0

    def make_axes(self, figure, left, sizes):
        """Axes for the scene and, where there is a scale of colours, for its bar."""
        whole_width, whole_height = figure.get_size_inches()
        left += sizes.margin

        def rectangle(x, y, width, height):
            return [x / whole_width, y / whole_height, width / whole_width, height / whole_height]

        axes = figure.add_axes(rectangle(left, sizes.bottom, sizes.drawn, sizes.scene))
        axes.set_aspect("equal")
        axes.set_autoscale_on(False)
        axes.set_xlim(self.low[0], self.high[0])
        axes.set_ylim(self.low[1], self.high[1])
        if self.magnified > 1:  # a thin frame: the scene goes on
            axes.set_xticks([])
            axes.set_yticks([])
        else:
            axes.set_axis_off()
        bar_axes = None
        if self.scale:
            bar = max(min(sizes.scene, 4.5) * 0.86, 1.2)
            bar_axes = figure.add_axes(
                rectangle(
                    left + sizes.drawn + 0.2, sizes.bottom + 0.5 * (sizes.scene - bar), 0.17, bar
                )
            )
        return axes, bar_axes

    def in_view(self, ring):
        return (ring.max(axis=0) > self.low).all() and (ring.min(axis=0) < self.high).all()

    def draw_arrows(self, _figure, axes, _state, contacts, _points_per_metre):
        contacts = primaries.between_bodies(contacts)
        if len(contacts):
            size = self.extent / self.magnified
            drawing.draw_arrows(axes, contacts, 0.11 * size, 0.0035 * size, self.full_force)

    def draw_chains(self, figure, axes, state, contacts, _points_per_metre):
        if not state.has("bodies"):
            raise InputError("force chains need the outlines: use --contacts arrows")
        centers = dict(zip(state.bodies["body"].tolist(), state.bodies["center_m"]))
        width = (
            42.0
            * self.options.width
            / 7
            * np.sqrt(min(self.magnified, self.n_bodies) / self.n_bodies)
        )
        fill, colour = "white", drawing.INK
        if self.primaries:
            width *= 0.5  # the primaries are to be seen
            if not self.scale:
                fill = colour = primaries.REPULSION
        width_per_force = width / self.full_force
        drawing.draw_chains(
            axes, primaries.between_bodies(contacts), centers, width_per_force, width, fill
        )
        if self.with_legend:
            primaries.draw_width_legend(
                figure, axes, width_per_force, self.full_force, colour=colour, fill=fill
            )

    def draw_inner(self, figure, axes, state, contacts, points_per_metre):
        points = get(state, "points")
        diameter = 2 * np.median(points["radius_m"]) if points is not None else 0.0
        width_per_force = max(0.75 * diameter * points_per_metre, 1.0) / self.full_force
        if len(contacts):
            lines, forces, on_wall = primaries.force_lines(contacts, points)
            primaries.draw_force_lines(
                axes,
                lines,
                forces,
                on_wall,
                width_per_force,
                2 * width_per_force * self.full_force,
                self.strongest_attraction > 0,
            )
        if self.with_legend:
            primaries.draw_width_legend(
                figure, axes, width_per_force, self.full_force, self.strongest_attraction
            )

    def title(self, state):
        """The text above the picture."""
        return title_of(state, self.options.title, self.longest, self.several)


class SideBySide:
    """
    Pictures of the same states in several fields, one beside the other; of several each has its own
    colour bar.
    """

    def __init__(self, options, states):
        own = options.field.split(",")
        width = (options.width if options.width is not None else PANEL_WIDTH * len(own)) / len(own)
        self.pictures = [
            Picture(replace(options, field=field.strip(), width=width), states) for field in own
        ]
        options.field = ",".join(picture.options.field for picture in self.pictures)

    def figure(self, state):
        """The picture of a state as a matplotlib figure."""
        room = max(picture.bar_room for picture in self.pictures)
        with plt.rc_context(drawing.STYLE):
            sizes = [picture.sizes(room) for picture in self.pictures]
            height = max(size.height for size in sizes)
            figure, left = plt.figure(figsize=(sum(size.width for size in sizes), height)), 0.0
            for picture, size in zip(self.pictures, sizes):
                picture.draw(figure, left, state, size, alone=False)
                left += size.width
            figure.text(
                0.5,
                1 - 0.2 / height,
                self.pictures[0].title(state),
                ha="center",
                va="center",
                fontsize=12,
            )
            return figure

    def title(self, state):
        """That of every picture."""
        return self.pictures[0].title(state)

    def save(self, state, path, dpi):
        """Writes the picture of a state."""
        save(self, state, path, dpi)
        if self.pictures[0].several:
            state.forget()


def picture_of(options, states):
    """A Picture of the states; of several fields, separated by commas, one beside the other."""
    if states[0].dimension == 3:
        return SpacePicture(options, states)
    for name in ("view", "cut"):
        if getattr(options, name):
            raise InputError(f"--{name} is for runs in space ('Dimension' = '3'): leave it out")
    if options.field and "," in options.field:
        if options.range:
            raise InputError("--range is for one field")
        return SideBySide(options, states)
    return Picture(options, states)


__all__ = ["Options", "Picture", "SideBySide", "picture_of"]
