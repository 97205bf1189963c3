# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What says best how far a scene has come: packing fraction or strain, where it has one of them,
beside the time.
"""

from typing import Optional

import numpy as np

from .curves import moves
from .errors import InputError

SIGNS = {
    "packing_fraction": r"$\Phi$",
    "axial_strain": r"$\varepsilon$",
    "shear_strain": r"$\varepsilon_\mathrm{q}$",
}
STOPS = {
    "Packing fraction": "packing_fraction",
    "Shear strain": "shear_strain",
    "Axial strain": "axial_strain",
}
MANY = 10  # bodies from which a full box is known by its packing fraction


def coordinate_of(run) -> Optional[str]:
    """
    The column that a scene itself goes by, None where there is only the time: what ends it, or its
    last stage; else, of many bodies in a box that gets fuller the packing fraction, and the strain
    where it changes.

    >>> coordinate_of(example)
    'axial_strain'
    """
    parameters = run.parameters
    stages = parameters.names("Stages")
    for prefix in ([f"Stages/{stages[-1]}/Stop"] if stages else []) + ["Stop"]:
        for name, column in STOPS.items():
            value = parameters.get(f"{prefix}/{name}", 0)
            if isinstance(value, (int, float)) and value > 0 and changes(run, column):
                return column
    if bodies_of(run) >= MANY and changes(run, "packing_fraction"):
        return "packing_fraction"
    return "axial_strain" if changes(run, "axial_strain") else None


def bodies_of(run) -> int:
    """How many bodies there are; 0 where summary.json does not say."""
    try:
        found = (run.summary or {}).get("bodies", 0)
    except InputError:
        return 0
    return found if isinstance(found, int) else 0


def changes(run, column: str) -> bool:
    """Whether a run has the column, with values that differ."""
    try:
        values, _ = run.column(column)
    except InputError:
        return False
    known = values[np.isfinite(values)]
    return len(known) > 1 and moves(values) and bool(np.ptp(known) > 0)


def coordinate_at(run, time: float) -> str:
    """The coordinate of a scene at a time, as text for a title; '' without one."""
    column = coordinate_of(run)
    value = run.value_at(column, time) if column else None
    return f"{SIGNS[column]} = {value:.3f}" if column and value is not None else ""
