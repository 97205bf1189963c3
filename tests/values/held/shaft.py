# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Two soft disks of radius 5 mm in a shaft as wide as they are: a growing load on the upper one presses it on the lower one. It stays
above it, flattened by less than a diameter, and the bottom bears the load, here 1 kN to 1e5 m/s² of its mass of 0.0785 kg/m; whatever
cells and steps.
"""
import math

MASS = 1000 * math.pi * 0.005**2
# Largest load over the mass [m/s^2], cell [m], step [s].
VARIATIONS = [(1e4, 1e-3, 0.2), (1e4, 5e-4, 0.1), (1e3, 1e-3, 0.2), (2e4, 1e-3, 0.1)]


def measure(start):
    found = []
    for load, cell, step in VARIATIONS:
        run = start("shaft.prm", f"Bodies/high/Body force=0; -{load:g}*t", f"Mesh/Cell size={cell}", f"Time/Time step={step}")
        state = run.states[-1]
        low, high = state.bodies.center_m[:, 1]
        found.append({"code": run.code, "says": run.error, "apart_m": high - low,
                      "borne": state.walls.normal_force_N_per_m[0] / (load * MASS)})
    return found


def is_right(found):
    return all(case["code"] == 0 and 6e-3 < case["apart_m"] < 10e-3 and abs(case["borne"] - 1) < 1e-3 for case in found)
