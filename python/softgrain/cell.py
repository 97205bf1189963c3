# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells that repeat: bodies of a state with those of their images that reach into the cell."""

from functools import cached_property
from typing import Any, Dict, List, Optional

import numpy as np

from .outlines import Outlines
from .tables import Table


class Cell:
    """
    Between the walls that are sides of it. Image (i, j) of a body lies i widths to the right and j
    cells above.

    >>> sides = Table({"repeats": np.array([1., 1.]), "offset_m": np.array([0., 0.]),
    ...                "normal": np.array([[1., 0.], [-1., 0.]]),
    ...                "ends_m": np.array([[[0., 0.], [0., 3.]], [[2., 0.], [2., 3.]]])})
    >>> cell = Cell(sides)
    >>> cell.vectors.tolist(), cell.images()
    ([[2.0, 0.0], [0.0, 0.0]], [(0, 0), (-1, 0), (1, 0)])
    """

    def __init__(self, walls):
        sides = walls["repeats"] > 0
        middle, normal = walls["ends_m"].mean(axis=1)[sides], walls["normal"][sides]
        self.vectors = np.zeros((2, 2))
        for axis in range(2):
            across = np.abs(normal[:, axis]) > 0.5
            if across.any():
                self.vectors[axis, axis] = np.ptp(middle[across, axis])
        width = self.vectors[0, 0]
        offset = float(walls["offset_m"][sides][0])
        # The lattice is the same for offsets that differ by a width.
        self.vectors[1, 0] = (
            offset - width * np.round(offset / width) if width and self.vectors[1, 1] else 0.0
        )

    def images(self):
        """
        Those that may touch or overlap the cell, itself first; beside the cells above there are two
        on each side.
        """
        above = (-1, 0, 1) if self.vectors[1, 1] else (0,)
        beside = (-2, -1, 0, 1, 2) if len(above) > 1 else (-1, 0, 1)
        found = [
            (i, j)
            for j in above
            for i in (beside if self.vectors[0, 0] else (0,))
            if (i, j) != (0, 0)
        ]
        return [(0, 0), *found]

    def number(self, vectors):
        """The images that lie @vectors away, as rows of two whole numbers."""
        up = (
            np.round(vectors[:, 1] / self.vectors[1, 1])
            if self.vectors[1, 1]
            else np.zeros(len(vectors))
        )
        along = vectors[:, 0] - up * self.vectors[1, 0]
        right = (
            np.round(along / self.vectors[0, 0]) if self.vectors[0, 0] else np.zeros(len(vectors))
        )
        return np.stack([right, up], axis=1).astype(int)


def cell_of(state):
    """The cell of a state; None when it does not repeat."""
    if not (
        state.has("walls")
        and state.has("outlines")
        and "repeats" in state.walls
        and (state.walls["repeats"] > 0).any()
    ):
        return None
    return Cell(state.walls)


class SpreadState:
    """
    A state in which images are bodies too: those that can be seen between @low and @high, and their
    neighbours. ``owner[n]`` is the body that body n is an image of.
    """

    def __init__(self, state, cell, low, high):
        self.state, self.cell, self.time, self.number = state, cell, state.time, state.number
        self.walls = state.walls if state.has("walls") else None
        self.obstacle_lines = state.obstacle_lines
        boxes = {
            body: (rings[0].min(axis=0), rings[0].max(axis=0))
            for body, rings in state.outlines.items()
        }
        reach = max((float(np.max(b - a)) for a, b in boxes.values()), default=0.0)
        # Neighbours of what is seen, so that forces between them are drawn.
        low, high = np.asarray(low) - reach, np.asarray(high) + reach
        self.copies: Dict[Any, Any] = {}
        for image in cell.images():
            way = np.array(image) @ cell.vectors
            for body, (a, b) in boxes.items():
                if image == (0, 0) or ((a + way < high).all() and (b + way > low).all()):
                    self.copies[body, image] = (len(self.copies), way)
        self.owner = np.array([body for body, _ in self.copies], dtype=int)
        self.outlines = Outlines(
            {
                n: [ring + way for ring in state.outlines[body]]
                for (body, _), (n, way) in self.copies.items()
            }
        )
        self.bodies = (
            self.spread(state.bodies, "body", ("center_m",)) if state.has("bodies") else None
        )
        self.points = (
            self.spread(state.points, "body", ("position_m",)) if state.has("points") else None
        )
        self.contacts = (
            self.spread_contacts(state.contacts, cell) if state.has("contacts") else None
        )

    @cached_property
    def contact_pressures(self):
        """Pieces of contacts, those of copies too."""
        return self.spread_contacts(self.state.contact_pressures, self.cell)

    def has(self, part):
        return self.state.has(part)

    def spread(self, table, key, places):
        """The rows of @table once for every copy of their body, moved there."""
        rows_of: Dict[int, List[int]] = {}
        for row, body in enumerate(table[key].astype(int).tolist()):
            rows_of.setdefault(body, []).append(row)
        rows, number, way = [], [], []
        for (body, _), (n, there) in self.copies.items():
            mine = rows_of.get(body, [])
            rows += mine
            number += [n] * len(mine)
            way += [there] * len(mine)
        columns = {
            name: values[rows] for name, values in table.items() if len(values) == len(table)
        }
        columns[key] = np.array(number, dtype=int)
        for name in places:
            columns[name] = columns[name] + np.array(way).reshape(-1, 2)
        return Table(columns, table.title, table.path, table.units)

    def spread_contacts(self, contacts, cell):
        a, b = contacts["body_a"].astype(int), contacts["body_b"].astype(int)
        image = (
            cell.number(contacts["image_m"])
            if "image_m" in contacts
            else np.zeros((len(a), 2), dtype=int)
        )
        first_of: Dict[int, Any] = {}
        rows: List[int] = []
        pairs: List[Any] = []
        way: List[Any] = []
        for (body, copy), (n, there) in self.copies.items():
            first_of.setdefault(body, []).append((copy, n, there))
        for row in range(len(a)):
            for copy, n, there in first_of.get(a[row], []):
                partner: Optional[int] = -1
                if b[row] >= 0:
                    partner, _ = self.copies.get(
                        (b[row], (copy[0] + image[row, 0], copy[1] + image[row, 1])), (None, None)
                    )
                if partner is not None:
                    rows.append(row)
                    pairs.append((n, partner))
                    way.append(there)
        columns = {name: values[rows] for name, values in contacts.items()}
        ends = np.array(pairs, dtype=int).reshape(-1, 2)
        columns["body_a"], columns["body_b"] = ends[:, 0], ends[:, 1]
        columns["place_m"] = columns["place_m"] + np.array(way).reshape(-1, 2)
        return Table(columns, contacts.title, contacts.path, contacts.units)


__all__ = ["Cell", "SpreadState", "cell_of"]
