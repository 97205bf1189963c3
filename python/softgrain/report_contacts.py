# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts of the last state of runs, on a page."""

import numpy as np

from .contacts import NONE
from .errors import InputError
from .measures import coordination
from .page import escape
from .report_entry import heads, with_prefix

FEW_PAIRS = 30  # of which no distribution can be told


def add_contacts(page, entries, problems):
    found = []
    for entry in entries:
        try:
            state = last_with_contacts(entry.run)
            if state is not None:
                found.append((entry, state, state.pairs))
        except (InputError, OSError) as error:
            problems.append((entry.colour, entry.label, str(error)))
    if not found:
        return
    section = page.section("Contacts")
    numbers = [numbers_of_contacts(state, pairs) for _, state, pairs in found]
    names = list(dict.fromkeys(name for one in numbers for name in one))
    section.table(
        heads([entry for entry, *_ in found], "Of the last state"),
        [(name, [one.get(name, "") for one in numbers], "") for name in names],
    )
    inner = [(entry, *between_bodies(pairs)) for entry, _, pairs in found]
    inner = [
        (entry, normal, force)
        for entry, normal, force in inner
        if len(force) >= FEW_PAIRS and force.mean() > 0
    ]
    if inner:
        section.traces(
            "How strong contacts are",
            [distribution(*one) for one in inner],
            {
                "xaxis": {
                    "title": {"text": "normal force over its mean, f / ⟨f⟩"},
                    "hoverformat": ".3g",
                },
                "yaxis": {"title": {"text": "probability density"}, "type": "log"},
                "hovermode": "closest",
            },
        )
        n = 9 if min(len(force) for *_, force in inner) < 300 else 18
        roses = [rose(entry, normal, n) for entry, normal, _ in inner if normal.shape[1] == 2]
        if not roses:
            return
        reach = 1.05 * max(np.abs(one[axis]).max() for one in roses for axis in "xy")
        section.traces(
            "Where contacts point",
            roses,
            {
                "xaxis": {
                    "title": {"text": f"share of contacts within {180 // n}°"},
                    "range": [-reach, reach],
                    "constrain": "domain",
                },
                "yaxis": {"range": [-reach, reach], "scaleanchor": "x", "constrain": "domain"},
                "hovermode": "closest",
            },
        )


def last_with_contacts(run):
    """
    The last state, from the snapshots or from the fields, that has contacts; None without one.
    """
    for states in (run.snapshots, run.fields):
        if len(states) and states[-1].has("contacts"):
            return states[-1]
    return None


def between_bodies(pairs):
    """Normals and normal forces of contacts between bodies that press."""
    force = pairs["normal_force"]  # per metre of thickness in the plane
    kept = (pairs["body_b"] != NONE) & (force > 0)
    return pairs["normal"][kept], force[kept]


def numbers_of_contacts(state, pairs):
    """Numbers of a state in words, {name: text}."""
    inner = pairs["body_b"] != NONE
    result = {
        "time": with_prefix(state.time, "s"),
        "contacts between bodies": f"{inner.sum():,}",
        "contacts with walls": f"{(~inner).sum():,}",
    }
    force, unit = pairs["normal_force"][inner], pairs.unit(pairs.resolve("normal_force"))
    if len(force):
        result["mean normal force"] = with_prefix(force.mean(), unit)
        result["largest normal force"] = with_prefix(force.max(), unit)
    if state.has("bodies"):
        found = coordination(state)
        result["contacts per body, walls too"] = f"{found['coordination']:.3g}"
        result["bodies with fewer than two contacts"] = f"{100 * found['rattler_fraction']:.3g} %"
    return result


def distribution(entry, _normal, force):
    """Probability density of the normal force over its mean."""
    ratio = force / force.mean()
    counts, edges = np.histogram(ratio, bins=min(24, max(8, len(ratio) // 12)), density=True)
    return {
        "type": "scatter",
        "mode": "lines+markers",
        "name": escape(entry.label),
        "x": 0.5 * (edges[1:] + edges[:-1]),
        "y": [value or None for value in counts],
        "line": {"color": entry.colour, "width": 2},
    }


def rose(entry, normal, n):
    """
    Share of contacts by direction, as a closed line around the middle; both ends of a contact
    count.
    """
    angle = np.arctan2(normal[:, 1], normal[:, 0]) % np.pi
    share = np.histogram(angle, bins=n, range=(0, np.pi))[0] / len(angle)
    share = np.concatenate([share, share])
    edges = np.linspace(0, 2 * np.pi, len(share) + 1)
    radius, way = np.repeat(share, 2), np.stack([edges[:-1], edges[1:]], axis=1).ravel()
    x, y = radius * np.cos(way), radius * np.sin(way)
    return {
        "type": "scatter",
        "mode": "lines",
        "name": escape(entry.label),
        "x": np.append(x, x[0]),
        "y": np.append(y, y[0]),
        "line": {"color": entry.colour, "width": 2},
        "hoverinfo": "skip",
    }
