#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps by waves or by the way of the walls: error over processor seconds of one disk and of thirty, for walls of several speeds.

Runs thesis/diametral_compression_mpm.prm and gallery/thirty_grains_mpm.prm with inertia, every scene with steps of so many CFL steps and with
steps in which the wall goes so much of a cell. Errors are the root of the mean square of the difference from steps of 2 CFL (one disk: 4),
over the range of the force, for means over 0.01 of packing fraction where there are many grains."""
import math

import numpy as np
from running import parser_of, run

CFL = (4, 8, 20, 40, 60, 120)
WAYS = (0.05, 0.1, 0.2, 0.3)
QUIET = {"Output/Fields every": 0, "Output/Snapshots every": 0, "Output/Number of field outputs": 1, "Output/History every": 1}
DISK_WAYS = np.array((0.01, 0.015, 0.02, 0.03, 0.04, 0.05, 0.07, 0.1, 0.15, 0.2, 0.25))
FRACTIONS = np.arange(0.80, 0.925, 0.01)


def forces_of_disk(rows):
    """Mean of the two plates at the ways of DISK_WAYS, a force at the place of its own instant."""
    way = np.array([row["axial_strain"] for row in rows])
    force = np.array([0.5 * (row["top_force_N_per_m"] + row["bottom_force_N_per_m"]) for row in rows])
    time = np.array([row["time_s"] for row in rows])
    at = np.array([row.get("force_time_s", row["time_s"]) for row in rows])
    return np.interp(DISK_WAYS, np.interp(at, time, way), force)


def forces_of_grains(rows):
    """Means over bins of the packing fraction."""
    fraction = np.array([row["packing_fraction"] for row in rows])
    force = np.array([0.5 * (row["top_force_N_per_m"] + row["bottom_force_N_per_m"]) for row in rows])
    # In between, a force stands for as long as its step.
    fine = np.linspace(FRACTIONS[0] - 0.005, FRACTIONS[-1] + 0.005, 40 * len(FRACTIONS) + 1)
    on_fine = np.interp(fine, fraction, force)
    return np.array([on_fine[abs(fine - centre) <= 0.005].mean() for centre in FRACTIONS])


def cases(speeds, seeds):
    """(name, scene, changes, forces, CFL steps of the reference)"""
    for speed in speeds["disk"]:
        yield f"disk {speed:g}", "thesis/diametral_compression_mpm.prm", {"Walls/top/Velocity": speed, "Stop/End time": 4e-3 / speed}, forces_of_disk, 4
    for speed in speeds["grains"]:
        for seed in seeds:
            yield (f"grains {speed:g} {seed}", "gallery/thirty_grains_mpm.prm",
                   {"Walls/top/Velocity": speed, "Packing/Seed": seed, "Packing/Packing fraction": 0.70, "Stop/Packing fraction": 0.935,
                    "Stop/End time": 4e-3 / speed, "Time/Time step": 0}, forces_of_grains, 2)


def main():
    parser = parser_of(__doc__, "step-choice")
    parser.add_argument("--disk", type=float, nargs="*", default=(0.2, 2.))
    parser.add_argument("--grains", type=float, nargs="*", default=(0.2, 1., 5.))
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2))
    arguments = parser.parse_args()
    for name, scene, changes, forces, finest in cases({"disk": arguments.disk, "grains": arguments.grains}, arguments.seeds):
        def one(label, step):
            summary, rows = run(arguments.program, scene, arguments.folder / f"{name} {label}".replace(" ", "-"), {**QUIET, **changes, **step},
                                threads=1, again=False)
            return forces(rows), summary["processor_seconds"], len(rows) - 1
        exact, seconds, steps = one("reference", {"Time/CFL multiple": finest, "Time/Wall way": 0})
        print(f"{name}: reference {finest} CFL, {steps} steps, {seconds:.1f} s", flush=True)
        for key, values in (("Time/CFL multiple", CFL), ("Time/Wall way", WAYS)):
            for value in values:
                found, seconds, steps = one(f"{key[5:8].strip()}{value}", {key: value, **({} if "Wall" in key else {"Time/Wall way": 0})})
                error = math.sqrt(np.mean(((found - exact) / exact) ** 2)) if "disk" in name else math.sqrt(np.mean((found - exact) ** 2)) / np.abs(exact).max()
                print(f"| {name} | {key[5:]} = {value} | {steps} | {seconds:.2f} | {100 * error:.2f} |", flush=True)


if __name__ == "__main__":
    main()
