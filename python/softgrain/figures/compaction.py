# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A compaction run as chapter 4 of Nguyen (2016) sees it: its curves against a reference state, its
constants.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .. import InputError, fits
from .. import Run as Output
from .. import open as open_run

PACKINGS = (0.80, 0.85, 0.90, 0.95)  # of the force distributions
NEAR = 0.01  # states within this packing count as one
# packing up to which stress is fitted: above, pores are as small as those inside the particles
LIMIT = 0.98

# Name: (text, value in the thesis by MPM and by BPM; None: not given for this model)
CONSTANTS = {
    "initial_packing": ("Φ_init in Φ = Φ_init exp(ε)", 0.70, 0.70),
    "jamming_strain": ("ε where Z = 3", 0.08, 0.08),
    "jamming_packing": ("Φ where Z = 3", 0.75, 0.75),
    "reference_stress_Pa": ("σ0 at Φ0 [Pa]", None, None),
    "beta": ("β (4.3)", 10.0, None),
    "beta_rms": ("  r.m.s. in σ/σ0", None, None),
    "packing_slope": ("Φ0/β (4.5)", 0.08, None),
    "packing_slope_rms": ("  r.m.s. in Φ", None, None),
    "alpha": ("α (4.1)", None, 0.27),
    "alpha_rms": ("  r.m.s. in Φ", None, None),
    "coordination_at_reference": ("Z0", None, None),
    "coordination_exponent": ("exponent of Z", 0.5, 0.5),
    "coordination_when_full": ("Z1", 5.5, 5.5),
    "coordination_rms": ("  r.m.s. in Z", None, None),
    "force_gamma": ("γ (2.32) at Φ = 0.80", 0.15, 0.25),
    "first_regime_ends": ("regime 1 to 2 at Φ", 0.78, 0.78),
    "second_regime_ends": ("regime 2 to 3 at Φ", 0.95, 0.95),
}


@dataclass
class Run:
    """Curves of one run while the walls close: in steps (history) and at snapshots (measures)."""

    output: Output
    model: str
    friction: float
    strain: np.ndarray
    packing: np.ndarray
    stress: np.ndarray
    measures: dict = field(default_factory=dict)  # columns of measures.csv, and their axial_strain
    reference: float = 0.8
    reference_stress: float | None = None
    reference_strain: float | None = None
    constants: dict = field(default_factory=dict)
    quality: dict = field(default_factory=dict)  # R² of the fits that the constants are from

    @property
    def directory(self):
        return self.output.directory

    @property
    def label(self):
        return self.model.upper() + (f", μ = {self.friction:g}" if self.friction > 0 else "")

    def measured(self, *names):
        """Columns of the measures against packing; None when one is missing."""
        if any(name not in self.measures for name in names):
            return None
        return [self.measures[name] for name in names]

    def normalised(self, width=0.0025):
        """
        (strain since the reference, stress over that of the reference, packing), means over pieces
        of packing.
        """
        if not self.reference_stress:
            return None
        packing, stress = fits.means(self.packing, self.stress, width)
        strain = fits.means(self.packing, self.strain, width)[1]
        return strain - self.reference_strain, stress / self.reference_stress, packing


def read_run(directory, reference):
    output = open_run(directory)
    history = output.history_table
    for name in (
        "axial_strain",
        "packing_fraction",
        "bottom_force_N_per_m",
        "left_position_m",
        "right_position_m",
    ):
        if name not in history:
            raise InputError(f"{directory} is no compaction: its history.csv has no column {name}")
    strain, packing = history["axial_strain"], history["packing_fraction"]
    known = np.isfinite(strain) & np.isfinite(packing)
    if known.sum() < 2:
        raise InputError(f"{directory} has too few steps with axial_strain and packing_fraction")
    # The way down only: what follows the largest strain is another load.
    known &= np.arange(len(strain)) <= np.nanargmax(strain)
    width = history["right_position_m"] - history["left_position_m"]
    friction = output.parameters.get("Contact/Friction", 0.0)
    run = Run(
        output,
        output.model,
        friction if isinstance(friction, (int, float)) else 0.0,
        strain[known],
        packing[known],
        (history["bottom_force_N_per_m"] / width)[known],
        reference=reference,
    )
    end = history["time_s"][known][-1]
    if os.path.exists(output.path("measures.csv")):
        measures = output.measures_table
        kept = measures["time_s"] <= end
        run.measures = {name: values[kept] for name, values in measures.items()}
        run.measures["axial_strain"] = np.interp(
            run.measures["time_s"], history["time_s"][known], strain[known]
        )
        if "packing_fraction" not in run.measures:
            run.measures["packing_fraction"] = np.interp(
                run.measures["time_s"], history["time_s"][known], packing[known]
            )
    run.reference_stress = fits.value_at(run.packing, run.stress, reference, NEAR)
    run.reference_strain = fits.value_at(run.packing, run.strain, reference, NEAR)
    if run.reference_stress is not None and not run.reference_stress > 0:
        run.reference_stress = None
    run.constants = constants_of(run)
    return run


def densities(run, packing):
    """
    Probability density of normal forces near a packing: (force over mean, density), None without
    states there.
    """
    names = [name for name in run.measures if name.startswith("force_density_at_")]
    if not names:
        return None
    rows = np.stack([run.measures[name] for name in names], axis=1)
    near = (np.abs(run.measures["packing_fraction"] - packing) <= NEAR) & np.isfinite(rows).all(
        axis=1
    )
    if not near.any():
        return None
    return np.array([float(name.rsplit("_", 1)[1]) for name in names]), rows[near].mean(axis=0)


def gamma_near(run, packing):
    found = run.measured("packing_fraction", "force_fit_gamma")
    if found is None:
        return None
    near = (np.abs(found[0] - packing) <= NEAR) & np.isfinite(found[1])
    return float(np.median(found[1][near])) if near.any() else None


def constants_of(run):
    """Every name of CONSTANTS with its number, None where the run does not give it."""
    result: dict[str, Any] = dict.fromkeys(CONSTANTS)
    result["initial_packing"] = float(np.mean(run.packing * np.exp(-run.strain)))
    result["reference_stress_Pa"] = run.reference_stress
    if curve := run.normalised(width=0.005):
        strain, stress, packing = curve
        fitted = (packing >= run.reference) & (packing <= LIMIT)
        strain, stress, packing = strain[fitted], stress[fitted], packing[fitted]
        for name, found in (
            ("beta", fits.slope_through_origin(strain, stress - 1)),
            ("packing_slope", fits.slope_through_origin(stress - 1, packing - run.reference)),
            ("alpha", fits.exponential_packing(stress, packing, run.reference)),
        ):
            if found:
                result[name], result[name + "_rms"] = found
        if len(stress):
            fitted = (
                {"beta": stress, "packing_slope": packing}
                if run.model == "mpm"
                else {"alpha": packing}
            )
            for name, values in fitted.items():
                if result[name] is not None:
                    run.quality[name] = fits.quality(values, result[name + "_rms"])
    if found := run.measured("packing_fraction", "coordination_of_bodies", "axial_strain"):
        packing, coordination, strain = found
        result["jamming_strain"] = fits.first_crossing(strain, coordination, 3.0)
        result["jamming_packing"] = fits.first_crossing(packing, coordination, 3.0)
        if power := fits.power_of_coordination(packing, coordination, run.reference):
            (
                result["coordination_exponent"],
                result["coordination_at_reference"],
                result["coordination_when_full"],
                result["coordination_rms"],
            ) = power
            run.quality["coordination_exponent"] = fits.quality(
                coordination[packing >= run.reference], power[3]
            )
    result["force_gamma"] = gamma_near(run, PACKINGS[0])
    if found := run.measured("packing_fraction", "shape_anisotropy"):
        if regimes := fits.three_regimes(*found):
            result["first_regime_ends"], result["second_regime_ends"] = regimes[0]
    return result


def groups_of(runs):
    """Runs of one model and friction, in the order MPM before BPM, less friction first: [[Run]]."""
    groups: dict[Any, list[Run]] = {}
    for run in runs:
        groups.setdefault((run.model != "mpm", run.model, run.friction), []).append(run)
    return [groups[key] for key in sorted(groups)]


def mean_and_spread(group, name):
    """
    (mean, standard deviation, number of runs) of a constant over the runs of a group; None without
    any.
    """
    values = [run.constants[name] for run in group if run.constants[name] is not None]
    if not values:
        return None
    return (
        float(np.mean(values)),
        float(np.std(values, ddof=1)) if len(values) > 1 else 0.0,
        len(values),
    )
