# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a case is, what is known of its result, and how tables of cases are written."""
import dataclasses
import re

RIGHT, REFUSED, STOPPED = "right", "refused", "stopped"


@dataclasses.dataclass
class Case:
    name: str
    scene: str
    settings: tuple = ()
    expected: tuple = (RIGHT,)
    length: float = 1.  # cell or mean diameter, in which penetration is told [m]
    limits: dict = dataclasses.field(default_factory=dict)  # of energy, momentum, penetration, residual
    checks: dict = dataclasses.field(default_factory=dict)  # what is known: name and test of the rows of history.csv
    files: dict = dataclasses.field(default_factory=dict)
    quick: bool = False
    warning: str = ""  # what `check` says beforehand

LAW, OTHER = "Materials/gel/Neo-Hookean/", "Materials/other/Neo-Hookean/"


def less(scene, names, *sections):
    """A scene without some of its bodies or walls; @p names is what is left of the list of names."""
    for section in sections:
        scene = re.sub(rf"\n  subsection {section}\n.*?\n  end", "", scene, flags=re.DOTALL)
    return scene.replace(*names)


def cases_of(scene, length, prefix, table):
    """Cases from lines (name, settings) or (name, settings, more of Case)."""
    for name, settings, *more in table:
        yield Case(f"{prefix}: {name}", scene, tuple(settings), **{"length": length, **(more[0] if more else {})})


def last(name):
    return lambda rows: rows[-1][name]


def bounced(rows):
    """Kinetic energy is back after the collision, most of it."""
    return 0.7 < rows[-1]["kinetic_energy_J_per_m"] / rows[0]["kinetic_energy_J_per_m"] <= 1.001


def met(rows):
    """The bodies have been in contact."""
    return max(row["elastic_energy_J_per_m"] for row in rows) > 0.05 * rows[0]["kinetic_energy_J_per_m"]


def force_about(value, share=0.1):
    return lambda rows: abs(rows[-1]["top_force_N_per_m"] - value) < share * value


def carries(rows):
    return max(row["top_force_N_per_m"] for row in rows) > 0


HARD = {"energy": 0.2, "penetration": 0.2}
COLLISION = {"checks": {"they bounce": bounced, "they meet": met}}
LONG_STEP = {"limits": {"energy": 1.5, "penetration": 0.2}, "checks": {"they meet": met}}
ANY = (RIGHT, STOPPED, REFUSED)
