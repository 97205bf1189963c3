# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Rough disks in a cell that repeats, met by rays: sides under a pressure are unknowns of Newton's method. Every state is in balance, the
sides that are pressed bear what is asked for, and the work of all sides is stored or rubbed off. Two threads give the same bits, and a
run that stops while it is pressed and goes on from its checkpoint comes to the same numbers.
"""

RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")
PRESSURE = 2e5


def measure(start):
    run = start("sheared_cell.prm", *RAYS, codes=(0,))
    threads = start("sheared_cell.prm", *RAYS, codes=(0,), words=("--threads", "2"))
    half = start("sheared_cell.prm", *RAYS, "Stop/End time=3.2e-4", codes=(0,))
    checkpoint = max(half.folder.glob("state-*.h5"))
    on = start("sheared_cell.prm", *RAYS, codes=(0,), words=("--restart", checkpoint))
    history = run.history
    width = history["right_position_m"][-1] - history["left_position_m"][-1]
    stored, lost, work = (history[f"{name}_J_per_m"][-1] for name in ("elastic_energy", "dissipated_energy", "external_work"))
    force = "top_force_N_per_m"
    return {"pressure": history[force][-1] / width / PRESSURE - 1, "balance": (stored + lost) / work - 1,
            "unbalanced": max(history["unbalanced_force"][1:]),
            "iterations": sum(history["newton_iterations"]) / (len(history["step"]) - 1),
            "threads": list(threads.history[force]) == list(history[force]),
            "restart": on.history[force][-1] == history[force][-1]}


def is_right(found):
    return (abs(found["pressure"]) < 1e-4 and abs(found["balance"]) < 0.03 and found["unbalanced"] < 1e-4
            and found["iterations"] < 20 and found["threads"] and found["restart"])
