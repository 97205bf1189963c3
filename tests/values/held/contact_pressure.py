# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pressure along the contact of a disk with a plate: its sum is the force on the plate, and it is Johnson's
half ellipse within 5 % of the peak, without jumps, up to 92 % of the half width, with eight cells in the radius at d/R = .058 and with
seventeen at .1, where the contact is eleven cells wide. The force of the half ellipse is that of the finer grid at the same way of the
plates. The half width is right within 3 %; where the pressure goes to zero is not known better than that, so at the very edge it differs
by more. Where the width is that of Hertz's law, since the half width has less than two cells, the forces themselves spread as much within a tenth.
"""
import math

import numpy as np

MODULUS, POISSON, RADIUS, EDGE = 10e6, 0.45, 5e-3, 0.92
CASES = ((2.9e-4, 0.1), (5.8e-4, 0.058), (5.8e-4, 0.08))


def measure(start):
    found, finest = {}, None
    for cell, end in CASES:
        run = start("disk_between_plates.prm", "Quasi-static/Regularisation=1e-6", f"Mesh/Cell size={cell}", f"Stop/End time={end}", f"Output/Snapshots every={end}",
                    codes=(0,))
        state = run.states[-1]
        finest = finest or run.history
        profile = state.contact_profile("disk", "bottom")
        force = float(profile.pressure_Pa @ profile.length_m)
        wall = state.walls.normal_force_N_per_m[0]
        exact = float(np.interp(end, finest["time_s"], finest["bottom_force_N_per_m"]))
        raw = state.contact_profile("disk", "bottom", smooth=False)
        forces = raw.pressure_Pa * raw.length_m
        half = math.sqrt(4 * exact * RADIUS * (1 - POISSON**2) / (math.pi * MODULUS))
        peak = 2 * exact / (math.pi * half)
        pressure = [float(p) / peak for p in profile.pressure_Pa]
        middle = len(pressure) // 2
        rises = [b - a for a, b in zip(pressure, pressure[1:])]
        found[f"{cell}, {end}"] = {
            "sum": force / wall - 1, "traction": max(map(abs, profile.traction_Pa)) / peak, "width": profile.half_width_m / half - 1,
            "spread": 2 * math.sqrt(float(forces @ raw.along_m**2 / forces.sum())) / half - 1,
            "off": max(abs(p - math.sqrt(1 - (s / half)**2)) for s, p in zip(profile.along_m, pressure) if abs(s) < EDGE * half),
            "one hill": min(rises[:middle]) > -1e-3 and max(rises[middle:]) < 1e-3, "width from": profile.width_from,
            "half width, cells": half / cell}
    return found


def is_right(found):
    return (len(found) == len(CASES) and all(
        abs(one["sum"]) < 1e-9 and one["traction"] < 1e-9 and one["off"] < 0.05 and abs(one["width"]) < 0.03 and abs(one["spread"]) < 0.1 and one["one hill"]
        for one in found.values()) and {one["width from"] for one in found.values()} == {"forces", "Hertz's law"})
