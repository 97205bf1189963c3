# SPDX-License-Identifier: LGPL-2.1-or-later
"""What has become of the energy that is gone, by kind."""

import os
from typing import Dict

import numpy as np

from .curves import COLOURS
from .errors import InputError
from .units import describe, scaled_unit, split_unit, with_unit

# Columns of history.csv by what they tell of the energy that is gone; what the laws of materials
# have taken is the rest.
KINDS = {
    "contact_loss_J_per_m": "contacts",
    "scheme_damping_J_per_m": "time scheme",
    "regularisation_work_J_per_m": "regularisation",
    "released_energy_J_per_m": "held steps",
}
REST = "materials"
NOTHING = 1e-4  # part of all dissipation below which a kind is not shown


def column_of(kind: str) -> str:
    return f"dissipated_by_{kind.replace(' ', '_')}_J_per_m"


def can_be_stacked(kinds: Dict[str, np.ndarray]) -> bool:
    """Whether no kind gives back what it took; what is below zero cannot lie on something."""
    most = max((np.nanmax(np.abs(values), initial=0) for values in kinds.values()), default=0)
    return all(np.nanmin(values, initial=0) >= -1e-3 * most for values in kinds.values())


def draw_dissipation(axes, run, x: str) -> None:
    """
    The kinds of dissipation over a column, one on the other; as lines where one of them gives
    energy back.
    """
    kinds = dissipation_of(run)
    if not kinds:
        raise InputError(f"nothing is dissipated in {run.directory}")
    (places, _), table = run.column(x), run.history_table
    if len(places) != len(table):
        raise InputError(f"--x {x}: a column of history.csv is needed to draw dissipation")
    divisor, unit = scaled_unit(
        "J/m", max(np.nanmax(np.abs(table["dissipated_energy_J_per_m"]), initial=0), NOTHING**4)
    )
    x_divisor, x_unit = scaled_unit(split_unit(x)[1], np.nanmax(np.abs(places), initial=0))
    values = [kind / divisor for kind in kinds.values()]
    if can_be_stacked(kinds):
        axes.stackplot(
            places / x_divisor,
            *np.maximum(values, 0),
            labels=list(kinds),
            colors=COLOURS,
            alpha=0.75,
        )
    else:
        for number, (kind, one) in enumerate(zip(kinds, values)):
            axes.plot(places / x_divisor, one, color=COLOURS[number], label=kind)
    axes.plot(
        places / x_divisor,
        table["dissipated_energy_J_per_m"] / divisor,
        color="#1a1a1a",
        linewidth=1.2,
        label="all",
    )
    axes.set(
        xlabel=with_unit(describe(x), x_unit),
        ylabel=with_unit(describe("dissipated_energy_J_per_m"), unit),
    )
    axes.margins(x=0)
    axes.legend(
        *(list(reversed(one)) for one in axes.get_legend_handles_labels()),
        frameon=False,
        loc="upper left",
    )


def dissipation_of(run) -> Dict[str, np.ndarray]:
    """
    What has become of the energy that is gone, by kind [J/m]: in every row of history.csv the sum
    of all is the dissipated energy. Kinds that are nothing are left out.

    >>> kinds = dissipation_of(example)
    >>> dissipated = example.history_table["dissipated_energy_J_per_m"]
    >>> bool(np.allclose(sum(kinds.values()), dissipated, atol=1e-7))
    True
    """
    if (
        not os.path.exists(run.path("history.csv"))
        or "dissipated_energy_J_per_m" not in run.history_table
    ):
        raise InputError(f"{run.directory}/history.csv has no dissipated energy")
    table = run.history_table
    whole = table["dissipated_energy_J_per_m"]
    found = {text: table[name] for name, text in KINDS.items() if name in table}
    found = {REST if found else "all": whole - sum(found.values()), **found}
    most = max(np.nanmax(np.abs(values), initial=0) for values in found.values())
    return {
        text: values
        for text, values in found.items()
        if np.nanmax(np.abs(values), initial=0) > NOTHING * most
    }
