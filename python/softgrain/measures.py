# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Measures of a state in numpy, with the names and values of measures.csv (doc/measures.md): to try
another state, another choice of contacts, or a measure of one's own.
"""

from typing import List

import numpy as np

from .contacts import NONE


def packing(state):
    """packing_fraction and void_ratio; nothing without the four walls of a box."""
    box = state.box()
    if box is None:
        return {}
    fraction = float(state.bodies["area_m2"].sum() / (box[0] * box[1]))
    return {"packing_fraction": fraction, "void_ratio": 1 / fraction - 1}


def coordination(state):
    """
    Contacts per body: with walls, of bodies alone, without rattlers; and the share of rattlers.
    """
    pairs, bodies = state.pairs, state.bodies["body"]
    n, with_wall = len(bodies), pairs["body_b"] == NONE
    degree = state.bodies["coordination"].copy()
    neighbours: List[List[int]] = [[] for _ in range(n)]
    for a, b in zip(pairs["body_a"][~with_wall], pairs["body_b"][~with_wall]):
        neighbours[a].append(b)
        neighbours[b].append(a)
    rattles = degree < 2
    open_ = list(np.flatnonzero(rattles))
    while open_:  # who hangs on rattlers only is one, too
        for other in neighbours[open_.pop()]:
            if not rattles[other]:
                degree[other] -= 1
                if degree[other] < 2:
                    rattles[other] = True
                    open_.append(other)
    kept = degree[~rattles]
    return {
        "coordination": float(state.bodies["coordination"].mean()),
        "coordination_of_bodies": 2 * float((~with_wall).sum()) / n,
        "coordination_without_rattlers": float(kept.mean()) if len(kept) else 0.0,
        "rattler_fraction": float(rattles.mean()),
    }


def difference(tensor):
    """Difference of the eigenvalues of a symmetric tensor."""
    return float(np.hypot(tensor[0, 0] - tensor[1, 1], 2 * tensor[0, 1]))


def fabric(state):
    """Fabric tensor of contacts between bodies, anisotropy of contacts and of normal forces."""
    pairs = state.pairs
    inner = pairs["body_b"] != NONE
    normal, force = pairs["normal"][inner], pairs["normal_force_N_per_m"][inner]
    if not len(normal):
        return {}
    dyads = normal[:, :, None] * normal[:, None, :]
    tensor = dyads.mean(axis=0)
    contact = 2 * difference(tensor)
    result = {
        "fabric_xx": tensor[0, 0],
        "fabric_yy": tensor[1, 1],
        "fabric_xy": tensor[0, 1],
        "contact_anisotropy": contact,
        "contact_direction_rad": 0.5 * np.arctan2(2 * tensor[0, 1], tensor[0, 0] - tensor[1, 1]),
    }
    if force.sum() > 0:
        weighted = (force[:, None, None] * dyads).sum(axis=0) / force.sum()
        result["normal_force_anisotropy"] = 2 * difference(weighted) - contact
        result["half_sum_of_anisotropies"] = 0.5 * (contact + result["normal_force_anisotropy"])
    return {name: float(value) for name, value in result.items()}


def stress(state):
    """
    Stress of the box from the internal moments of its bodies, tension positive; p, q and the
    pressure on the walls.
    """
    box = state.box()
    if box is None:
        return {}
    rows, center = state.contacts, state.bodies["center_m"]
    kept = rows["body_a"] != rows["body_b"]
    a, b, wall = (rows[name][kept] for name in ("body_a", "body_b", "wall"))
    force, place = rows["force_N_per_m"][kept], rows["place_m"][kept]
    moment = np.einsum("ki,kj->ij", force, place - center[a])
    pair = wall == NONE
    moment -= np.einsum("ki,kj->ij", force[pair], place[pair] - center[b[pair]])
    tensor = 0.5 * (moment + moment.T) / (box[0] * box[1])
    p, q = -0.5 * np.trace(tensor), 0.5 * difference(tensor)
    result = {
        "stress_xx_Pa": tensor[0, 0],
        "stress_yy_Pa": tensor[1, 1],
        "stress_xy_Pa": tensor[0, 1],
        "mean_pressure_Pa": p,
        "deviator_Pa": q,
    }
    if p > 0:
        result["stress_ratio"] = q / p
    for name, normal_force in zip(state.walls["name"], state.walls["normal_force_N_per_m"]):
        if name in ("bottom", "top", "left", "right"):
            result[f"{name}_pressure_Pa"] = (
                normal_force / box[0 if name in ("bottom", "top") else 1]
            )
    return {name: float(value) for name, value in result.items()}


def forces(state):
    """Mean and largest normal force between bodies."""
    normal = state.pairs["normal_force_N_per_m"][state.pairs["body_b"] != NONE]
    if not len(normal):
        return {}
    return {
        "mean_normal_force_N_per_m": float(normal.mean()),
        "largest_normal_force_N_per_m": float(normal.max()),
    }


def of(state):
    """
    All of them, {name: number}.

    >>> of(example[-1])["coordination"]
    2.0
    """
    result = {**coordination(state), **fabric(state), **forces(state)}
    return {**packing(state), **result, **stress(state)}
