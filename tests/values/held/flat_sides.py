# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Flat sides that are met by rays. A rectangle between plates that do not hold it sideways is under one stress everywhere: the force is that
of the law, and Newton's method takes two or three iterations a step. The tip of a triangle goes on into the flat side of a block
(it used to end after a tenth of the way), both plates bear the same force, and nothing lies in each other by more than .055 cells: from the 24th step on, when the tip
has snapped, it is .05 between two rays beside it.
"""
import math

RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")
YOUNG, POISSON, WIDTH, STRETCH = 10e6, 0.45, 6e-3, 0.75


def exact_force():
    """Of the neo-Hookean law in plane strain, the width found by halving."""
    shear, lame = YOUNG / 2 / (1 + POISSON), YOUNG * POISSON / (1 + POISSON) / (1 - 2 * POISSON)

    def nominal(along, across):
        return shear * (along - 1 / along) + lame * math.log(along * across) / along

    low, high = 1.0, 2.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if nominal(middle, STRETCH) > 0 else (middle, high)
    return -WIDTH * nominal(STRETCH, low)


def measure(start):
    flat, tip = start("flat_between_plates.prm", *RAYS).history, start("tip_on_a_side.prm", *RAYS)
    wedge = tip.history
    return {"force": flat["top_force_N_per_m"][-1] / exact_force() - 1,
            "iterations": sum(flat["newton_iterations"]) / (len(flat["step"]) - 1),
            "tip": tip.code, "tip iterations": sum(wedge["newton_iterations"]) / (len(wedge["step"]) - 1),
            "plates": abs(wedge["top_force_N_per_m"][-1] / wedge["bottom_force_N_per_m"][-1] - 1),
            "deepest": max(wedge["max_penetration_m"]) / 5e-4}


def is_right(found):
    return (abs(found["force"]) < 5e-4 and found["iterations"] <= 3 and found["tip"] == 0 and found["tip iterations"] <= 6
            and found["plates"] < 1e-6 and found["deepest"] < 0.055)
