# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Two disks in a box that is pressed, slid and stirred by a paddle: 'Output/Forces on' gives the columns that history.csv has of walls and
obstacles by another way (a paddle that turns has its force before and after the turn of a step), what two bodies do to each other is
opposite, what comes from each partner adds up to what comes from all, and what Python makes of the snapshots is the same.
"""

import numpy as np

OTHERS = ("bottom", "top", "left", "right", "paddle")
FORCES = "a, b, a / b, b / a, bottom, top, right, paddle, bottom / a, " + ", ".join(f"b / {other}" for other in OTHERS)
QUASI_STATIC = ("Time/Scheme=quasi_static", "Time/Time step=1e-3")
SCENES = (("works_mpm.prm", ()), ("works_mpm.prm", QUASI_STATIC), ("works_mpm.prm", (*QUASI_STATIC, "Contact/Geometry=rays")),
          ("works_bpm.prm", ("Bodies/b/Center=8e-3, 2.6e-3", "Walls/left/Velocity=0.12", "Walls/top/Pressure=200")))


def load_of(history, name):
    """Force x, y and torque, a row for each row of the history."""
    return np.array([history[f"{name}_{part}"] for part in ("force_x_N_per_m", "force_y_N_per_m", "torque_N")]).T


def of_python(run, body, partner):
    """The same of the last state, as softgrain's Python sees it."""
    state = run.states[-1]
    loads = state.loads
    own = loads.where(loads.body == list(state.bodies.name).index(body))
    if partner is not None:
        own = own.where(own.partner_name == partner)
    return np.array([*own.force_N_per_m.sum(axis=0), own.torque_N.sum()])


def differs(found, right):
    """The largest difference of the two, of forces and torques apart, over the largest value; 0 where nothing touches."""
    found, right = np.atleast_2d(found), np.atleast_2d(right)
    return max(np.abs(found[:, part] - right[:, part]).max() / max(np.abs(right[:, part]).max(), 1e-300)
               for part in (slice(0, 2), slice(2, 3)))


def measure(start):
    found = []
    for scene, settings in SCENES:
        run = start(scene, *settings, "Output/Snapshots every=0.01", f"Output/Forces on={FORCES}", codes=(0,))
        history = run.history
        a, b = load_of(history, "a_contact"), load_of(history, "b_contact")
        of_b = {name: load_of(history, f"b_from_{name}") for name in ("a", *OTHERS)}
        one = {
            "scene": (scene, *settings),
            "bottom": float(np.abs(-load_of(history, "bottom_contact")[:, 1] - history["bottom_force_N_per_m"]).max()),
            "top": float(np.abs(load_of(history, "top_contact")[:, 1] - history["top_force_N_per_m"]).max()),
            "right": float(np.abs(load_of(history, "right_contact")[:, 0] - history["right_force_N_per_m"]).max()),
            "paddle": differs(load_of(history, "paddle_contact"), load_of(history, "paddle")),
            "opposite": float(np.abs(of_b["a"] + load_of(history, "a_from_b"))[:, :2].max()),
            "sum": float(np.abs(sum(of_b.values()) - b).max()),
            "python": max(differs(load[-1], of_python(run, body, partner)) for body, partner, load in (
                ("a", None, a), ("b", None, b), ("b", "a", of_b["a"]), ("b", "top", of_b["top"]), ("a", "b", load_of(history, "a_from_b")))),
            "touched": {name: bool(load.any()) for name, load in of_b.items()},
            "largest": float(np.abs(b[:, :2]).max())}
        found.append(one)
    return found


def is_right(found):
    touched = {name for one in found for name, does in one["touched"].items() if does}
    return touched >= {"a", "bottom", "top", "paddle"} and all(one["touched"]["a"] and max(one[name] for name in ("bottom", "top", "right", "opposite", "sum")) < 1e-6 * one["largest"]
               and one["paddle"] < 1e-3 and one["python"] < 1e-6 for one in found)
