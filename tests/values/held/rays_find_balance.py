# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Without inertia rays find balance where it is hard to find: with outlines that have kinks at the sides of cells, under a load at once that
nothing bears yet, with a corner that comes to lie on a corner, where a wall under pressure has to find bodies that grow, and where what
is unbalanced is rounding. A sharp tip beside a line is as near to its far side as to its near one, and slides into a notch, whose two
sides it must meet at once. Each run comes to its end, in balance, and nothing lies in each other. All six ended with an error.
"""
RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")
SCENES = {"kinks_of_linear_fields": 1.46484375e-3, "load_at_once": 9.1552734375e-4, "corner_on_corner": 1.40380859375e-3,
          "starts_under_pressure": 3e-3, "tight_in_a_cell": None, "tip_at_a_line": 4.8828125e-4}


def measure(start):
    found = {}
    for name, cell in SCENES.items():
        run = start(f"{name}.prm", *RAYS)
        deepest = max(run.history["max_penetration_m"])
        found[name] = {"code": run.code, "deepest": deepest / cell if cell else deepest, "steps": len(run.history["step"]) - 1}
    return found


def is_right(found):
    return all(each["code"] == 0 and each["deepest"] < 0.1 and each["steps"] > 0 for each in found.values())
