# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A grain between two walls as section 3.4 of Nguyen (2016) sees it: stress against strain, and its
constants.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .. import InputError, fits
from .. import open as open_run

LOADING_MEAN = 0.005  # strain over which the moving mean of loading goes
UNLOADING_MEAN = 0.0005  # unloading is over within a strain of 0.01
PLATEAU = (0.10, 0.30)
SHORTEST_PLATEAU = 0.05
BEND = 0.1  # relative distance from the stiffest secant at which the curve is no longer linear
STIFFEST_WITHIN = 0.05  # strain up to which the stiffest secant is looked for
FALL = (0.8, 0.2)  # of the stress at reversal, for the slope of unloading
NOTHING = 0.01  # of the stress at reversal: counts as zero stress


def running_mean(x, y, width, places):
    """
    Means of the broken line y(x), x growing, over @width around the places; over less at the ends.
    """
    low, high = np.maximum(places - 0.5 * width, x[0]), np.minimum(places + 0.5 * width, x[-1])
    area = np.concatenate([[0], np.cumsum(0.5 * (y[1:] + y[:-1]) * np.diff(x))])

    def integral(end):
        i = np.clip(np.searchsorted(x, end, side="right") - 1, 0, len(x) - 2)
        step = end - x[i]
        slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i])
        return area[i] + y[i] * step + 0.5 * slope * step**2

    return (integral(high) - integral(low)) / (high - low)


def mean_between(strain, stress, low, high):
    """Mean of the stress over the strain; None when less than SHORTEST_PLATEAU of it is there."""
    high = min(high, strain[-1])
    if high - low < SHORTEST_PLATEAU or strain[0] > low:
        return None
    return float(running_mean(strain, stress, high - low, np.array([0.5 * (low + high)]))[0])


def characteristic_force(parameters):
    """F0 of p_I in the law that the material names, or None."""
    for name in ("Characteristic force", "Force at contact"):
        number = parameters.find_number(name, "Materials")
        if number is not None:
            return number
    return None


def growing(strain, stress):
    """
    The part of the rows at which the strain exceeds all before, so that stress is a function of it.
    """
    before = np.concatenate([[-np.inf], np.maximum.accumulate(strain)[:-1]])
    kept = strain > before
    return strain[kept], stress[kept]


@dataclass
class Run:
    """
    One run; loading and unloading are rows (strain, stress) of history.csv from first contact on.
    """

    directory: str
    model: str
    force: float | None = None  # F0 [N/m]
    diameters: tuple | None = None  # smallest and largest [m]
    mean_diameter: float | None = None
    loading: tuple = ()
    unloading: tuple | None = (
        None  # strain from that of reversal down; None when the walls only close
    )
    smooth: tuple = ()
    smooth_unloading: tuple = ()
    constants: dict = field(default_factory=dict)
    quality: dict = field(default_factory=dict)  # R² of the fits that the constants are from

    @property
    def key(self):
        return self.model, self.force, self.diameters

    @property
    def smallest(self):
        """Diameter of the smallest primary, 0 where it is not known."""
        return self.diameters[0] if self.diameters else 0.0

    @property
    def characteristic_stress(self):
        """p_I of Nguyen (2016), (3.32)."""
        return self.force / self.mean_diameter if self.force and self.mean_diameter else None

    @property
    def label(self):
        if self.model == "mpm":
            return "MPM"
        parts = ["BPM"]
        if self.diameters:
            parts.append(
                f"{1e3 * self.diameters[0]:.2f}-{1e3 * self.diameters[1]:.2f} mm".replace(
                    "-", "\u2013"
                )
            )
        if self.force:
            parts.append(f"$F_0$ = {self.force:g} N/m")
        return ", ".join(parts)


def mean_diameter_of(output):
    """Mean diameter of the primaries of the first picture, None without pictures."""
    if output.source is None:
        return None
    states = output if output.source == "fields" else output.fields
    try:
        first = next(state for state in states if state.has("points"))
    except (InputError, StopIteration):
        return None
    radius = first.points.get("radius_m")
    return float(2 * np.mean(radius)) if radius is not None and len(radius) else None


def read_run(directory):
    output = open_run(directory)
    history, parameters = output.history_table, output.parameters
    for name in (
        "time_s",
        "bottom_position_m",
        "top_position_m",
        "bottom_force_N_per_m",
        "top_force_N_per_m",
    ):
        if name not in history:
            raise InputError(
                f"{directory} is no grain between the walls bottom and top: its history.csv has no"
                f" column {name}"
            )
    bottom, top = history["bottom_force_N_per_m"], history["top_force_N_per_m"]
    pressed = (np.cumsum(bottom > 0) > 0) & (np.cumsum(top > 0) > 0)
    if pressed.sum() < 10:
        raise InputError(f"{directory} has too few steps in which both walls touch the grain")
    # The walls came to touch the grain after the last row in which they did not.
    first = max(int(np.argmax(pressed)) - 1, 0)
    height = history["top_position_m"] - history["bottom_position_m"]
    strain = np.log(height[first] / height)[first:]
    stress = (0.5 * (bottom + top) / output.widths(history["time_s"]))[first:]
    if not (np.isfinite(strain).all() and np.isfinite(stress).all()):
        raise InputError(
            f"{directory}/history.csv has rows without positions or forces of the walls"
        )
    run = Run(directory, output.model)
    if run.model != "mpm":
        run.force = characteristic_force(parameters)
        ends = [
            parameters.find_number(f"{which} diameter", "Primaries")
            for which in ("Smallest", "Largest")
        ]
        run.diameters = None if None in ends else tuple(ends)
        run.mean_diameter = mean_diameter_of(output)
    turn = int(np.argmax(strain))
    run.loading = growing(strain[: turn + 1], stress[: turn + 1])
    if strain[turn] - strain[-1] > 2 * UNLOADING_MEAN:
        back, value = growing(-strain[turn:], stress[turn:])
        run.unloading = -back, value
    smoothen(run)
    run.constants = constants_of(run)
    return run


def smoothen(run):
    strain, stress = run.loading
    places = np.arange(0, strain[-1], 0.1 * LOADING_MEAN)
    run.smooth = places, running_mean(strain, stress, LOADING_MEAN, places)
    if run.unloading:
        strain, stress = run.unloading
        places = -np.arange(-strain[0], -strain[-1], 0.1 * UNLOADING_MEAN)
        run.smooth_unloading = places, running_mean(-strain, stress, UNLOADING_MEAN, -places)


def linear_part(strain, stress):
    """
    (slope of the stiffest secant through the origin, strain beyond which the curve first is BEND
    away from it).
    """
    searched = (strain >= LOADING_MEAN) & (strain <= STIFFEST_WITHIN)
    if searched.sum() < 3 or strain[-1] < STIFFEST_WITHIN:
        return None, None
    secant = stress[searched] / strain[searched]
    stiffest = float(secant.max())
    if not stiffest > 0:
        return None, None
    start = np.flatnonzero(searched)[int(np.argmax(secant))]
    away = np.abs(stress[start:] / (stiffest * strain[start:]) - 1)
    beyond = np.flatnonzero(away > BEND)
    if not len(beyond):
        return stiffest, None
    i = beyond[0]
    part = (BEND - away[i - 1]) / (away[i] - away[i - 1])
    return stiffest, float(
        strain[start + i - 1] + part * (strain[start + i] - strain[start + i - 1])
    )


def first_below(strain, stress, level):
    """The strain at which the stress first is below a level, None when it never is."""
    below = np.flatnonzero(stress < level)
    if not len(below):
        return None
    i = below[0]
    if i == 0:
        return float(strain[0])
    part = (stress[i - 1] - level) / (stress[i - 1] - stress[i])
    return float(strain[i - 1] + part * (strain[i] - strain[i - 1]))


CONSTANTS = {  # text for the table
    "plateau_Pa": "plateau: mean σ over 0.10 < ε < 0.30 [Pa]",
    "characteristic_stress_Pa": "p_I = F0/<a0> [Pa]",
    "plateau_over_characteristic": "plateau / p_I",
    "initial_slope_Pa": "stiffest secant [Pa]",
    "linear_until_strain": "ε where σ leaves it by 10 %",
    "reversal_strain": "ε at reversal",
    "reversal_stress_Pa": "σ at reversal [Pa]",
    "unloading_slope_Pa": "unloading slope E' [Pa]",
    "unloading_slope_over_plateau": "E' / plateau",
    "recovered_strain": "ε recovered at σ = 0",
}


def constants_of(run):
    """Every name of CONSTANTS with its number, None where the run does not give it."""
    result: dict[str, Any] = dict.fromkeys(CONSTANTS)
    if run.model != "mpm":
        loaded, carried = run.loading
        result["plateau_Pa"] = mean_between(loaded, carried, *PLATEAU)
        result["characteristic_stress_Pa"] = run.characteristic_stress
        if result["plateau_Pa"] and run.characteristic_stress:
            result["plateau_over_characteristic"] = result["plateau_Pa"] / run.characteristic_stress
    result["initial_slope_Pa"], result["linear_until_strain"] = linear_part(*run.smooth)
    if run.unloading:
        strain, stress = run.smooth_unloading
        result["reversal_strain"] = float(run.loading[0][-1])
        # The moving mean of loading at its end, of the last half of its width.
        reversal = float(
            running_mean(run.loading[0], run.loading[1], LOADING_MEAN, run.loading[0][-1:])[0]
        )
        result["reversal_stress_Pa"] = reversal
        begin, end = (first_below(strain, stress, part * reversal) for part in FALL)
        if begin is not None and end is not None:
            fitted = (run.unloading[0] <= begin) & (run.unloading[0] >= end)
            if fitted.sum() >= 3:
                line = np.polyfit(run.unloading[0][fitted], run.unloading[1][fitted], 1)
                result["unloading_slope_Pa"] = float(line[0])
                # Rows of primaries are noisy; whether they follow a line is seen at their moving
                # mean.
                near = (strain <= begin) & (strain >= end)
                left = stress[near] - np.polyval(line, strain[near])
                run.quality["unloading_slope_Pa"] = fits.quality(
                    stress[near], np.sqrt(np.mean(left**2))
                )
        if (free := first_below(strain, stress, NOTHING * reversal)) is not None:
            result["recovered_strain"] = result["reversal_strain"] - free
    return result


def compare_slopes(runs):
    """
    Unloading slope over plateau, that of the run itself or of one with the same grain that has one.
    """
    for run in runs:
        slope = run.constants["unloading_slope_Pa"]
        plateaus = [other.constants["plateau_Pa"] for other in [run, *runs] if other.key == run.key]
        plateau = next((value for value in plateaus if value), None)
        if slope is not None and plateau:
            run.constants["unloading_slope_over_plateau"] = slope / plateau
