# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Widths of light contacts by Hertz's law, where a scene says what it needs: round bodies, their
moduli and radii.
"""

import math

import numpy as np

from .errors import InputError
from .loads import body_names, wall_names
from .parameters import plain

ROUND = "disk"


def half_width(state, body, partner, force):
    """
    Half of the width on which two bodies, or a body and a wall, touch under a force per metre: a² =
    4 F R / (π E*), with the sums of 1/R and (1-ν²)/E of both. None where the scene does not say
    them, or where the law does not hold.

    Johnson, Contact Mechanics (1985), section 4.2.
    """
    sides = [side_of(state, body), side_of(state, partner)]
    if None in sides or force <= 0:
        return None
    curvature, compliance = (sum(values) for values in zip(*sides))
    return (
        math.sqrt(4 * force * compliance / (math.pi * curvature))
        if curvature > 0 and compliance > 0
        else None
    )


def side_of(state, name):
    """(1/R, (1-ν²)/E) of a round body, (0, 0) of a wall; None of all others."""
    parameters, numbers = state.run.parameters, {
        text: number for number, text in body_names(state).items()
    }
    if name not in numbers:
        return (0.0, 0.0) if name in wall_names(state)[: len(parameters.names("Walls"))] else None
    packed = name not in parameters.names("Bodies")
    section = "Packing" if packed else f"Bodies/{name}"
    if parameters.get(f"{section}/{'Shapes' if packed else 'Shape'}") != ROUND or any(
        str(parameters.get(f"Packing/{key}", ""))
        for key in (("Classes", "Class table", "File") if packed else ())
    ):
        return None
    # Pictures have the area of now, which is that at rest but for a few per cent.
    area = float(
        state.bodies["reference_area_m2" if "reference_area_m2" in state.bodies else "area_m2"][
            np.flatnonzero(state.bodies["body"] == numbers[name])[0]
        ]
    )
    driven = parameters.get(f"{section}/Driven", False) is True
    compliance = (
        0.0 if driven else compliance_of(parameters, str(parameters.get(f"{section}/Material", "")))
    )
    return None if compliance is None else (math.sqrt(math.pi / area), compliance)


def compliance_of(parameters, material):
    """(1-ν²)/E of a material, '' the only one; None where its law has no such numbers."""
    names = parameters.names("Materials")
    material = material or (names[0] if len(names) == 1 else "")
    law = plain(str(parameters.get(f"Materials/{material}/Law", "")))
    found = {}
    for key in parameters:
        parts = key.split("/")
        if len(parts) == 4 and parts[:2] == ["Materials", material] and plain(parts[2]) == law:
            found[parts[3]] = parameters[key]
    try:
        return (1 - float(found["Poisson's ratio"]) ** 2) / float(found["Young's modulus"])
    except (KeyError, TypeError, ValueError, InputError):
        return None
