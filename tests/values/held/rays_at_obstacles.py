# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk is pressed into a notch between two flanks, met by rays, at rest: both flanks feel the same force, and together they bear what
the wall gives. Every state is found in few iterations.
"""

RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")


def measure(start):
    run = start("../../../parameters/gallery/notch_mpm.prm", *RAYS, "Mesh/Cell size=6e-4", "Stop/End time=1.5e-3", "Output/Fields every=0",
                "Output/Snapshots every=1.5e-3", codes=(0,))
    left, right = run.states[-1].obstacles.force_N_per_m
    top = run.history["top_force_N_per_m"][-1]
    return {"same": abs(left[0] / right[0] + 1), "borne": abs(left[1] + right[1]) / top, "normal": abs(left[0] / left[1]),
            "iterations": sum(run.history["newton_iterations"]) / run.history["step"][-1]}


def is_right(found):
    return (found["same"] < 1e-5 and abs(found["borne"] - 1) < 1e-4 and abs(found["normal"] - 1) < 1e-4
            and found["iterations"] < 6)
