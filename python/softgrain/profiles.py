# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pressure and traction along one contact."""

import math

import numpy as np

from .contacts import NONE
from .errors import InputError
from .hertz import half_width
from .loads import body_names, wall_names
from .tables import Table


NARROW = 2.1  # resolutions in a half width, from which on forces tell it better than Hertz's law
FEW = 4  # places that bear a force, below which they tell no width
# Resolutions in a half width, from which on forces tell more than resultant and width.
TERMS_FROM = 5.0
CORNER = math.radians(30)  # turn of an outline from one of its sides to the next
N_PLACES = 33


class Profile(Table):
    """A profile along a contact with its resolution."""

    half_width_m: float
    resolution_m: float
    width_from: str  # 'places', 'forces' or "Hertz's law"


def profile_of(state, body, partner, smooth=True) -> Table:
    """
    Pressure and traction along the contact of @body with @partner, from one of its ends to the
    other: how far along it a place is, counted from the line of the resultant force (``along_m``),
    the length of contact that it stands for (``length_m``), pressure and traction there, and the
    place. The sums of ``pressure_Pa * length_m`` and ``traction_Pa * length_m`` are the normal and
    the tangential force exactly. A traction is positive where it pulls @body on along the contact.

    Forces at single places tell no pressure: their neighbours share them in any way. What they tell
    is their resultant, where it acts, and how far they spread. Between outlines without corners the
    pressure is therefore the half ellipse of the same resultant, line of action and second moment,
    and in contacts that are wider than ten resolutions further terms, √(1-x²) U_n(x), of the same
    moments. A contact narrower than ``2.1 resolution_m`` on either side, or one that bears at fewer
    than four places, has the half width of Hertz's law where the scene tells it. Where an outline
    has corners, and with ``smooth=False``, there is one row for each place that bears a force, of
    which each hands a quarter to the next on either side (``smooth=False``: none).

    The table knows ``half_width_m``, ``resolution_m``, the length of two places, and in
    ``width_from`` where the width comes from.

    @partner is a body, a wall or an obstacle; both are names, bodies may also be told by their
    numbers. Along the contact one goes with the body to the left.
    """
    rows = rows_along(state, body, partner)
    resolution = 2 * float(np.median(rows["length_m"]))
    if (
        not smooth
        or (rows["pressed"] < 0).any()
        or any(has_corners(state, one) for one in (body, partner))
    ):
        return of_places(rows, smooth, resolution)
    return of_moments(
        rows,
        resolution,
        half_width(state, name_of(state, body), name_of(state, partner), rows["pressed"].sum()),
    )


def pressures_of(state) -> Table:
    """
    The profiles of all contacts of a state, one after the other, as short pieces of contact: middle
    (``place_m``), direction and length of each, pressure and traction on it, and between whom it
    is. A contact that tells no width, or goes all around, has the pieces of its single places.
    """
    walls, parts = wall_names(state), []
    for number, (a, b, wall) in enumerate(
        zip(*(state.pairs[name].tolist() for name in ("body_a", "body_b", "wall")))
    ):
        partner = walls[wall] if wall != NONE else b
        rows, _ = rows_of(state, a, partner)
        try:
            profile = profile_of(state, a, partner)
            way = (
                np.gradient(profile["place_m"], axis=0)
                if len(profile) > 1
                else state.contacts["normal"][rows][:1, ::-1] * [1, -1]
            )
        except NoWay:
            profile, way = single_places(state, a, partner)
        n = len(profile["place_m"])
        parts.append(
            {
                "contact": np.full(n, number),
                "body_a": np.full(n, a),
                "body_b": np.full(n, b),
                "wall": np.full(n, wall),
                "place_m": profile["place_m"],
                "direction": way / np.maximum(np.hypot(*way.T), 1e-300)[:, None],
                "length_m": profile["length_m"],
                "contact_pressure_Pa": profile["pressure_Pa"],
                "contact_traction_Pa": profile["traction_Pa"],
                "image_m": np.tile(
                    (
                        state.contacts["image_m"][rows[:1]]
                        if "image_m" in state.contacts
                        else np.zeros((1, 2))
                    ),
                    (n, 1),
                ),
            }
        )
    if not parts:
        return Table(
            {
                "contact": np.zeros(0, dtype=int),
                "body_a": np.zeros(0, dtype=int),
                "body_b": np.zeros(0, dtype=int),
                "wall": np.zeros(0, dtype=int),
                "place_m": np.zeros((0, 2)),
                "direction": np.zeros((0, 2)),
                "length_m": np.zeros(0),
                "contact_pressure_Pa": np.zeros(0),
                "contact_traction_Pa": np.zeros(0),
                "image_m": np.zeros((0, 2)),
            },
            "contact pressures",
        )
    return Table(
        {name: np.concatenate([part[name] for part in parts]) for name in parts[0]},
        "contact pressures",
    )


PARTS_OF_PIECE = 8


def pressures_on_outlines(state) -> Table:
    """
    Pressure and traction of contact at the vertices of all outlines, one after the other as in
    ``state.outlines.points_m``; zero where nothing touches. Both bodies of a contact have it, each
    on its own outline. ``length_m`` is half of both sides at a vertex; sums of
    ``contact_pressure_Pa * length_m`` along a body are what its contacts press, exactly.
    """
    pieces, start = state.contact_pressures, 0
    rings: dict = {}
    for body, loops in state.outlines.items():
        rings[body] = []
        for ring in loops:
            rings[body].append((start, ring))
            start += len(ring)
    length, pressed, rubbed = np.zeros(start), np.zeros(start), np.zeros(start)
    for first, ring in (pair for loops in rings.values() for pair in loops):
        side = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
        length[first : first + len(ring)] = (side + np.roll(side, 1)) / 2
    within = ((np.arange(PARTS_OF_PIECE) + 0.5) / PARTS_OF_PIECE - 0.5)[None, :, None]
    place = (
        pieces["place_m"][:, None]
        + within * (pieces["length_m"][:, None] * pieces["direction"])[:, None]
    )
    part = pieces["length_m"] / PARTS_OF_PIECE
    for number in np.unique(pieces["contact"]):
        rows = np.flatnonzero(pieces["contact"] == number)
        for name, shift in (("body_a", 0), ("body_b", pieces["image_m"][rows[0]])):
            body = int(pieces[name][rows[0]])
            if body not in rings or (name == "body_b" and pieces["wall"][rows[0]] != NONE):
                continue
            vertex, share = vertices_near(rings[body], (place[rows] - shift).reshape(-1, 2))
            for target, of in ((pressed, "contact_pressure_Pa"), (rubbed, "contact_traction_Pa")):
                force = np.repeat(pieces[of][rows] * part[rows], PARTS_OF_PIECE)
                np.add.at(target, vertex, share * force)
    return Table(
        {
            "contact_pressure_Pa": pressed / length,
            "contact_traction_Pa": rubbed / length,
            "length_m": length,
        },
        "outlines",
    )


def vertices_near(rings, places):
    """
    The two vertices at the side that is nearest to each place, and which part each of them takes of
    what is there.
    """
    best = np.full(len(places), np.inf)
    vertex, share = np.zeros((2, len(places)), dtype=int), np.zeros((2, len(places)))
    for first, ring in rings:
        side = np.roll(ring, -1, axis=0) - ring
        along = ((places[:, None] - ring) * side).sum(axis=2) / np.maximum(
            (side**2).sum(axis=1), 1e-300
        )
        along = np.clip(along, 0, 1)
        distance = ((ring + along[..., None] * side - places[:, None]) ** 2).sum(axis=2)
        nearest = distance.argmin(axis=1)
        here = np.arange(len(places))
        better = distance[here, nearest] < best
        best = np.where(better, distance[here, nearest], best)
        at = along[here, nearest]
        vertex = np.where(better, first + np.stack([nearest, (nearest + 1) % len(ring)]), vertex)
        share = np.where(better, np.stack([1 - at, at]), share)
    return vertex, share


class NoWay(InputError):
    """A contact that tells no width, or no direction."""


def single_places(state, body, partner):
    """Pressure and traction of every place by itself, and the directions of contact there."""
    rows, sign = rows_of(state, body, partner)
    contacts = state.contacts
    normal, force = (
        sign[:, None] * contacts["normal"][rows],
        sign[:, None] * contacts["force_N_per_m"][rows],
    )
    tangent, length = normal[:, ::-1] * [1, -1], contacts["length_m"][rows]
    return {
        "place_m": contacts["place_m"][rows],
        "length_m": length,
        "pressure_Pa": (force * normal).sum(axis=1) / length,
        "traction_Pa": (force * tangent).sum(axis=1) / length,
    }, tangent


def rows_along(state, body, partner):
    """
    Places that bear a force, in their order along the contact: normal force on @body, tangential
    force, length and place of each.
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
        raise NoWay(
            f"'{body}' and '{partner}' touch all around: there is no way along their contact"
        )
    along = place @ (mean / np.hypot(*mean))
    weight = np.maximum(pressed, 0)
    along = along - (weight @ along / weight.sum() if weight.sum() > 0 else along.mean())
    order = np.argsort(along, kind="stable")
    return {
        name: values[order]
        for name, values in (
            ("along_m", along),
            ("pressed", pressed),
            ("rubbed", rubbed),
            ("length_m", length),
            ("place_m", place),
            ("tangent", tangent),
        )
    }


def of_places(rows, smooth, resolution):
    """One row for each place."""
    pressed, rubbed, length = rows["pressed"], rows["rubbed"], rows["length_m"]
    if smooth:
        pressed, rubbed = spread(pressed), spread(rubbed)
    table = Profile(
        {
            "along_m": rows["along_m"],
            "pressure_Pa": pressed / length,
            "traction_Pa": rubbed / length,
            "length_m": length,
            "place_m": rows["place_m"],
        },
        "contact profile",
    )
    table.half_width_m, table.resolution_m, table.width_from = (
        float(length.sum() / 2),
        resolution,
        "places",
    )
    return table


def of_moments(rows, resolution, hertz):
    """
    The profile that has the moments of the forces at all places; @hertz is half the width by
    Hertz's law or None.
    """
    along, pressed = rows["along_m"], rows["pressed"]
    measured = 2 * math.sqrt(float(pressed @ along**2 / pressed.sum()))
    by_law = hertz is not None and (hertz < NARROW * resolution or len(along) < FEW)
    if not by_law and (len(along) < FEW or measured <= 0.5 * resolution):
        raise NoWay(
            f"the contact bears its force at {len(along)} place{'s' * (len(along) > 1)} alone,"
            f" which tells no width: make cells smaller until there are {FEW} (round bodies of a"
            " law with Young's modulus and Poisson's ratio have Hertz's)"
        )
    half = hertz if by_law else measured
    # In the middle of equal angles sums are integrals, exactly, and no place is an end of the
    # contact.
    angle = np.pi * (np.arange(N_PLACES) + 1) / (N_PLACES + 1)
    x, root = -np.cos(angle), np.sin(angle)
    length = half * np.pi / (N_PLACES + 1) * root
    terms = 1 if half < TERMS_FROM * resolution else int(half / resolution) - 1
    while True:
        shape = series(along / half, pressed, terms, x)
        if terms <= 1 or shape.min() >= 0:
            break
        terms //= 2
    if shape.min() < 0:
        shape = series(along / half, pressed, 0, x)
    rubbed = series(along / half, rows["rubbed"], min(2, len(along) - 1), x)
    density = 2 / (np.pi * half) * root
    place = np.stack(
        [np.interp(half * x, along, rows["place_m"][:, axis]) for axis in (0, 1)], axis=1
    )
    place += direction_of(rows)[None] * (half * x - np.interp(half * x, along, along))[:, None]
    table = Profile(
        {
            "along_m": half * x,
            "pressure_Pa": density * shape,
            "traction_Pa": density * rubbed,
            "length_m": length,
            "place_m": place,
        },
        "contact profile",
    )
    table.half_width_m, table.resolution_m, table.width_from = (
        half,
        resolution,
        "Hertz's law" if by_law else "forces",
    )
    return table


def direction_of(rows):
    """From the first place to the last; of a single one along its tangent."""
    way = rows["place_m"][-1] - rows["place_m"][0]
    return way / np.hypot(*way) if np.hypot(*way) > 0 else rows["tangent"][0]


def series(places, forces, terms, x):
    """
    The sum of c_n U_n(x) up to a number of terms; with 2/(π a) √(1-x²) before it, it has the
    moments of forces at @places, in half widths a.

    >>> series(np.array([-0.5, 0.5]), np.array([1., 1.]), 2, np.array([0., 0.5])).round(12)
    array([2., 2.])
    """
    inside = np.clip(places, -1, 1)
    total = np.zeros(len(x))
    of_places, of_x = [np.ones(len(inside)), 2 * inside], [np.ones(len(x)), 2 * x]
    for n in range(terms + 1):
        total += (forces @ of_places[0]) * of_x[0]
        of_places, of_x = (
            [now, 2 * z * now - before] for (before, now), z in ((of_places, inside), (of_x, x))
        )
    return total


def has_corners(state, one):
    """
    Whether the outline of a body turns sharply somewhere; a wall and an obstacle do not count.
    """
    number = number_of(state, one, may_fail=True)
    if number is None or not state.has("outlines"):
        return False
    ring = state.outlines[number][0]
    side = np.diff(np.vstack([ring, ring[:1]]), axis=0)
    side = side[np.hypot(*side.T) > 0]
    following = np.roll(side, -1, axis=0)
    turn = np.arctan2(
        side[:, 0] * following[:, 1] - side[:, 1] * following[:, 0], (side * following).sum(axis=1)
    )
    return bool(np.abs(turn).max(initial=0) > CORNER)


def name_of(state, one):
    """The name of a body that may be told by its number."""
    return body_names(state).get(one, one)


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
    """
    Rows of the contacts of @body with @partner, and 1 where @body is the one that feels their
    force, else -1.
    """
    contacts = state.contacts
    a, b, wall = (contacts[name].astype(int) for name in ("body_a", "body_b", "wall"))
    b = np.where(wall != NONE, NONE, b)
    own, other = number_of(state, body), number_of(state, partner, may_fail=True)
    walls = np.array([name == partner for name in wall_names(state)] + [False])
    if other is None and not walls.any():
        known = sorted({*body_names(state).values(), *wall_names(state)})
        raise InputError(
            f"there is no body, wall or obstacle '{partner}'; there are {', '.join(known)}"
        )
    if walls.any():
        found = (a == own) & (wall != NONE) & walls[np.where(wall == NONE, -1, wall)]
        return np.flatnonzero(found), np.ones(found.sum())
    first, second = (a == own) & (b == other), (a == other) & (b == own)
    rows = np.flatnonzero(first | second)
    return rows, np.where(first[rows], 1.0, -1.0)


def number_of(state, body, may_fail=False):
    """Of a body that is told by its name or its number."""
    names = body_names(state)
    for number, name in names.items():
        if body in (name, number):
            return number
    if may_fail:
        return None
    raise InputError(f"there is no body '{body}'; there are {', '.join(map(str, names.values()))}")
