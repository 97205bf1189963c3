# SPDX-License-Identifier: LGPL-2.1-or-later
"""LAMMPS dumps of primaries or material points, which OVITO and other viewers of particles open."""

import os
from typing import Any, Dict, List

import numpy as np

from .errors import InputError

COLUMNS = ("id", "mol", "type", "x", "y", "z", "radius", "vx", "vy", "vz")


def write_dump(states, path):
    """
    Writes the points of states as a text dump in SI units: number, body (mol), radius, place and
    velocity; for material points the radius is that of a disk of the same area. The file is written
    whole or not at all.
    """
    temporary = os.path.join(os.path.dirname(path), ".part-" + os.path.basename(path))
    with open(temporary, "w", encoding="ascii") as file:
        file.write("ITEM: UNITS\nsi\n")  # once, and before the time: as LAMMPS writes and reads it
        for state in states:
            write_frame(file, state)
    os.replace(temporary, path)
    return path


def write_frame(file, state):
    points = state.points
    place, n = points["position_m"], len(points)
    if n == 0:
        raise InputError(f"state {state.number} of {state.run.directory} has no points")
    radius = points["radius_m"] if "radius_m" in points else np.sqrt(points["area_m2"] / np.pi)
    velocity = points["velocity_m_per_s"] if "velocity_m_per_s" in points else np.zeros((n, 2))
    edge = radius.max()
    low, high = place.min(axis=0) - edge, place.max(axis=0) + edge
    file.write(
        f"ITEM: TIME\n{state.time!r}\nITEM: TIMESTEP\n{state.number}\n"
        f"ITEM: NUMBER OF ATOMS\n{n}\nITEM: BOX BOUNDS ff ff pp\n"
    )
    for bounds in (*zip(low, high), (-edge, edge)):
        file.write(f"{bounds[0]:.9g} {bounds[1]:.9g}\n")
    file.write(f"ITEM: ATOMS {' '.join(COLUMNS)} \n")
    rows = np.column_stack(
        [
            np.arange(1, n + 1),
            points["body"] + 1,
            np.ones(n),
            place,
            np.zeros(n),
            radius,
            velocity,
            np.zeros(n),
        ]
    )
    np.savetxt(file, rows, fmt=["%d"] * 3 + ["%.9g"] * (len(COLUMNS) - 3))


def read_dump(path):
    """
    Frames of a text dump: [{"step": number, "time": or None, "units": or None, "bounds": rows low,
    high, column: array}].

    For tests, and to take up dumps of other programs.
    """
    with open(path, encoding="ascii") as file:
        lines = iter(file.read().splitlines())
    frames: List[Dict[str, Any]] = []
    number, units, time = 0, None, None
    for line in lines:
        if line == "ITEM: UNITS":
            units = next(lines)
        elif line == "ITEM: TIME":
            time = float(next(lines))
        elif line == "ITEM: TIMESTEP":
            frames.append({"step": int(next(lines)), "time": time, "units": units})
            time = None
        elif line == "ITEM: NUMBER OF ATOMS":
            number = int(next(lines))
        elif line.startswith("ITEM: BOX BOUNDS"):
            frames[-1]["bounds"] = np.array(
                [next(lines).split()[:2] for _ in range(3)], dtype=float
            )
        elif line.startswith("ITEM: ATOMS"):
            names = line.split()[2:]
            rows = np.array([next(lines).split() for _ in range(number)], dtype=float).reshape(
                number, len(names)
            )
            frames[-1].update({name: rows[:, i] for i, name in enumerate(names)})
        else:
            raise InputError(f"{path} is no LAMMPS dump that can be read here: '{line[:60]}'")
    return frames
