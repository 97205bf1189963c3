# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Walls that are driven, pressed and slid, an obstacle that turns, gravity, a body force and growth: history.csv has the work of each,
their sum is the external work, gravity and body force have done what the way of the centres of mass says, and a run that goes on
from a checkpoint has the same numbers.
"""

OTHERS = ("external_work_J_per_m", "regularisation_work_J_per_m")
STILL = ("right", "left", "paddle")  # may have done nothing: not moved, or not touched
SCENES = (("works_mpm.prm", ()), ("works_mpm.prm", ("Time/Scheme=quasi_static", "Time/Time step=2e-3")), ("works_bpm.prm", ()))


def works_of(history):
    return {name: column[-1] for name, column in history.items() if name.endswith("_work_J_per_m") and name not in OTHERS}


def measure(start):
    found = []
    for scene, settings in SCENES:
        run = start(scene, *settings, codes=(0,))
        half = start(scene, *settings, "Stop/End time=0.01", codes=(0,))
        checkpoint, = half.folder.glob("state-*.h5")
        on = start(scene, *settings, codes=(0,), words=("--restart", checkpoint))
        history = run.history
        works = works_of(history)
        total = history["external_work_J_per_m"][-1]
        bodies = [state.bodies for state in (run.states[0], run.states[-1])]
        way = bodies[1].center_m - bodies[0].center_m
        mass = bodies[0].mass_kg_per_m
        found.append({
            "scene": (scene,) + settings[:1], "works": works,
            "sum": sum(works.values()) / total - 1,
            "gravity": works["gravity_work_J_per_m"] / float(-9.81 * (mass * way[:, 1]).sum()) - 1,
            "body_force": works["body_force_work_J_per_m"] / float(2 * mass[0] * way[0, 0]) - 1,
            "same": works_of(on.history) == works})
    return found


def is_right(found):
    return all(abs(one["sum"]) < 1e-8 and abs(one["gravity"]) < 2e-3 and abs(one["body_force"]) < 2e-3 and one["same"]
               and all(work != 0 for name, work in one["works"].items() if name.split("_")[0] not in STILL) for one in found)
