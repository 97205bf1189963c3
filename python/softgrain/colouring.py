# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which numbers a picture shows in colour, and by which scale."""

from dataclasses import dataclass

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap, Normalize

from .drawing import colour_range, is_signed
from .errors import InputError, MissingName, near_names
from .units import describe, scaled_unit, split_unit, with_unit

ALIASES = {"strain": "equivalent_strain", "speed": "velocity_m_per_s"}
ALONG_CONTACTS = ("contact_pressure", "contact_traction")
COMPONENTS = {2: ("x", "y"), 3: ("xx", "yy", "xy"), 4: ("xx", "xy", "yx", "yy")}


@dataclass
class Field:
    """
    A field by its name on the command line: 'points' or 'bodies', the full name of the column, the
    component.
    """

    part: str
    name: str
    component: str = ""

    def values(self, state):
        """Numbers of one state, one per point or body."""
        table = getattr(state, self.part)
        values = table[self.name]
        if values.ndim == 1:
            if self.component:
                raise InputError(f"the field '{self.name}' has no components")
            return values.astype(float)
        if not self.component:
            return np.linalg.norm(values, axis=1)
        names = table.COMPONENTS[values.shape[1]]
        if self.component not in names:
            raise InputError(
                f"'{self.component}' is no component of '{self.name}': it has {', '.join(names)}"
            )
        return values[:, names.index(self.component)]

    @property
    def label(self):
        base = split_unit(self.name)[0]
        return (
            describe(self.name)
            if not self.component
            else f"{base.replace('_', ' ')}, {self.component}"
        )


def columns_of(state, part):
    return (
        [n for n in getattr(state, part) if n not in ("body", "name", "position_m", "center_m")]
        if state.has(part)
        else []
    )


def find_field(state, text):
    """
    The field of the points or, if they have none of this name, of the bodies; 'bodies/NAME' asks
    for the latter.
    """
    base, _, component = text.partition(":")
    base = ALIASES.get(base, base)
    parts = ["points", "bodies"]
    if base.startswith("bodies/"):
        parts, base = ["bodies"], base[len("bodies/") :]
    if split_unit(base)[0] in ALONG_CONTACTS:
        if not state.has("contacts"):
            raise InputError(f"frame {state.number} has no contacts: '{base}' is drawn along them")
        return Field("contact_pressures", split_unit(base)[0] + "_Pa")
    for part in parts:
        if state.has(part) and (full := getattr(state, part).resolve(base)):
            return Field(part, full, component)
    reason = ""
    if not state.has("points"):
        reason = (
            f"frame {state.number} has no points to colour: run with points in its pictures, or use"
            " --field none; "
        )
    elif base.endswith("_strain"):
        reason = "strains need the deformation gradient, which material points have; "
    known = [name for part in parts for name in columns_of(state, part)]
    if near := near_names(base, [*known, *ALIASES, *ALONG_CONTACTS]):
        raise MissingName(
            f"{reason}there is no field '{base}' in {state.source.path(parts[0])}; did you mean"
            f" {near}?"
        )
    raise MissingName(
        f"{reason}there is no field '{base}' in {state.source.path(parts[0])}; there are "
        + ", ".join(sorted(columns_of(state, "points")))
        + "; of whole bodies: "
        + ", ".join(sorted(columns_of(state, "bodies")))
        + "; along contacts: "
        + ", ".join(ALONG_CONTACTS)
    )


def colour_map(name):
    """matplotlib's colour map of this name."""
    try:
        return colormaps[name]
    except KeyError:
        raise InputError(f"--colours {name}: matplotlib has no such colour map") from None


class Scale:
    """One colour scale for all states, so that they can be compared and make a film."""

    def __init__(self, field, samples, limits=None, colours=None):
        self.field = field
        values = np.concatenate(samples) if samples else np.zeros(0)
        values = values[np.isfinite(values)]
        if len(values) == 0:
            raise InputError(f"the field '{field.name}' has no finite values")
        signed = is_signed(values)
        self.whole = field.name == "coordination" and limits is None
        self.limits = tuple(limits) if limits else colour_range(values, signed)
        if not self.limits[1] > self.limits[0]:
            raise InputError(
                f"--range {self.limits[0]:g} {self.limits[1]:g}: the second must be above the first"
            )
        self.divisor, self.unit = scaled_unit(
            split_unit(field.name)[1], max(abs(limit) for limit in self.limits)
        )
        self.map = colour_map(colours or ("coolwarm" if signed else "viridis"))
        self.norm = Normalize(self.limits[0] / self.divisor, self.limits[1] / self.divisor)
        # An arrow where values of any state are beyond the ends.
        low, high = values.min() < self.limits[0], values.max() > self.limits[1]
        self.beyond = "both" if low and high else "max" if high else "min" if low else "neither"
        if self.whole:  # one colour for each number of contacts
            low, high = int(values.min()), int(values.max())
            n = high - low + 1
            self.map = ListedColormap([self.map(0.5 if n == 1 else i / (n - 1)) for i in range(n)])
            self.norm = BoundaryNorm(np.arange(low - 0.5, high + 1), n)

    def values(self, state):
        return self.field.values(state) / self.divisor

    def draw_bar(self, figure, axes):
        """The colour bar."""
        if self.whole:
            whole = np.arange(np.ceil(self.norm.vmin), self.norm.vmax).astype(int)
            bar = figure.colorbar(ScalarMappable(self.norm, self.map), cax=axes, ticks=whole)
            bar.ax.minorticks_off()
            bar.ax.tick_params(length=0)
        else:
            bar = figure.colorbar(
                ScalarMappable(self.norm, self.map), cax=axes, extend=self.beyond, extendfrac=0.03
            )
        bar.set_label(with_unit(self.field.label, self.unit), labelpad=8)
        bar.outline.set_linewidth(0.8)
