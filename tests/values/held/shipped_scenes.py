# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Four shipped scenes keep what their first lines promise. A disk between four plates presses on them as it does with a grid seven times as
fine (doc/results/quasi-static.md), on opposite ones alike. A punch feels the force on the bottom of its block, nothing aside, and its work is
stored. Cells that grow press with 2.7 kPa at a packing fraction of 0.98, and what growth does is stored or dissipated. A packing that
becomes a tissue has six contacts to a grain, Euler's number, with sixteen grains as with a hundred.
"""
FOLDER = "../../../parameters/"
FINE = {0.86: 0.0409, 0.90: 0.0865, 0.95: 0.1996}  # mean pressure on the plates over Young's modulus
YOUNG, GROWN = 10e6, 2.7e3
SIXTEEN = ("Packing/Number=16", "Packing/Upper=7.6e-3, 7.6e-3", "Walls/top/Point=0, 7.6e-3", "Walls/right/Point=7.6e-3, 0",
           "Mesh/Upper=10.6e-3, 10.6e-3", "Output/Fields every=0", "Output/Snapshots every=1", "Stages/press/Stop/End time=0.88")


def at(history, fraction, values):
    """The value where the packing fraction is so large, by a line between two rows."""
    reached = history["packing_fraction"]
    k = next(i for i, there in enumerate(reached) if there >= fraction)
    share = (fraction - reached[k - 1]) / (reached[k] - reached[k - 1])
    return (1 - share) * values[k - 1] + share * values[k]


def pressures(history):
    """Mean stress on the four walls in every row."""
    columns = (history[f"{wall}_{what}"] for wall in ("left", "right", "bottom", "top") for what in ("position_m", "force_N_per_m"))
    return [0.25 * ((f_left + f_right) / (top - bottom) + (f_bottom + f_top) / (right - left))
            for left, f_left, right, f_right, bottom, f_bottom, top, f_top in zip(*columns)]


def apart(history, first, second):
    """Largest difference of the forces on two walls over the last one."""
    one, two = history[f"{first}_force_N_per_m"], history[f"{second}_force_N_per_m"]
    return max(abs(a - b) for a, b in zip(one, two)) / two[-1]


def measure(start):
    plates = start(FOLDER + "verification/confined_disk.prm", codes=(0,)).history
    punch = start(FOLDER + "gallery/punch_mpm.prm", codes=(0,)).history
    cells = start(FOLDER + "gallery/growing_cells_mpm.prm", codes=(0,)).history
    tissue = start(FOLDER + "packings/confluence.prm", *SIXTEEN, codes=(0,)).history
    pressed = pressures(plates)
    kept = sum(cells[f"{name}_energy_J_per_m"][-1] for name in ("elastic", "kinetic", "dissipated"))
    return {
        "plates": {fraction: at(plates, fraction, pressed) / YOUNG / fine - 1 for fraction, fine in FINE.items()},
        "opposite": max(apart(plates, "bottom", "top"), apart(plates, "left", "right")),
        "punch": punch["bottom_force_N_per_m"][-1] / punch["punch_force_y_N_per_m"][-1] - 1,
        "aside": punch["punch_force_x_N_per_m"][-1] / punch["punch_force_y_N_per_m"][-1],
        "rises": all(a < b for a, b in zip(punch["punch_force_y_N_per_m"], punch["punch_force_y_N_per_m"][1:])),
        "punched": punch["elastic_energy_J_per_m"][-1] / punch["punch_work_J_per_m"][-1] - 1,
        "cells": at(cells, 0.98, pressures(cells)) / GROWN - 1,
        "cells_opposite": max(apart(cells, "bottom", "top"), apart(cells, "left", "right")),
        "six": tissue["coordination"][-1],
        "grown": kept / cells["growth_work_J_per_m"][-1] - 1}


def is_right(found):
    return (max(map(abs, found["plates"].values())) < 0.02 and found["opposite"] < 1e-5 and abs(found["punch"]) < 1e-4
            and abs(found["aside"]) < 1e-6 and found["rises"] and abs(found["punched"]) < 2e-3 and abs(found["cells"]) < 0.05
            and found["cells_opposite"] < 2e-3 and found["six"] == 6 and abs(found["grown"]) < 1e-3)
