# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Bodies at rest that are met by rays: Newton's method knows how places slide and normals turn. One disk between plates takes three
iterations a step in the mean, and both plates bear the same force. Ten disks are pressed to 0.93 with every state in balance; work
and energies agree. A run that stops half-way and goes on from its checkpoint comes to the same numbers.
"""
import math

RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")


def balance(history):
    return abs(history["elastic_energy_J_per_m"][-1] + history["dissipated_energy_J_per_m"][-1]
               - history["external_work_J_per_m"][-1]) / history["external_work_J_per_m"][-1]


def measure(start):
    disk = start("disk_between_plates.prm", *RAYS)
    packing = start("ten_disks_pressed.prm", *RAYS)
    half = start("ten_disks_pressed.prm", *RAYS, "Stop/Packing fraction=0.86")
    on = start("ten_disks_pressed.prm", *RAYS, words=("--restart", *half.folder.glob("state-*.h5")))
    one, ten = disk.history, packing.history
    return {"iterations": sum(one["newton_iterations"]) / (len(one["step"]) - 1),
            "plates": abs(one["top_force_N_per_m"][-1] / one["bottom_force_N_per_m"][-1] - 1),
            "disk balance": balance(one), "packing": ten["packing_fraction"][-1],
            "top and bottom": abs(ten["top_force_N_per_m"][-1] / ten["bottom_force_N_per_m"][-1] - 1),
            "packing balance": balance(ten), "deepest": max(ten["max_penetration_m"]) / 3.2e-4,
            "same after restart": on.history["top_force_N_per_m"][-1] == ten["top_force_N_per_m"][-1]}


def is_right(found):
    return (found["iterations"] <= 3 and found["plates"] < 1e-6 and found["disk balance"] < 1e-3 and found["packing"] >= 0.93
            and found["top and bottom"] < 1e-5 and found["packing balance"] < 2e-3 and found["deepest"] < 0.05
            and found["same after restart"] and not math.isnan(found["iterations"]))
