# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk of radius 3 mm lies in a ring of radii 7 and 10 mm that stands on the bottom, under their weight: the bottom bears both,
9.81 m/s² times 1000 kg/m³ times the area, and the disk stays on the ring's inner edge.
"""
import math

WEIGHT = 9.81 * 1000 * math.pi * (0.01**2 - 0.007**2 + 0.003**2)


def measure(start):
    run = start("disk_in_ring.prm")
    state = run.states[-1]
    return {"code": run.code, "says": run.error, "disk_y_m": state.bodies.center_m[1, 1],
            "borne": state.walls.normal_force_N_per_m[0] / WEIGHT}


def is_right(found):
    return found["code"] == 0 and 5.5e-3 < found["disk_y_m"] < 6e-3 and abs(found["borne"] - 1) < 1e-3
