# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What bodies feel from each other, from walls and from obstacles: forces and torques, by partner.
"""

import numpy as np

from .contacts import NONE
from .errors import InputError
from .tables import Table


def loads_of(state) -> Table:
    """
    One row for each body and each of its partners, another body or a wall: the force that the body
    feels, and its torque about the centre of mass, counter-clockwise. Of two bodies there are two
    rows, with opposite forces.
    """
    contacts, bodies = state.contacts, state.bodies
    a, b, wall = (contacts[name].astype(int) for name in ("body_a", "body_b", "wall"))
    b = np.where(wall != NONE, NONE, b)
    shift = contacts["image_m"] if "image_m" in contacts else np.zeros((len(a), 2))
    both = (b != NONE) & (a != b)
    outside = (wall != NONE) | both
    # Body a feels the force; where it has a body as partner, that one feels the opposite, of a cell
    # in the place of its own image.
    own = np.concatenate([a[outside], b[both]])
    partner = np.concatenate([b[outside], a[both]])
    walls = np.concatenate([wall[outside], np.full(both.sum(), NONE)])
    force = np.concatenate([contacts["force_N_per_m"][outside], -contacts["force_N_per_m"][both]])
    place = np.concatenate([contacts["place_m"][outside], contacts["place_m"][both] - shift[both]])
    rows = np.empty(int(bodies["body"].max(initial=-1)) + 1, dtype=int)
    rows[bodies["body"]] = np.arange(len(bodies))
    arm = place - bodies["center_m"][rows[own]]
    torque = arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]
    keys, which = np.unique(np.stack([own, partner, walls], axis=1), axis=0, return_inverse=True)
    which = which.ravel()

    def total(values):
        return np.bincount(which, values, minlength=len(keys))

    return Table(
        {
            "body": keys[:, 0],
            "partner": keys[:, 1],
            "wall": keys[:, 2],
            "partner_name": names_of(state, keys[:, 1], keys[:, 2]),
            "force_N_per_m": np.stack([total(force[:, 0]), total(force[:, 1])], axis=1),
            "torque_N": total(torque),
        },
        "loads",
    )


def body_names(state):
    """
    Of all bodies by their numbers. Pictures have no names: those of the scene come first, then
    those of its packing; a body that has none of them has its number.
    """
    numbers = state.bodies["body"].astype(int).tolist()
    if "name" in state.bodies:
        return dict(zip(numbers, state.bodies["name"].tolist()))
    parameters = getattr(getattr(state, "run", None), "parameters", None)
    own = parameters.names("Bodies") if parameters is not None else []
    packed = parameters is not None and len(numbers) > len(own) and "Packing/Number" in parameters
    return {
        n: own[n] if n < len(own) else f"grain_{n - len(own) + 1}" if packed else str(n)
        for n in numbers
    }


def wall_names(state):
    """Of walls and, behind them, obstacles."""
    return [*state.run.parameters.names("Walls"), *state.run.parameters.names("Obstacles")]


def names_of(state, partner, wall):
    """Names of partners; a body without a name has its number."""
    bodies, walls = body_names(state), wall_names(state)
    return np.array(
        [
            (walls[w] if w < len(walls) else f"wall {w}") if w != NONE else bodies.get(p, str(p))
            for p, w in zip(partner.tolist(), wall.tolist())
        ],
        dtype=str,
    )


def resultants(bodies, loads, name):
    """The sum of the loads of each body."""
    values = loads[name]
    columns = values.T if values.ndim == 2 else [values]
    most = int(max(bodies.max(initial=-1), loads["body"].max(initial=-1))) + 1
    found = [np.bincount(loads["body"], column, minlength=most)[bodies] for column in columns]
    return np.stack(found, axis=1) if values.ndim == 2 else found[0]


def loads_on(run, body) -> Table:
    """What a body, by its number or name, feels in all states: a row for each time and partner."""
    parts = []
    for state in run:
        number = body
        if isinstance(body, str):
            names = state.bodies["name"].tolist() if "name" in state.bodies else []
            if body not in names:
                raise InputError(
                    f"there is no body '{body}' in {run.directory}"
                    + (
                        f"; there are {', '.join(names[:20])}"
                        if names
                        else ": say its number, snapshots have names"
                    )
                )
            number = int(state.bodies["body"][names.index(body)])
        loads = state.loads
        own = loads.where(loads["body"] == number)
        parts.append({"time_s": np.full(len(own), state.time), **dict(own.items())})
        state.forget()
    if not parts:
        raise InputError(f"{run.directory} has no states")
    return Table(
        {name: np.concatenate([part[name] for part in parts]) for name in parts[0]},
        f"loads on {body}",
    )
