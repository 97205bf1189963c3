# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Triangles in space as pixels, by numpy alone: no window, no graphics card and no X server is
needed.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Camera:
    """
    Looks along parallel rays. Rows of ``axes`` are the directions to the right, up and towards the
    viewer; pixels are squares.
    """

    axes: np.ndarray
    low: np.ndarray  # of the picture in its own directions [m]
    pixel: float  # edge [m]
    shape: tuple  # rows and columns of pixels

    def __call__(self, places):
        """Columns, rows from above [pixels] and depths towards the viewer [m] of places."""
        right, up, near = self.axes @ np.asarray(places).T
        return (
            (right - self.low[0]) / self.pixel,
            self.shape[0] - (up - self.low[1]) / self.pixel,
            near,
        )

    def places(self, pixels, depth):
        """Where the middles of pixels, by their number, are at a depth [m]."""
        row, column = np.divmod(pixels, self.shape[1])
        right = self.low[0] + (column + 0.5) * self.pixel
        up = self.low[1] + (self.shape[0] - row - 0.5) * self.pixel
        return np.stack([right, up, depth], axis=1) @ self.axes


def directions(azimuth, elevation):
    """
    Axes of a camera that stands at these angles [degrees] about z and above the plane of x and y.

    >>> directions(-90, 0).round(9) + 0.0
    array([[ 1.,  0.,  0.],
           [ 0.,  0.,  1.],
           [ 0., -1.,  0.]])
    """
    a, e = np.radians([azimuth, elevation])
    near = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.stack([right, np.cross(near, right), near])


def camera_around(places, axes, rows):
    """A camera of so many rows of pixels that sees all places, with a small margin."""
    flat = np.asarray(places) @ axes[:2].T
    low, high = flat.min(axis=0), flat.max(axis=0)
    margin = 0.03 * max(high - low)
    low, high = low - margin, high + margin
    pixel = (high[1] - low[1]) / rows
    return Camera(axes, low, pixel, (rows, int(np.ceil((high[0] - low[0]) / pixel))))


@dataclass
class Seen:
    """What the pixels of a picture see, for those that see something."""

    pixel: np.ndarray  # number
    triangle: np.ndarray
    weight: np.ndarray  # of the three corners
    depth: np.ndarray  # towards the viewer [m]

    def where(self, mask):
        return Seen(self.pixel[mask], self.triangle[mask], self.weight[mask], self.depth[mask])


def fragments(camera, vertices, triangles):
    """Every pixel that a triangle covers, triangle by triangle."""
    x, y, depth = (values[triangles] for values in camera(vertices))
    rows, columns = camera.shape
    first_x, last_x = np.floor(x.min(axis=1)), np.floor(x.max(axis=1))
    first_y, last_y = np.floor(y.min(axis=1)), np.floor(y.max(axis=1))
    size = np.maximum(last_x - first_x, last_y - first_y).astype(int) + 1
    area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
    parts, least = [], 0
    while least < size.max(initial=0):  # triangles of about one size at a time
        most = 2 * max(least, 1)
        chosen = np.flatnonzero((size > least) & (size <= most) & (np.abs(area) > 1e-12))
        step = max(1, 4_000_000 // most**2)
        for begin in range(0, len(chosen), step):
            some = chosen[begin : begin + step]
            # Weights of corners are linear in the place of the pixel.
            px = first_x[some, None] + np.arange(most) + 0.5
            py = first_y[some, None] + np.arange(most) + 0.5
            weight = []
            for k in (0, 1):
                i, j = (k + 1) % 3, (k + 2) % 3
                x1, y1, x2, y2 = x[some, i], y[some, i], x[some, j], y[some, j]
                of_row = (x1 * y2 - x2 * y1)[:, None] + (x2 - x1)[:, None] * py
                of_column = (y1 - y2)[:, None] * px
                weight.append((of_row[:, :, None] + of_column[:, None, :]) / area[some, None, None])
            weight.append(1 - weight[0] - weight[1])
            inside = np.minimum(np.minimum(*weight[:2]), weight[2]) >= -1e-9
            inside &= ((px >= 0) & (px < columns))[:, None, :] & ((py >= 0) & (py < rows))[
                :, :, None
            ]
            which = np.nonzero(inside)
            own = np.stack([w[which] for w in weight], axis=1)
            triangle = some[which[0]]
            parts.append(
                Seen(
                    py[which[:2]].astype(int) * columns + px[which[::2]].astype(int),
                    triangle,
                    own,
                    (own * depth[triangle]).sum(axis=1),
                )
            )
        least = most
    if not parts:
        return Seen(np.zeros(0, int), np.zeros(0, int), np.zeros((0, 3)), np.zeros(0))
    return Seen(
        *(
            np.concatenate([getattr(part, name) for part in parts])
            for name in ("pixel", "triangle", "weight", "depth")
        )
    )


def nearest(seen):
    """Of all that lies behind one pixel what is nearest to the viewer."""
    order = np.lexsort((-seen.depth, seen.pixel))
    first = np.ones(len(order), dtype=bool)
    first[1:] = seen.pixel[order[1:]] != seen.pixel[order[:-1]]
    return seen.where(order[first])


def normals_of(vertices, triangles):
    """Normals of triangles, twice as long as their area."""
    corners = vertices[triangles]
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def smooth_normals(vertices, triangles):
    """Unit normals at the vertices of a surface, outwards."""
    faces = normals_of(vertices, triangles)
    total = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(total, triangles[:, k], faces)
    return total / np.maximum(np.linalg.norm(total, axis=1), 1e-300)[:, None]


def tube(begin, end, radius, n=10):
    """Vertices and triangles of a round tube without ends, in pieces that are not long."""
    length = float(np.linalg.norm(end - begin))
    along = (end - begin) / max(length, 1e-300)
    aside = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    aside /= np.linalg.norm(aside)
    other = np.cross(along, aside)
    angle = 2 * np.pi * np.arange(n) / n
    ring = radius * (np.cos(angle)[:, None] * aside + np.sin(angle)[:, None] * other)
    pieces = int(np.clip(length / (8 * radius), 1, 200)) if radius > 0 else 1
    vertices = np.concatenate(
        [begin + t * (end - begin) + ring for t in np.linspace(0, 1, pieces + 1)]
    )
    low = (n * np.arange(pieces)[:, None] + np.arange(n)).ravel()
    next_ = (n * np.arange(pieces)[:, None] + (np.arange(n) + 1) % n).ravel()
    triangles = np.concatenate(
        [np.stack([low, next_, next_ + n], axis=1), np.stack([low, next_ + n, low + n], axis=1)]
    )
    return vertices, triangles


def joined(parts):
    """Many (vertices, triangles) as one, and the number of its part for every triangle."""
    if not parts:
        return np.zeros((0, 3)), np.zeros((0, 3), dtype=int), np.zeros(0, dtype=int)
    first = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    return (
        np.concatenate([vertices for vertices, _ in parts]),
        np.concatenate([triangles + start for (_, triangles), start in zip(parts, first)]),
        np.repeat(np.arange(len(parts)), [len(triangles) for _, triangles in parts]),
    )


__all__ = ["Camera", "camera_around", "directions", "fragments", "joined", "nearest", "tube"]
