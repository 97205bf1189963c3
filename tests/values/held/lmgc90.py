# SPDX-License-Identifier: LGPL-2.1-or-later
"""
An assembly against a code that shares nothing with this one. LMGC90 (105 bilinear elements in a grain, theta .7, steps of 1e-5 s) has pressed the
thirty disks of gallery/thirty_grains_mpm.prm from the same places without friction. Forces are means of those on the two walls, at eight
heights of the upper one. At .2 m/s no force is off by more than 4 %, and the root of the mean square of all is below 2 %: as far as the
coarse elements of the other code are worth. Grains rearrange on the way, so one wrong contact would show at all heights that follow.
"""
import numpy as np

HEIGHTS = (9.6e-3, 9.4e-3, 9.2e-3, 9.0e-3, 8.8e-3, 8.6e-3, 8.4e-3, 8.32e-3)
FORCES = (1778, 2927, 4064, 5642, 7294, 8887, 11729, 13170)


def measure(start):
    run = start("../../../parameters/gallery/thirty_grains_mpm.prm", "Walls/top/Velocity=0.2", "Time/CFL multiple=100", "Stop/End time=1",
                "Output/Fields every=0", "Output/Snapshots every=0", "Output/Number of field outputs=1", codes=(0,))
    history = run.history
    forces = (np.array(history["top_force_N_per_m"]) + np.array(history["bottom_force_N_per_m"])) / 2
    found = np.interp(-np.array(HEIGHTS), -np.array(history["top_position_m"]), forces) / FORCES - 1
    return {"worst": float(np.abs(found).max()), "r.m.s.": float(np.sqrt(np.mean(found**2))), "packing fraction": history["packing_fraction"][-1]}


def is_right(found):
    return found["worst"] < 0.04 and found["r.m.s."] < 0.02 and found["packing fraction"] >= 0.95
