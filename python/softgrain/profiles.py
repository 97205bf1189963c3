# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pressure and traction along one contact."""

import numpy as np

from .contacts import NONE
from .errors import InputError
from .loads import body_names, wall_names
from .tables import Table


def profile_of(state, body, partner, smooth=True) -> Table:
    """
    One row per place where @body meets @partner, from one end of the contact to the other: how far along it the place is, counted
    from the line of the resultant force (``along_m``), the length of outline that it stands for (``length_m``), pressure and
    traction there, and the place. Places are closer than the field of a body can tell forces apart, so each hands a quarter of its
    force to the next on either side (``smooth=False``: none): the resolution is the length of two places. The sums of ``pressure_Pa * length_m`` and ``traction_Pa * length_m`` are the
    normal and the tangential force of all places. A traction is positive where it pulls @body on along the contact.

    @partner is a body, a wall or an obstacle; both are names, bodies may also be told by their numbers. Along the contact one goes
    with the body to the left.
    """
    contacts = state.contacts
    rows, sign = rows_of(state, body, partner)
    if not len(rows):
        raise InputError(f"'{body}' and '{partner}' do not touch at t = {state.time:g} s")
    normal = sign[:, None] * contacts["normal"][rows]
    force = sign[:, None] * contacts["force_N_per_m"][rows]
    place, length = contacts["place_m"][rows], contacts["length_m"][rows]
    # With the body to the left its outward normal points to the right.
    tangent = normal[:, ::-1] * [1, -1]
    pressed, rubbed = (force * normal).sum(axis=1), (force * tangent).sum(axis=1)
    mean = (length[:, None] * tangent).sum(axis=0)
    if np.hypot(*mean) < 0.5 * length.sum():
        raise InputError(f"'{body}' and '{partner}' touch all around: there is no way along their contact")
    along = place @ (mean / np.hypot(*mean))
    weight = np.maximum(pressed, 0)
    along = along - (weight @ along / weight.sum() if weight.sum() > 0 else along.mean())
    order = np.argsort(along, kind="stable")
    if smooth:
        pressed[order], rubbed[order] = spread(pressed[order]), spread(rubbed[order])
    return Table({name: values[order] for name, values in (
        ("along_m", along), ("pressure_Pa", pressed / length), ("traction_Pa", rubbed / length), ("length_m", length),
        ("place_m", place))}, "contact profile")


def spread(forces):
    """
    A quarter of each goes to its neighbours; the sum stays.

    >>> spread(np.array([4., 0., 8.]))
    array([3., 3., 6.])
    """
    moved = forces / 4
    result = forces.copy()
    result[1:] += moved[:-1] - moved[1:]
    result[:-1] += moved[1:] - moved[:-1]
    return result


def rows_of(state, body, partner):
    """Rows of the contacts of @body with @partner, and 1 where @body is the one that feels their force, else -1."""
    contacts = state.contacts
    a, b, wall = (contacts[name].astype(int) for name in ("body_a", "body_b", "wall"))
    b = np.where(wall != NONE, NONE, b)
    own, other = number_of(state, body), number_of(state, partner, may_fail=True)
    walls = np.array([name == partner for name in wall_names(state)] + [False])
    if other is None and not walls.any():
        known = sorted({*body_names(state).values(), *wall_names(state)})
        raise InputError(f"there is no body, wall or obstacle '{partner}'; there are {', '.join(known)}")
    if walls.any():
        found = (a == own) & (wall != NONE) & walls[np.where(wall == NONE, -1, wall)]
        return np.flatnonzero(found), np.ones(found.sum())
    first, second = (a == own) & (b == other), (a == other) & (b == own)
    rows = np.flatnonzero(first | second)
    return rows, np.where(first[rows], 1., -1.)


def number_of(state, body, may_fail=False):
    """Of a body that is told by its name or its number."""
    names = body_names(state)
    for number, name in names.items():
        if body in (name, number):
            return number
    if may_fail:
        return None
    raise InputError(f"there is no body '{body}'; there are {', '.join(map(str, names.values()))}")
