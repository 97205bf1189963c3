# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Contacts as the measures count them: rows of one pair of bodies, or of a body and a wall, as one.
"""

import numpy as np

from .tables import Table

NONE = -1


class PairRows:
    """
    Contacts put together by pairs, each seen from the body with the smaller number: ``keys`` (body,
    body, wall) of the pairs, ``which`` pair a row belongs to, the rows' place, normal and force.
    Contacts of a body with itself are left out; ``kept`` says which rows are in.
    """

    def __init__(self, contacts, force):
        a, b, wall = (contacts[name].astype(int) for name in ("body_a", "body_b", "wall"))
        b = np.where(wall != NONE, NONE, b)
        self.kept = (wall != NONE) | (a != b)
        a, b, wall = a[self.kept], b[self.kept], wall[self.kept]
        swap = (wall == NONE) & (b < a)
        sign = np.where(swap, -1.0, 1.0)[:, None]
        self.place = contacts["place_m"][self.kept]
        self.normal, self.force = (sign * contacts[name][self.kept] for name in ("normal", force))
        bodies = np.where(swap, b, a), np.where(swap, a, b)
        self.keys, which = np.unique(
            np.stack([*bodies, wall], axis=1), axis=0, return_inverse=True
        )
        self.which = which.ravel()
        self.count = self.total(np.ones(len(a)))

    def total(self, values):
        """Sums of a pair's rows."""
        n = len(self.keys)
        if values.ndim == 1:
            return np.bincount(self.which, values, minlength=n).astype(float)
        columns = [np.bincount(self.which, column, minlength=n) for column in values.T]
        return np.stack(columns, axis=1).astype(float)

    def places(self):
        """Of each pair the mean place, weighted by the normal forces where there are any."""
        pressed = np.maximum(0.0, (self.force * self.normal).sum(axis=1))
        weight = self.total(pressed)
        by_force = self.total(pressed[:, None] * self.place)
        by_force /= np.where(weight > 0, weight, 1.0)[:, None]
        plain = self.total(self.place) / self.count[:, None]
        return np.where((weight > 0)[:, None], by_force, plain)


def pairs_of(contacts):
    """
    One row per pair, seen from the body with the smaller number: force, place, normal, length and
    number of rows, as doc/measures.md says. Contacts of a body with itself do not count.

    >>> rows = Table({"body_a": np.array([1, 0]), "body_b": np.array([0, 1]),
    ...               "wall": np.array([-1, -1]), "place_m": np.array([[0., 1.], [0., 3.]]),
    ...               "normal": np.array([[1., 0.], [-1., 0.]]), "length_m": np.array([1., 1.]),
    ...               "force_N_per_m": np.array([[2., 0.], [-2., 0.]])})
    >>> pair = pairs_of(rows)
    >>> pair.body_a, pair.body_b, pair.normal_force_N_per_m, pair.place_m, pair.length_m
    (array([0]), array([1]), array([4.]), array([[0., 2.]]), array([2.]))
    """
    rows = PairRows(contacts, "force_N_per_m")
    keys, which, n, count = rows.keys, rows.which, len(rows.keys), rows.count
    place, normal, total = rows.place, rows.normal, rows.total
    length = contacts["length_m"][rows.kept] if "length_m" in contacts else np.zeros(len(which))
    forces, lengths, places = total(rows.force), total(length), rows.places()
    normals = mean_normals(total(length[:, None] * normal), total(normal), forces)
    # Rows may overlap: lengths then add up to more than there is room for.
    turned = normals[which][:, ::-1] * [1, -1]
    along = (place * turned).sum(axis=1)
    low, high = np.full(n, np.inf), np.full(n, -np.inf)
    np.minimum.at(low, which, along)
    np.maximum.at(high, which, along)
    room = high - low + lengths / count
    return Table(
        {
            "body_a": keys[:, 0],
            "body_b": keys[:, 1],
            "wall": keys[:, 2],
            "place_m": places,
            "normal": normals,
            "force_N_per_m": forces,
            "normal_force_N_per_m": (forces * normals).sum(axis=1),
            "length_m": np.where(lengths > 0, np.minimum(lengths, room), room),
            "rows": count.astype(int),
        },
        "pairs",
    )


def mean_normals(by_length, plain, force):
    """
    Weighted by length; where normals cancel, the force is the best guess of where the partner is.
    """
    norms = [np.hypot(*vectors.T) for vectors in (by_length, plain, force)]
    chosen = np.where(
        (norms[0] > 0)[:, None], by_length, np.where((norms[1] > 1e-9)[:, None], plain, force)
    )
    size = np.hypot(*chosen.T)
    return chosen / np.where(size > 0, size, 1.0)[:, None]


def coordination_of(bodies, pairs):
    """Number of bodies and walls that each of the bodies touches."""
    both = pairs["body_b"] != NONE
    ends = np.concatenate([pairs["body_a"], pairs["body_b"][both]])
    most = int(max(bodies.max(initial=-1), ends.max(initial=-1))) + 1
    return np.bincount(ends, minlength=most)[bodies]
