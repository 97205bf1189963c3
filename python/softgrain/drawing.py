# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of pictures of grains: fields made smooth, walls, contact forces, scale bar."""

import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import Normalize
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path

from .contacts import pairs_of

INK = "#1a1a1a"
STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 11,
    "axes.linewidth": 0.9,
    "axes.edgecolor": INK,
    "text.color": INK,
    "axes.labelcolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "hatch.linewidth": 0.7,
    "svg.fonttype": "none",
    "mathtext.fontset": "dejavusans",
}


def outline_path(rings):
    """
    One path of a body; holes stay open because their direction is made opposite to that of the
    outer ring.
    """
    vertices, codes = [], []
    for number, ring in enumerate(rings):
        x, y = ring[:, 0], ring[:, 1]
        area = np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
        if (area > 0) != (number == 0):
            ring = ring[::-1]
        vertices += [*ring, ring[0]]
        codes += [Path.MOVETO] + [Path.LINETO] * (len(ring) - 1) + [Path.CLOSEPOLY]
    return Path(np.array(vertices), codes)


def smooth_field(points, values, areas, box, fineness=4.0):
    """
    The values at scattered points as a picture of the box (x0, x1, y0, y1), rows from below.

    Moving least squares with linear polynomials: exact for a linear field also at the edge, where a
    mean of neighbours would bend it. The pixels are finer than the points by the factor @fineness.
    """
    spacing = np.sqrt(np.median(areas))
    pixel = spacing / fineness
    nx, ny = (
        int(np.clip(np.ceil((box[2 * i + 1] - box[2 * i]) / pixel), 2, 4000)) for i in range(2)
    )
    size = np.array([(box[1] - box[0]) / nx, (box[3] - box[2]) / ny])
    support = 2.2 * spacing
    reach = np.ceil(support / size).astype(int)
    dx, dy = (
        offset.ravel()
        for offset in np.meshgrid(
            np.arange(-reach[0], reach[0] + 1), np.arange(-reach[1], reach[1] + 1)
        )
    )
    moments = np.zeros((9, nx * ny))
    at = (points - [box[0], box[2]]) / size - 0.5
    near = np.rint(at).astype(int)
    per_chunk = max(1, 4_000_000 // len(dx))
    for begin in range(0, len(points), per_chunk):
        chunk = slice(begin, begin + per_chunk)
        i, j = near[chunk, 0, None] + dx, near[chunk, 1, None] + dy
        # From the pixel to the point, in units of the support.
        x = (at[chunk, 0, None] - i) * size[0] / support
        y = (at[chunk, 1, None] - j) * size[1] / support
        inside = (i >= 0) & (i < nx) & (j >= 0) & (j < ny) & (x * x + y * y < 1)
        v = np.broadcast_to(values[chunk, None], x.shape)[inside]
        pixel_number = (j * nx + i)[inside]
        x, y = x[inside], y[inside]
        w = (1 - x * x - y * y) ** 4
        for m, factor in enumerate((1, x, y, x * x, x * y, y * y, v, x * v, y * v)):
            moments[m] += np.bincount(pixel_number, w * factor, minlength=nx * ny)
    s, sx, sy, sxx, sxy, syy, b, bx, by = moments
    known = s > 1e-3
    slack = 2e-3 * s  # keeps the slopes finite where points lie on a line
    sxx, syy = sxx + slack, syy + slack
    determinant = (
        s * (sxx * syy - sxy * sxy) - sx * (sx * syy - sxy * sy) + sy * (sx * sxy - sxx * sy)
    )
    value = b * (sxx * syy - sxy * sxy) - bx * (sx * syy - sxy * sy) + by * (sx * sxy - sxx * sy)
    with np.errstate(divide="ignore", invalid="ignore"):
        image = np.where(known, value / determinant, np.nan).reshape(ny, nx)
    image = np.clip(image, values.min(), values.max())
    return fill_outward(image)


def fill_outward(image):
    """
    Gives pixels without a value that of their neighbours, so that the outline alone bounds the
    colour.
    """
    for _ in range(200):
        unknown = np.isnan(image)
        if not unknown.any():
            return image
        padded = np.pad(image, 1, constant_values=np.nan)
        neighbours = np.stack(
            [padded[1:-1, :-2], padded[1:-1, 2:], padded[:-2, 1:-1], padded[2:, 1:-1]]
        )
        count = np.isfinite(neighbours).sum(axis=0)
        mean = np.nansum(neighbours, axis=0) / np.maximum(count, 1)
        image = np.where(unknown & (count > 0), mean, image)
    return np.where(np.isnan(image), np.nanmean(image), image)


def draw_smooth(axes, rings, points, body_of, values, areas, norm, cmap):
    """Every body filled by the field, cut off by its outline."""
    order = np.argsort(body_of, kind="stable")
    bodies, starts = np.unique(body_of[order], return_index=True)
    for body, members in zip(bodies, np.split(order, starts[1:])):
        if int(body) not in rings:
            continue
        path = outline_path(rings[int(body)])
        (x0, y0), (x1, y1) = path.vertices.min(axis=0), path.vertices.max(axis=0)
        image = smooth_field(points[members], values[members], areas[members], (x0, x1, y0, y1))
        artist = axes.imshow(
            image,
            origin="lower",
            extent=(x0, x1, y0, y1),
            norm=norm,
            cmap=cmap,
            interpolation="bicubic",
            aspect="equal",
            zorder=2,
        )
        artist.set_clip_path(PathPatch(path, transform=axes.transData))


def draw_disks(axes, points, values, areas, norm, cmap):
    """Every point a disk of its area: primaries."""
    diameter = 2 * np.sqrt(areas / np.pi)
    disks = EllipseCollection(
        diameter,
        diameter,
        np.zeros(len(points)),
        units="xy",
        offsets=points,
        transOffset=axes.transData,
        norm=norm,
        cmap=cmap,
        linewidths=0,
        zorder=2,
    )
    disks.set_array(values)
    axes.add_collection(disks)


def draw_outlines(axes, rings, width, colour=INK):
    for body_rings in rings.values():
        axes.add_patch(
            PathPatch(
                outline_path(body_rings),
                facecolor="none",
                edgecolor=colour,
                linewidth=width,
                joinstyle="round",
                zorder=4,
            )
        )


def draw_along_contacts(axes, pieces, values, norm, colours, width):
    """
    Contacts as lines in the colours of what acts along them; each piece goes on below the next one,
    so that no seam is seen.
    """
    half = 0.55 * (pieces["length_m"][:, None] * pieces["direction"])
    begin, end = pieces["place_m"] - half, pieces["place_m"] + half
    # The copies of a contact in cells that repeat are not in the order of its pieces.
    goes_on = np.append(np.hypot(*(begin[1:] - end[:-1]).T) < 0.5 * pieces["length_m"][:-1], False)
    beyond = np.where(goes_on[:, None], np.roll(end, -1, axis=0), end)
    lines = LineCollection(
        np.stack([begin, end, beyond], axis=1),
        array=values,
        norm=norm,
        cmap=colours,
        linewidths=width,
        capstyle="butt",
        zorder=5,
    )
    lines.set_snap(
        False
    )  # pieces along a wall would end at whole pixels, some longer, some shorter
    axes.add_collection(lines, autolim=False)


def draw_walls(axes, walls, thickness):
    """Hatched bars behind the walls' faces, the faces crisp."""
    ends = list(walls["ends_m"])
    repeats = walls["repeats"] > 0 if "repeats" in walls else np.zeros(len(ends), dtype=bool)
    for number, ((begin, end), normal) in enumerate(zip(ends, walls["normal"])):
        if repeats[number]:  # a side of a cell: bodies go through it
            axes.plot(
                [begin[0], end[0]],
                [begin[1], end[1]],
                color=INK,
                linewidth=1.0,
                linestyle=(0, (6, 4)),
                zorder=6,
            )
            continue
        along = (end - begin) / np.linalg.norm(end - begin)
        back = -thickness * normal
        # Where walls meet, those that lie take the corner.
        others = np.array(
            [point for i, pair in enumerate(ends) if i != number for point in pair]
        ).reshape(-1, 2)
        corner = [
            abs(normal[1]) > abs(normal[0])
            and len(others) > 0
            and np.linalg.norm(others - point, axis=1).min() < 1e-6 * thickness
            for point in (begin, end)
        ]
        first, last = begin - corner[0] * thickness * along, end + corner[1] * thickness * along
        bar = Polygon(
            [first, last, last + back, first + back],
            closed=True,
            facecolor="#e3e3e0",
            edgecolor="#8a8a86",
            hatch="////",
            linewidth=0,
            zorder=1,
        )
        axes.add_patch(bar)
        axes.plot(
            [begin[0], end[0]],
            [begin[1], end[1]],
            color=INK,
            linewidth=1.6,
            solid_capstyle="projecting",
            zorder=3,
        )


def draw_obstacles(axes, lines):
    for line in lines:
        axes.plot(
            line[:, 0],
            line[:, 1],
            color=INK,
            linewidth=2.4,
            solid_capstyle="round",
            solid_joinstyle="round",
            zorder=5,
        )


def pair_forces(contacts):
    """Forces of pairs of bodies, or of body and wall: (pairs, magnitudes)."""
    pairs = pairs_of(contacts)
    return pairs, np.hypot(*pairs["force_N_per_m"].T)


def strong_force(forces):
    """The force of the widest chains: the strongest one in a hundred."""
    return float(np.percentile(forces, 99)) if len(forces) else 0.0


def draw_chains(axes, contacts, centers, width_per_force, full_width, fill="white"):
    """
    Force chains: from centre to contact to centre, as wide as the force is large, a little above
    @full_width at most.
    """
    pairs, forces = pair_forces(contacts)
    order = np.argsort(forces, kind="stable")
    widths = np.minimum(1.3 * full_width, width_per_force * forces[order])
    # The weakest would only blur the picture.
    order, widths = order[widths > 0.04 * full_width], widths[widths > 0.04 * full_width]
    lines = []
    for row in order:
        ends = [centers[b] for b in (pairs["body_a"][row], pairs["body_b"][row]) if b in centers]
        lines.append([ends[0], pairs["place_m"][row], *ends[1:]])
    edge = np.clip(0.35 * widths, 0.0, 0.7)
    for colour, width, above in ((INK, widths + 2 * edge, 5), (fill, widths, 5.1)):
        axes.add_collection(
            LineCollection(
                lines,
                linewidths=width,
                colors=colour,
                capstyle="round",
                joinstyle="round",
                zorder=above,
            )
        )


def thinned(contacts, most=14):
    """
    Places, forces and whether there is a partner; a long row of places becomes fewer, evenly
    spread.
    """
    keys = np.stack([contacts["body_a"], contacts["body_b"], contacts["wall"]], axis=1)
    forces, normals, points = contacts["force_N_per_m"], contacts["normal"], contacts["place_m"]
    places, shared, both = [], [], []
    for key in np.unique(keys, axis=0):
        rows = np.flatnonzero((keys == key).all(axis=1))
        normal = normals[rows].mean(axis=0)
        along = points[rows] @ [normal[1], -normal[0]]
        rows, along = rows[np.argsort(along, kind="stable")], np.sort(along)
        spread = spread_evenly(along, points[rows], forces[rows], most)
        places.append(spread[0])
        shared.append(spread[1])
        both += [contacts["body_b"][rows[0]] >= 0] * len(spread[0])
    return np.concatenate(places), np.concatenate(shared), np.array(both)


def spread_evenly(along, points, forces, most):
    """
    Shares the @forces at @along among even places, each between the two next to it: neighbouring
    rows, closer than the field resolves, may take turns in carrying, and only their sum means
    something. @return places, forces per row.
    """
    spacing = np.median(np.diff(along)) if len(along) > 6 else 0.0
    if spacing <= 0:
        return points, forces
    number = min(most, int((along[-1] - along[0]) / (2.5 * spacing)) + 1)
    if number < 3:
        return points, forces
    centres = np.linspace(along[0], along[-1], number)
    step = centres[1] - centres[0]
    weights = np.clip(1 - np.abs(along - centres[:, None]) / step, 0.0, None)
    # At both ends half of the way to the neighbours is there.
    lengths = (
        np.where((np.arange(number) == 0) | (np.arange(number) == number - 1), 0.5, 1.0) * step
    )
    places = np.stack([np.interp(centres, along, points[:, d]) for d in range(2)], axis=1)
    return places, weights @ forces * (spacing / lengths)[:, None]


def strongest_arrow(contacts):
    """The force of the longest arrow."""
    return float(np.linalg.norm(thinned(contacts)[1], axis=1).max())


def draw_arrows(axes, contacts, length, thickness, strongest):
    """
    Forces on the bodies as arrows from the contact place into the body, of @length for the force
    @strongest.
    """
    places, forces, both = thinned(contacts)
    arrows = forces / strongest * length
    if len(places) > 1:  # close places get slender arrows
        apart = np.linalg.norm(places[:, None] - places, axis=2)
        np.fill_diagonal(apart, np.inf)
        thickness = np.clip(0.27 * np.median(apart.min(axis=1)), 0.3 * thickness, thickness)
    # The partner feels the opposite.
    places, arrows = np.concatenate([places, places[both]]), np.concatenate([arrows, -arrows[both]])
    axes.quiver(
        places[:, 0],
        places[:, 1],
        arrows[:, 0],
        arrows[:, 1],
        angles="xy",
        scale_units="xy",
        scale=1,
        units="xy",
        width=thickness,
        headwidth=3.6,
        headlength=4.4,
        headaxislength=4.0,
        minlength=0.3,
        color="white",
        edgecolor=INK,
        linewidth=0.5,
        zorder=6,
    )


def round_length(length):
    """The largest of 1, 2, 5 times a power of ten that is not above @length."""
    power = 10.0 ** np.floor(np.log10(length))
    return next(power * digit for digit in (5, 2, 1) if power * digit <= length * 1.0001)


def draw_scale_bar(axes, right, below, extent):
    """A bar of a round length under the picture, with its length in a fitting unit."""
    length = round_length(0.22 * extent)
    scale, unit = next(
        (s, u)
        for s, u in ((1, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm"))
        if length >= 0.999 * s or u == "nm"
    )
    axes.plot(
        [right - length, right],
        [below, below],
        color=INK,
        linewidth=3,
        solid_capstyle="butt",
        zorder=7,
        clip_on=False,
    )
    axes.text(
        right - length / 2,
        below - 0.012 * extent,
        f"{length / scale:g} {unit}",
        ha="center",
        va="top",
        zorder=7,
    )


def colour_range(values, signed):
    """From the bulk of the values: a few points at a corner must not eat the scale."""
    low, high = np.nanpercentile(values, [0.5, 99.5])
    if signed:
        top = max(abs(low), abs(high))
        low, high = -top, top
    elif low >= 0 and low < 0.35 * high:
        low = 0.0
    if not high > low:
        high = low + (abs(low) if low else 1.0)
    return low, high


def is_signed(values):
    """Whether zero is in the middle of the values rather than at an end."""
    low, high = np.nanpercentile(values, [2, 98])
    return low < 0 < high and min(-low, high) > 0.15 * max(-low, high)


__all__ = [
    "INK",
    "STYLE",
    "Normalize",
    "draw_smooth",
    "draw_disks",
    "draw_outlines",
    "draw_walls",
    "draw_obstacles",
    "draw_chains",
    "strong_force",
    "pair_forces",
    "draw_arrows",
    "strongest_arrow",
    "draw_scale_bar",
    "colour_range",
    "is_signed",
]
