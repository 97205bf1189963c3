# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A path of stages as chapter 5 of Nguyen (2016) sees it: isotropic compaction, biaxial compression,
unloading.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .. import InputError
from .. import Run as Output
from .. import open as open_run
from .one_grain import characteristic_force

FEWEST = 3  # pressures of a fit of (5.2)-(5.5): a line goes through any two
# The steady state: the last share of the shear strain, and the shear strain that it takes at least.
STEADY = (0.3, 0.4)
# Name: (text, value in the thesis); of a group of runs that differ in pressure.
CONSTANTS = {
    "packing_at_stiffness": ("Φ(p_I) (5.2)", 0.93),
    "packing_slope": ("k (5.2)", 0.13),
    "void_ratio_at_stiffness": ("e(p_I) (5.3)", 0.08),
    "void_ratio_slope": ("C_e (5.3)", 0.15),
    "coordination_at_stiffness": ("Z(p_I) (5.4)", 4.8),
    "coordination_slope": ("C_Z (5.4)", 1.1),
    "slope_of_5_5": ("-dZ/de (5.5)", 1.1 / 0.15),
}
MEASURED = (
    "packing_fraction",
    "void_ratio",
    "coordination_of_bodies",
    "shear_strain",
    "volume_strain",
    "wall_pressure_Pa",
    "wall_deviator_Pa",
    "wall_stress_ratio",
)


@dataclass
class Path:
    """A run in stages: what measures.csv says of each of its parts."""

    output: Output
    model: str
    friction: float
    grains: int | None  # None where the run does not say
    # p_c: that the wall on the right is to keep, or has at the end of the isotropic stage [Pa]
    pressure: float
    stiffness: float  # p_I = F0/<a0>, or E [Pa]
    isotropic: dict = field(default_factory=dict)  # the state at the end of the isotropic stage
    shear: dict = field(
        default_factory=dict
    )  # columns while the upper wall goes down; strains from its beginning
    unloading: dict = field(default_factory=dict)  # the same while it goes up again

    @property
    def kappa(self):
        """p_c / stiffness."""
        return self.pressure / self.stiffness

    @property
    def group(self):
        grains = f", {self.grains} grains" if self.grains else ""
        return (
            self.model.upper() + grains + (f", μ = {self.friction:g}" if self.friction > 0 else "")
        )

    def steady(self, name):
        """
        (mean, standard deviation) of a column over the steady state; None when the shear ends
        before it.
        """
        strain, values = self.shear["shear_strain"], self.shear.get(name)
        if values is None or len(strain) < 4 or strain[-1] < STEADY[1]:
            return None
        kept = (strain >= (1 - STEADY[0]) * strain[-1]) & np.isfinite(values)
        return (
            (float(np.mean(values[kept])), float(np.std(values[kept]))) if kept.sum() > 1 else None
        )

    def peak(self):
        """Largest q/p over the steady one; None without a steady state."""
        steady = self.steady("wall_stress_ratio")
        return float(np.nanmax(self.shear["wall_stress_ratio"]) / steady[0]) if steady else None

    def anisotropies(self):
        """
        The prediction of q/p: (a_c + a_f)/2, with friction (a_c + a_f + a_t)/2; None when it was
        not measured.
        """
        name = "predicted_stress_ratio" if self.friction > 0 else "half_sum_of_anisotropies"
        return self.shear.get(name)


def stiffness_of(parameters):
    """
    F0/<a0> of bonded primaries by their law and size distribution, Young's modulus of material
    points [Pa].
    """
    if str(parameters.get("Model", "mpm")).lower() == "bpm":
        force = characteristic_force(parameters)
        small, large = (
            parameters[f"Primaries/{name} diameter"] for name in ("Smallest", "Largest")
        )
        if large <= small or not force:
            return force / small if force else None
        mean = {
            "uniform area": 2 / 3 * (large**3 - small**3) / (large**2 - small**2),
            "equal areas": np.log(large / small) * small * large / (large - small),
        }
        return force / mean.get(
            parameters.get("Primaries/Size distribution", "uniform area"), (small + large) / 2
        )
    values = [
        parameters[name]
        for name in parameters
        if name.startswith("Materials/") and name.endswith("Young's modulus")
    ]
    return max((value for value in values if isinstance(value, (int, float))), default=None)


def stages_of(output):
    """
    Names of the stages and their times [(name, begin, end)], as far as the run has come. Of a run
    that goes on from another folder the stage that ended there begins and ends where the history
    does.
    """
    names, history = output.parameters.names("Stages"), output.history_table
    if not names or "stage" not in history:
        raise InputError(f"{output.directory} has no stages: see doc/walls.md")
    number, times = history["stage"].astype(int), history["time_s"]
    ends = [
        times[number == k + 1][-1] if (number == k + 1).any() else None for k in range(len(names))
    ]
    begins = [times[0], *(times[0] if end is None else end for end in ends[:-1])]
    return [(name, begin, end) for name, begin, end in zip(names, begins, ends) if end is not None]


def is_driven(output, stage, wall, drives=("velocity", "position")):
    return str(output.parameters.get(f"Stages/{stage}/{wall}/Drive", "as before")) in drives


def pressure_of(output, stage):
    """
    The pressure on the wall on the right where it is a number: the force of a single step may be
    off by 10 % in BPM. Else None.
    """
    value = output.parameters.get(f"Stages/{stage}/right/Pressure")
    return (
        float(value)
        if isinstance(value, (int, float)) and is_driven(output, stage, "right", ("pressure",))
        else None
    )


def part_of(measures, begin, end, first):
    """
    Columns between two times; strains count from row @first, and @begin itself belongs to the part.
    """
    kept = (measures["time_s"] >= begin * (1 - 1e-9)) & (measures["time_s"] <= end * (1 + 1e-9))
    part = {name: values[kept] for name, values in measures.items()}
    for name in ("shear_strain", "volume_strain", "strain_1", "strain_2"):
        part[name] = part[name] - measures[name][first]
    return part


def read_path(directory):
    output = open_run(directory)
    stages, measures = stages_of(output), output.measures_table
    missing = [name for name in MEASURED if name not in measures]
    if missing:
        raise InputError(
            f"{directory}: measures.csv has no {missing[0]}; set Output/Measures = all, or run "
            f"'softgrain measure {directory}'"
        )
    # Walls may come to the grains at a velocity before they press.
    pressed = [
        k for k, (name, *_) in enumerate(stages) if is_driven(output, name, "top", ("pressure",))
    ]
    sheared = [
        k
        for k, (name, *_) in enumerate(stages)
        if k > min(pressed, default=-1) and is_driven(output, name, "top")
    ]
    last = sheared[0] - 1 if sheared else len(stages) - 1
    if last < 0:
        raise InputError(
            f"{directory} begins with a wall that is driven: there is no isotropic state before it"
        )
    stiffness = stiffness_of(output.parameters)
    if not stiffness:
        raise InputError(f"{directory}: its parameters do not say how stiff the material is")
    first = int(np.searchsorted(measures["time_s"], stages[last][2] * (1 - 1e-9)))
    first = min(first, len(measures["time_s"]) - 1)
    friction = output.parameters.get("Contact/Friction", 0.0)
    path = Path(
        output,
        output.model,
        friction if isinstance(friction, (int, float)) else 0.0,
        (output.summary or {}).get("bodies"),
        pressure_of(output, stages[last][0]) or float(measures["stress_2_Pa"][first]),
        stiffness,
    )
    path.isotropic = {name: float(values[first]) for name, values in measures.items()}
    if sheared:
        _, begin, end = stages[sheared[0]]
        path.shear = part_of(measures, begin, end, first)
    if len(sheared) > 1:
        path.unloading = part_of(measures, stages[sheared[1]][1], stages[sheared[-1]][2], first)
    return path


def groups_of(paths):
    """
    Runs of one model, friction and number of grains, BPM first as in the thesis, pressures rising:
    [[Path]].
    """
    groups: dict[Any, list[Path]] = {}
    for path in paths:
        groups.setdefault((path.model == "mpm", path.friction, path.grains or 0), []).append(path)
    return [sorted(groups[key], key=lambda path: path.pressure) for key in sorted(groups)]


def line(x, y):
    """(value at 0, slope, r.m.s.) of a straight line; None for fewer than two places."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) < 2 or np.ptp(x) == 0:
        return None
    slope, start = np.polyfit(x, y, 1)
    return float(start), float(slope), float(np.sqrt(np.mean((y - start - slope * x) ** 2)))


def pressures_of(group):
    """Those that differ by more than 5 % [Pa]."""
    found: list[float] = []
    for path in sorted(group, key=lambda path: path.pressure):
        if not found or path.pressure > 1.05 * found[-1]:
            found.append(path.pressure)
    return found


def not_fitted(group):
    """Why laws of pressure are not fitted to these runs; None where they are."""
    number = len(pressures_of(group))
    return (
        f"{number} pressure{'s' * (number > 1)}, and a fit needs {FEWEST}"
        if number < FEWEST
        else None
    )


def isotropic_line(group, name):
    """Of a measure of the isotropic state over log10(p_c/p_I); None for too few pressures."""
    return (
        None
        if not_fitted(group)
        else line(
            [np.log10(path.kappa) for path in group], [path.isotropic[name] for path in group]
        )
    )


def void_line(group):
    """Of Z over the void ratio, isotropic (5.5); None for too few pressures."""
    return (
        None
        if not_fitted(group)
        else line(
            [path.isotropic["void_ratio"] for path in group],
            [path.isotropic["coordination_of_bodies"] for path in group],
        )
    )


def constants_of(group):
    """Every name of CONSTANTS with its number, None where the runs do not give it."""
    result: dict[str, Any] = dict.fromkeys(CONSTANTS)
    for name, column, sign in (
        ("packing", "packing_fraction", 1),
        ("void_ratio", "void_ratio", -1),
        ("coordination", "coordination_of_bodies", 1),
    ):
        if found := isotropic_line(group, column):
            result[f"{name}_at_stiffness"], result[f"{name}_slope"] = found[0], sign * found[1]
    if found := void_line(group):
        result["slope_of_5_5"] = -found[1]
    return result


def states_at(path, strains):
    """
    Indices of the snapshots next to these shear strains, and the strains they have: [(index,
    strain)].
    """
    if not os.path.exists(path.output.path("snapshots.h5")) or not path.shear:
        return []
    times = path.output.snapshots.times
    strain = np.interp(
        times, path.shear["time_s"], path.shear["shear_strain"], left=np.nan, right=np.nan
    )
    chosen: list[tuple[int, float]] = []
    for wanted in strains:
        if np.isfinite(strain).any() and np.nanmin(np.abs(strain - wanted)) < 0.05:
            index = int(np.nanargmin(np.abs(strain - wanted)))
            if index not in [c[0] for c in chosen]:
                chosen.append((index, float(strain[index])))
    return chosen
