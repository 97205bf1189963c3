# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pressure along the contact of a disk with a plate, met by rays, seventeen cells in its radius: its sum is the force on the
plate, and it is Hertz's half ellipse of that force, within 8 % of the peak, without jumps. The contact is eleven cells wide.
"""
import math

RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")
MODULUS, POISSON, RADIUS = 10e6, 0.45, 5e-3


def measure(start):
    run = start("disk_between_plates.prm", *RAYS, "Mesh/Cell size=2.9e-4", "Stop/End time=0.1", "Output/Snapshots every=0.1", codes=(0,))
    found = {}
    for state in run.states:
        if state.time < 0.04:
            continue
        profile = state.contact_profile("disk", "bottom")
        force = float(profile.pressure_Pa @ profile.length_m)
        wall = state.walls.normal_force_N_per_m[0]
        half = math.sqrt(4 * force * RADIUS * (1 - POISSON**2) / (math.pi * MODULUS))
        peak = 2 * force / (math.pi * half)
        wrong = [p / peak - math.sqrt(max(0., 1 - (s / half)**2)) for s, p in zip(profile.along_m, profile.pressure_Pa)]
        found[f"{state.time:.2f}"] = {"sum": force / wall - 1, "off": max(map(abs, wrong)), "places": len(wrong),
                                      "traction": max(map(abs, profile.traction_Pa)) / peak,
                                      "half width, cells": half / 2.9e-4, "off by": [round(w, 3) for w in wrong]}
    return found


def is_right(found):
    return (len(found) == 1 and all(abs(one["sum"]) < 1e-9 and one["traction"] < 1e-9 and one["off"] < 0.08 and one["places"] > 15
                                    for one in found.values()))
