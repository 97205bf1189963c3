# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Three grains that hardly touch, sheared off each other without inertia: what can be asked of a residual is its rounding. Every
tolerance from 1e-4 to 1e-10 comes to the end, and where the tightest ones do, forces and works are the same.
"""

TOLERANCES = ("1e-4", "1e-7", "1e-8", "1e-10")


def measure(start):
    works = []
    for tolerance in TOLERANCES:
        run = start("loose_and_tight.prm", "Newton/Residual tolerance=" + tolerance,
                    "Contact/Tolerance=" + max(tolerance, "1e-7", key=float), codes=(0,))
        works.append(run.history["external_work_J_per_m"][-1])
    return {"works_J_per_m": works, "differ": max(abs(work / works[-1] - 1) for work in works[1:])}


def is_right(found):
    return found["differ"] < 1e-4
