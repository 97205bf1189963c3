# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A triangle falls with a tip into the notch between a wall and a plate that begins on it. It takes at most twice the steps of a
pentagon of the same size.
"""
import math


def measure(start):
    steps, says = {}, []
    for corners in (3, 5):
        turns = [math.radians(113 + 360 * k / corners) for k in range(corners)]
        vertices = "; ".join(f"{-0.034 + 0.00524583 * math.cos(t)!r}, {0.054 + 0.00524583 * math.sin(t)!r}" for t in turns)
        run = start("tip_in_a_notch.prm", f"Bodies/grain/Vertices={vertices}")
        steps[corners] = run.history["step"][-1]
        says.append(run.error)
    return {"steps": steps, "says": says}


def is_right(found):
    return not any(found["says"]) and found["steps"][3] <= 2 * found["steps"][5]

