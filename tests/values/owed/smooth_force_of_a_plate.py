# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A rectangle without friction is pressed between two plates by 2 m/s. The force on the plate at rest is smooth: in no step it
is five times the mean force of the second half of the run.
"""


def measure(start):
    run = start("pressed_rectangle.prm")
    step, force = (run.history[name] for name in ("dt_s", "bottom_force_N_per_m"))
    half = len(force) // 2
    mean = sum(d * abs(f) for d, f in zip(step[half:], force[half:])) / sum(step[half:])
    return {"code": run.code, "says": run.error, "largest over mean": max(map(abs, force)) / mean}


def is_right(found):
    return found["code"] == 0 and found["largest over mean"] < 5


def is_known(found):
    """Places of the outline come to the plate one by one, each with a small impact, and steps are short."""
    return found["code"] == 0 and found["largest over mean"] >= 5
