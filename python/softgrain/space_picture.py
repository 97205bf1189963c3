# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pictures of grains in space: a field in colour on their surfaces and in a cut, force chains as
tubes, the box.
"""

import re
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from . import drawing, raster
from .colouring import Scale, find_field
from .errors import InputError
from .picture_options import save, title_of

VIEW = (-60.0, 20.0)  # degrees about z, and above the plane of x and y
PIXELS, FINER = 900, 2  # rows of the picture, and how many each of them is made of
NEAREST = 4  # points that a place takes its value from
PLAIN, TUBES, EDGES = (0.78, 0.80, 0.84), (0.72, 0.11, 0.09), (0.35, 0.35, 0.38)
SHEETS = (0.62, 0.68, 0.76)
LIGHT = np.array([-0.35, 0.55, 0.76])  # from where it comes: right, up, towards the viewer


class Cut:
    """A plane across an axis; what lies between it and the viewer is not shown."""

    def __init__(self, text):
        match: Any = re.fullmatch(r"([xyz])=([-+0-9.eE]+)", text.replace(" ", ""))
        try:
            self.axis, self.at = "xyz".index(match[1]), float(match[2])
        except (TypeError, ValueError):
            raise InputError(
                f"--cut {text}: an axis and a place in metres is meant, as y=0.01"
            ) from None

    def toward(self, axes):
        """1 where the viewer stands on the side of larger coordinates, else -1."""
        return 1.0 if axes[2][self.axis] >= 0 else -1.0


def values_near(places, points, values):
    """At each place the mean of its nearest points, weighted by their distance."""
    result = np.empty(len(places))
    n = min(NEAREST, len(points))
    for begin in range(0, len(places), 2000):
        some = places[begin : begin + 2000]
        square = ((some[:, None, :] - points[None, :, :]) ** 2).sum(axis=2)
        near = np.argpartition(square, n - 1, axis=1)[:, :n]
        weight = 1 / (np.take_along_axis(square, near, axis=1) + 1e-30)
        result[begin : begin + 2000] = (weight * values[near]).sum(axis=1) / weight.sum(axis=1)
    return result


class SpacePicture:
    """What all states share: options, colour scale, view, the force of the widest tubes."""

    def __init__(self, options, states):
        self.options, self.several = options, len(states) > 1
        for name in ("zoom", "attraction", "style"):
            if getattr(options, name):
                raise InputError(f"--{name} is for the plane: leave it out with runs in space")
        if options.contacts not in ("auto", "chains", "none"):
            raise InputError(
                f"--contacts {options.contacts} is for the plane: in space there are chains"
            )
        if options.field and "," in options.field:
            raise InputError("--field: one field at a time is drawn in space")
        if options.field is None:
            options.field = "von_mises_Pa" if states[0].has("points") else "mean_pressure_Pa"
        options.width = options.width if options.width is not None else 7.0
        self.cut: Any = Cut(options.cut) if options.cut else None
        self.axes = raster.directions(*(options.view or VIEW))
        self.longest = max(abs(state.time) for state in states)
        self.field: Any = (
            None if options.field in ("none", "body") else find_field(states[0], options.field)
        )
        self.scale: Any = None
        self.full_force = 0.0
        self.survey(states)

    def survey(self, states):
        samples, places = [], []
        for state in states:
            if self.field:
                samples.append(self.field.values(state))
            places.append(state.source.vertices())
            places += [vertices for vertices, _ in state.obstacle_surfaces.parts]
            if edges := box_edges(state):
                places.append(np.concatenate(edges))
            if self.options.contacts == "chains" and len(state.contacts):
                self.full_force = max(
                    self.full_force, np.quantile(state.pairs["normal_force_N"], 0.99)
                )
            if self.several:
                state.forget()
        self.camera = raster.camera_around(np.concatenate(places), self.axes, PIXELS * FINER)
        if self.field:
            self.scale = Scale(self.field, samples, self.options.range, self.options.colours)

    # --- one state ---

    def save(self, state, path, dpi):
        """Writes the picture of a state."""
        save(self, state, path, dpi)
        if self.several:
            state.forget()

    def figure(self, state):
        """The picture of a state as a matplotlib figure."""
        image = self.image(state)
        bar, head, edge = 1.1 if self.scale else 0.1, 0.4, 0.1
        drawn = self.options.width - bar - edge
        height = drawn * image.shape[0] / image.shape[1]
        with plt.rc_context(drawing.STYLE):
            figure = plt.figure(figsize=(self.options.width, height + head + edge))
            total = height + head + edge
            axes = figure.add_axes(
                (
                    edge / self.options.width,
                    edge / total,
                    drawn / self.options.width,
                    height / total,
                )
            )
            axes.imshow(image, interpolation="antialiased")
            axes.set_axis_off()
            if self.scale:
                left = (edge + drawn + 0.1) / self.options.width
                self.scale.draw_bar(
                    figure,
                    figure.add_axes(
                        (
                            left,
                            (edge + 0.15 * height) / total,
                            0.18 / self.options.width,
                            0.7 * height / total,
                        )
                    ),
                )
            figure.text(
                0.5,
                1 - 0.5 * head / total,
                self.title(state),
                ha="center",
                va="center",
                fontsize=12,
            )
            return figure

    def title(self, state):
        """The text above the picture."""
        return title_of(state, self.options.title, self.longest, self.several)

    def image(self, state):
        """Rows of pixels, red, green and blue from 0 to 1."""
        canvas = np.ones((self.camera.shape[0] * self.camera.shape[1], 3))
        chains = self.options.contacts == "chains"
        depth = self.draw_grains(canvas, state, pale=chains)
        if chains and len(state.contacts):
            self.draw_chains(canvas, depth, state)
        self.draw_obstacles(canvas, depth, state)
        self.draw_box(canvas, depth, state, seen_through=chains)
        rows, columns = (n // FINER * FINER for n in self.camera.shape)
        image = canvas.reshape(*self.camera.shape, 3)[:rows, :columns]
        return image.reshape(rows // FINER, FINER, columns // FINER, FINER, 3).mean(axis=(1, 3))

    def draw_grains(self, canvas, state, pale):
        """@return how near to the viewer each pixel sees a grain"""
        surfaces = state.surfaces
        vertices, triangles, body = raster.joined([surfaces[b] for b in range(len(surfaces))])
        normals = raster.smooth_normals(vertices, triangles)
        facing = np.sign(raster.normals_of(vertices, triangles) @ self.axes[2])
        if not self.cut:  # what faces away is not seen
            triangles, body, facing = (part[facing > 0] for part in (triangles, body, facing))
        seen = raster.fragments(self.camera, vertices, triangles)
        if self.cut:
            place = (seen.weight[:, :, None] * vertices[triangles[seen.triangle]]).sum(axis=1)
            side = self.cut.toward(self.axes)
            seen = seen.where(side * (place[:, self.cut.axis] - self.cut.at) <= 0)
        number = np.full(len(canvas), -1)  # of what each pixel shows: surfaces, then cuts
        depth = np.full(len(canvas), -np.inf)
        first = raster.nearest(seen.where(facing[seen.triangle] > 0))
        normal = (first.weight[:, :, None] * normals[triangles[first.triangle]]).sum(axis=1)
        colours = self.surface_colours(state, vertices, body, triangles, first)
        self.lay(canvas, first.pixel, colours * self.brightness(normal)[:, None], pale)
        depth[first.pixel], number[first.pixel] = first.depth, body[first.triangle]
        if self.cut:
            pixel, own = cut_through(seen, body, facing, len(surfaces))
            place = self.in_cut(pixel)
            self.lay(canvas, pixel, self.cut_colours(state, place, own), pale)
            depth[pixel], number[pixel] = place @ self.axes[2], len(surfaces) + own
        self.draw_borders(canvas, number)
        return depth

    @staticmethod
    def lay(canvas, pixel, colours, pale):
        shown = np.clip(colours, 0, 1)
        canvas[pixel] = 0.25 * shown + 0.75 if pale else shown

    def brightness(self, normal):
        facing = np.clip(normal @ (LIGHT / np.linalg.norm(LIGHT) @ self.axes), 0, 1)
        return 0.55 + 0.5 * facing

    def of_bodies(self, state, own):
        """Colours that whole bodies have; None where points have the field."""
        if self.options.field == "none":
            return np.tile(PLAIN, (len(own), 1)).astype(float)
        if not self.field:
            return np.asarray(plt.get_cmap(self.options.colours or "Set3")(own % 12))[:, :3]
        if self.field.part == "bodies":
            return self.colour(self.field.values(state))[own]
        return None

    def surface_colours(self, state, vertices, body, triangles, seen):
        if (colours := self.of_bodies(state, body[seen.triangle])) is not None:
            return colours
        values, numbers = np.zeros(len(vertices)), self.field.values(state)
        of_vertex = np.full(len(vertices), -1)
        of_vertex[triangles] = body[:, None]
        for b, points, inside in self.points_of(state):
            mine = of_vertex == b
            values[mine] = values_near(vertices[mine], points, numbers[inside])
        return self.colour((seen.weight * values[triangles[seen.triangle]]).sum(axis=1))

    def in_cut(self, pixel):
        """Where pixels see the plane of the cut."""
        axis, normal = self.cut.axis, self.axes[2]
        if abs(normal[axis]) < 0.05:
            raise InputError(
                f"--cut {self.options.cut}: the view is along the plane; choose another --view"
            )
        place = self.camera.places(pixel, np.zeros(len(pixel)))
        return place + ((self.cut.at - place[:, axis]) / normal[axis])[:, None] * normal

    def cut_colours(self, state, place, own):
        if (colours := self.of_bodies(state, own)) is not None:
            return colours
        colours, numbers = np.zeros((len(place), 3)), self.field.values(state)
        for b, points, inside in self.points_of(state):
            mine = own == b
            if mine.any():
                values = on_grid(place[mine], self.cut.axis, points, numbers[inside])
                colours[mine] = self.colour(values)
        return colours

    @staticmethod
    def points_of(state):
        """Number of each body, places of its points, and which they are."""
        body = state.points["body"]
        for b in range(len(state.surfaces)):
            inside = np.flatnonzero(body == b)
            if len(inside):
                yield b, state.points["position_m"][inside], inside

    def draw_borders(self, canvas, number):
        """A dark line where one grain ends, or the cut."""
        number = number.reshape(self.camera.shape)
        border = np.zeros(number.shape, dtype=bool)
        border[:, 1:] |= number[:, 1:] != number[:, :-1]
        border[1:] |= number[1:] != number[:-1]
        canvas[border.ravel()] *= 0.45

    def draw_chains(self, canvas, depth, state):
        pairs, bodies = state.pairs, state.bodies
        surfaces = state.surfaces
        centers = (
            bodies["center_m"]
            if "center_m" in bodies
            else np.array([surfaces[b][0].mean(axis=0) for b in range(len(surfaces))])
        )
        radius = 0.16 * np.cbrt(3 / (4 * np.pi) * np.median(bodies["volume_m3"]))
        parts = []
        for a, b, place, force in zip(
            pairs["body_a"], pairs["body_b"], pairs["place_m"], pairs["normal_force_N"]
        ):
            wide = radius * min(1.5, max(force, 0) / self.full_force) if self.full_force > 0 else 0
            if wide < 0.02 * radius:
                continue
            parts.append(raster.tube(centers[a], place, wide))
            if b >= 0:
                parts.append(raster.tube(place, centers[b], wide))
        self.draw_solid(canvas, depth, parts, TUBES, through=0.0)

    def draw_obstacles(self, canvas, depth, state):
        """Sheets let what is behind them shine through."""
        if not len(state.obstacle_surfaces):
            return
        vertices, triangles, _ = raster.joined(state.obstacle_surfaces.parts)
        seen = raster.fragments(self.camera, vertices, triangles)
        if self.cut:
            place = (seen.weight[:, :, None] * vertices[triangles[seen.triangle]]).sum(axis=1)
            side = self.cut.toward(self.axes)
            seen = seen.where(side * (place[:, self.cut.axis] - self.cut.at) <= 0)
        seen = raster.nearest(seen.where(seen.depth >= depth[seen.pixel]))
        if not len(seen.pixel):
            return
        normals = raster.smooth_normals(vertices, triangles)[triangles[seen.triangle]]
        normal = (seen.weight[:, :, None] * normals).sum(axis=1)
        normal[normal @ self.axes[2] < 0] *= -1  # both sides of a sheet are lit
        colour = np.clip(np.array(SHEETS) * self.brightness(normal)[:, None], 0, 1)
        cover = np.where(np.isfinite(depth[seen.pixel]), 0.3, 0.6)[:, None]
        canvas[seen.pixel] = cover * colour + (1 - cover) * canvas[seen.pixel]

    def draw_box(self, canvas, depth, state, seen_through):
        edges = box_edges(state)
        if not edges:
            return
        width = 1.2 * self.camera.pixel
        parts = [raster.tube(begin, end, width, 6) for begin, end in edges]
        self.draw_solid(canvas, depth, parts, EDGES, 0.5 if seen_through else None)

    def draw_solid(self, canvas, depth, parts, colour, through=None):
        """
        Bodies of one colour; @through is how much of what lies before them covers them, none:
        all.
        """
        vertices, triangles, _ = raster.joined(parts)
        seen = raster.nearest(raster.fragments(self.camera, vertices, triangles))
        if not len(seen.pixel):
            return
        normal = raster.smooth_normals(vertices, triangles)[triangles[seen.triangle]]
        bright = self.brightness((seen.weight[:, :, None] * normal).sum(axis=1))
        shown = np.clip(np.array(colour) * bright[:, None], 0, 1)
        hidden = seen.depth < depth[seen.pixel]
        cover = np.where(hidden, 1.0 if through is None else through, 0.0)[:, None]
        canvas[seen.pixel] = (1 - cover) * shown + cover * canvas[seen.pixel]

    def colour(self, values):
        scale = self.scale
        return np.asarray(scale.map(scale.norm(values / scale.divisor)))[:, :3]


def cut_through(seen, body, facing, n_bodies):
    """
    Pixels in which a body lies on both sides of the cut, and the body: behind it a ray then leaves
    it once more than it enters. @seen is all that lies behind the cut.
    """
    key = seen.pixel * n_bodies + body[seen.triangle]
    keys, which = np.unique(key, return_inverse=True)
    left = np.bincount(which, -facing[seen.triangle], minlength=len(keys))
    pixel, own = np.divmod(keys[left > 0.5], n_bodies)
    first = np.unique(pixel, return_index=True)[1]
    return pixel[first], own[first]


def on_grid(places, axis, points, values):
    """
    Values of points at many places of a plane across an axis: from a grid that is finer than the
    points.
    """
    others = [d for d in range(3) if d != axis]
    low, high = places[:, others].min(axis=0), places[:, others].max(axis=0)
    volume = np.prod(np.maximum(np.ptp(points, axis=0), 1e-30))
    step = 0.4 * np.cbrt(volume / len(points))
    n = np.clip(((high - low) / step).astype(int) + 2, 2, 200)
    ticks = [np.linspace(low[k], high[k], n[k]) for k in (0, 1)]
    grid = np.empty((n[0] * n[1], 3))
    grid[:, axis] = places[0, axis]
    grid[:, others[0]], grid[:, others[1]] = (g.ravel() for g in np.meshgrid(*ticks, indexing="ij"))
    table = values_near(grid, points, values).reshape(n)
    at = [
        np.clip(
            (places[:, others[k]] - low[k]) / max(high[k] - low[k], 1e-30) * (n[k] - 1), 0, n[k] - 1
        )
        for k in (0, 1)
    ]
    i, j = (np.minimum(a.astype(int), n[k] - 2) for k, a in enumerate(at))
    u, v = at[0] - i, at[1] - j
    return (
        (1 - u) * (1 - v) * table[i, j]
        + u * (1 - v) * table[i + 1, j]
        + (1 - u) * v * table[i, j + 1]
        + u * v * table[i + 1, j + 1]
    )


def box_edges(state):
    """The twelve edges between the walls of a box as pairs of places; none without a box."""
    if not state.has("walls") or state.box() is None:
        return []
    row = {name: i for i, name in enumerate(state.walls["name"].tolist())}
    point = state.walls["point_m"]
    sides = (("left", "right"), ("front", "back"), ("bottom", "top"))
    corner = np.array([[point[row[name]][d] for name in pair] for d, pair in enumerate(sides)])
    edges = []
    for d in range(3):
        e, f = (k for k in range(3) if k != d)
        for i in (0, 1):
            for j in (0, 1):
                ends = np.empty((2, 3))
                ends[:, d], ends[:, e], ends[:, f] = corner[d], corner[e][i], corner[f][j]
                edges.append(ends)
    return edges


__all__ = ["SpacePicture"]
