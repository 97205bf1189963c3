# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A scene with 'Dimension' = '3': a neo-Hookean ball, three cells in radius, between two plates. The force is within 2 % of that of
axisymmetric finite elements from a travel of a fifth of the radius on, and within 9 % at a tenth, where the contact is a cell wide;
both plates feel the same, and the ball keeps the work that is done on it. A step, with the held one that brings it to balance, takes less
than five iterations in the mean and seven at most. Two threads and a run that is interrupted and goes on give the same numbers. What is not there in space is refused
in one line that names parameter and value.
"""
# F/(E R^2) over the travel of each plate over the radius, for a Poisson's ratio of .45.
ELEMENTS = {0.1: 0.0611559, 0.2: 0.191906, 0.3: 0.399657}
SCENE, RADIUS, YOUNG = "sphere_between_plates.prm", 5e-3, 10e6
REFUSED = {
    "Contact/Adhesion=5": "'Contact/Adhesion' = '5'",
    "Time/Scheme=newmark": "'Time/Scheme' = 'newmark'",
    "Time/Theta=0.6": "'Time/Theta' = '0.6'",
    "Bodies/ball/Velocity=0; 0; 1": "'Bodies/ball/Velocity' = '0; 0; 1'",
    "Walls/top/Type=periodic": "'Walls/top/Type'",
    "Walls/top/Point=0, 0": "'Walls/top/Point' = '0, 0'",
    "Mesh/Lower=-6e-3, -6e-3": "'Mesh/Lower' = '-6e-3, -6e-3'",
    "Bodies/ball/Center=0, 0, 4e-3": "'Bodies/ball' reaches",
}


def at_travel(history, travel):
    for position, force in zip(history["top_position_m"], history["top_force_N"]):
        if abs((2 * RADIUS - position) / (2 * RADIUS) - travel) < 1e-6:
            return force / (YOUNG * RADIUS ** 2)
    return None


def measure(start):
    times = ("Output/Fields every=0.16666666666666666", "Output/Field parts=outlines", "Output/Number of field outputs=0")
    run = start(SCENE, *times, codes=(0,))
    history = run.history
    found = {"forces": {travel: at_travel(history, travel) for travel in ELEMENTS},
             "plates": max(abs(a / b - 1) for a, b in zip(history["top_force_N"], history["bottom_force_N"]) if b),
             "energy": history["elastic_energy_J"][-1] / history["external_work_J"][-1],
             "iterations": max(history["newton_iterations"]),
             "mean_iterations": sum(history["newton_iterations"]) / history["step"][-1],
             "surface": (run.folder / "fields" / "outlines-000000.vtu").exists()}
    threads = start(SCENE, *times, codes=(0,), words=("--threads", "2"))
    found["threads"] = (threads.folder / "history.csv").read_text() == (run.folder / "history.csv").read_text()
    begun = start(SCENE, *times, "Stop/End time=0.5", codes=(0,))
    going = start(SCENE, *times, codes=(0,), words=("--restart", next(begun.folder.glob("state-*.h5"))))
    found["restart"] = max(abs(a / b - 1) for a, b in zip(going.history["top_force_N"][-3:], history["top_force_N"][-3:]))
    found["refused"] = [words for change, words in REFUSED.items() if words not in start(SCENE, change, codes=(2,)).error]
    return found


def is_right(found):
    return (all(force is not None and abs(force / ELEMENTS[travel] - 1) < (0.09 if travel < 0.15 else 0.02) for travel, force in found["forces"].items())
            and found["plates"] < 1e-4 and abs(found["energy"] - 1) < 0.02 and found["iterations"] <= 7 and found["mean_iterations"] < 5 and found["surface"]
            and found["threads"] and found["restart"] < 1e-9 and not found["refused"])
