# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Contacts as the measures count them: rows of one pair of bodies, or of a body and a wall, as one.
"""

import numpy as np

from .tables import Table

NONE = -1


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
    a, b, wall = (contacts[name].astype(int) for name in ("body_a", "body_b", "wall"))
    b = np.where(wall != NONE, NONE, b)
    kept = (wall != NONE) | (a != b)
    a, b, wall = a[kept], b[kept], wall[kept]
    place, normal, force = (contacts[name][kept] for name in ("place_m", "normal", "force_N_per_m"))
    length = contacts["length_m"][kept] if "length_m" in contacts else np.zeros(len(a))
    swap = (wall == NONE) & (b < a)
    a, b = np.where(swap, b, a), np.where(swap, a, b)
    sign = np.where(swap, -1.0, 1.0)[:, None]
    normal, force = sign * normal, sign * force
    keys, which = np.unique(np.stack([a, b, wall], axis=1), axis=0, return_inverse=True)
    which, n = which.ravel(), len(keys)

    def total(values):
        if values.ndim == 1:
            return np.bincount(which, values, minlength=n)
        return np.stack([np.bincount(which, column, minlength=n) for column in values.T], axis=1)

    count, forces, lengths = total(np.ones(len(a))), total(force), total(length)
    normals = mean_normals(total(length[:, None] * normal), total(normal), forces)
    pressed = np.maximum(0.0, (force * normal).sum(axis=1))
    weight = total(pressed)
    by_force = total(pressed[:, None] * place) / np.where(weight > 0, weight, 1.0)[:, None]
    places = np.where((weight > 0)[:, None], by_force, total(place) / count[:, None])
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
