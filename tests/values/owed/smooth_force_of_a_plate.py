# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A rectangle without friction is pressed between two plates by 2 m/s. The force on the plate at rest is smooth: in no step it
is five times the mean force of the second half of the run, wherever the rectangle begins: rounding changes a force that is
not smooth by as much as it is large.
"""
PLACES = ("0.5e-3, 0.3001e-3", "0.500000000002e-3, 0.3001e-3")


def largest_over_mean(run):
    step, force = (run.history[name] for name in ("dt_s", "bottom_force_N_per_m"))
    half = len(force) // 2
    mean = sum(d * abs(f) for d, f in zip(step[half:], force[half:])) / sum(step[half:])
    return max(map(abs, force)) / mean


def measure(start):
    runs = [start("pressed_rectangle.prm", f"Bodies/a/Center={place}") for place in PLACES]
    return {"code": max(run.code for run in runs), "says": [run.error for run in runs],
            "largest over mean": max(map(largest_over_mean, runs))}


def is_right(found):
    return found["code"] == 0 and found["largest over mean"] < 5


def is_known(found):
    """Matter beside a corner is turned inside out: steps are short and forces leap, or the run ends with place and depth."""
    ends = [text for text in found["says"] if text]
    return found["largest over mean"] >= 5 if found["code"] == 0 else all(
        found["code"] == 1 and "lie " in text and " cells deep in each other at (" in text for text in ends)
