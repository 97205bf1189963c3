#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk between two plates by CalculiX (Debian's calculix-ccx): the rival's deck of doc/results/rivals.md.

    calculix_disk.py FOLDER [--rings 12,13] [--steps 20] [--stiffness 1e4] [--out TABLE]

Writes disk.inp into FOLDER, runs ccx there, and gives the way of a plate over the radius with the force on it over E R. The law is
CalculiX's Ciarlet material, which is softgrain's mooney_rivlin without its second invariant.
"""
import argparse
import math
import os
import pathlib
import shutil
import subprocess
import sys

import deck_tables
import numpy as np

RADIUS, YOUNG, POISSON = 5., 10., 0.45  # mm, MPa
SQUARE = 0.5  # half width of the square in the middle over the radius


def disk_mesh(inner, layers):
    """Nodes and quadrilaterals of the unit disk: a square of (2 inner)^2 cells, layers around it."""
    side = np.linspace(-SQUARE, SQUARE, 2 * inner + 1)
    nodes = [(x, y) for y in side for x in side]
    wide = 2 * inner + 1
    cells = [(j * wide + i, j * wide + i + 1, (j + 1) * wide + i + 1, (j + 1) * wide + i) for j in range(2 * inner) for i in range(2 * inner)]
    # The rim of the square, once around against the clock.
    last = 2 * inner
    rim = [(i, 0) for i in range(last)] + [(last, j) for j in range(last)] + [(last - i, last) for i in range(last)] + [(0, last - j) for j in range(last)]
    ring = [j * wide + i for i, j in rim]
    start = np.array([nodes[n] for n in ring])
    angle = [-0.75 * math.pi + 0.5 * math.pi * n / last for n in range(4 * last)]
    end = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    for layer in range(1, layers + 1):
        new = list(range(len(nodes), len(nodes) + len(ring)))
        nodes += [tuple(place) for place in start + (end - start) * layer / layers]
        cells += [(ring[n], new[n], new[(n + 1) % len(new)], ring[(n + 1) % len(ring)]) for n in range(len(ring))]
        ring = new
    return np.array(nodes), cells, ring


def deck(rings, steps, to, stiffness):
    """The text of the input file."""
    places, cells, rim = disk_mesh(*rings)
    places = RADIUS * places
    lines = ["*NODE, NSET=all"] + [f"{n + 1}, {x:.12g}, {y:.12g}, 0." for n, (x, y) in enumerate(places)]
    plates = {}
    for name, sign in (("bottom", -1), ("top", 1)):
        first = len(places) + 4 * len(plates) + 1
        low, high = sorted((sign * RADIUS, sign * (RADIUS + 1)))
        corners = [(-2 * RADIUS, low), (2 * RADIUS, low), (2 * RADIUS, high), (-2 * RADIUS, high)]
        lines += [f"{first + n}, {x:.12g}, {y:.12g}, 0." for n, (x, y) in enumerate(corners)]
        plates[name] = list(range(first, first + 4))
    lines += ["*ELEMENT, TYPE=CPE4, ELSET=disk"] + [f"{n + 1}, " + ", ".join(str(node + 1) for node in cell) for n, cell in enumerate(cells)]
    for n, (name, nodes) in enumerate(plates.items(), len(cells) + 1):
        lines += [f"*ELEMENT, TYPE=CPE4, ELSET={name}", f"{n}, " + ", ".join(map(str, nodes)), f"*NSET, NSET={name}", ", ".join(map(str, nodes))]
    # Of the outermost cells the second face is on the rim.
    outer = range(len(cells) - len(rim) + 1, len(cells) + 1)
    height = places[[node for node in rim], 1]
    for name, sign in (("above", 1), ("below", -1)):
        touching = [cell for cell, y in zip(outer, height) if sign * y > 0.4 * RADIUS]
        lines += [f"*SURFACE, NAME={name}, TYPE=ELEMENT"] + [f"{cell}, S2" for cell in touching]
    lines += ["*SURFACE, NAME=under, TYPE=ELEMENT", f"{len(cells) + 1}, S3", "*SURFACE, NAME=over, TYPE=ELEMENT", f"{len(cells) + 2}, S1"]
    middle = [n + 1 for n, (x, y) in enumerate(places) if abs(x) < 1e-9 and abs(y) < 1e-9]
    axis = [n + 1 for n, (x, y) in enumerate(places) if abs(x) < 1e-9]
    way = to * RADIUS
    lines += [
        "*MATERIAL, NAME=CIARLET_EL", "*USER MATERIAL, CONSTANTS=2", f"{YOUNG}, {POISSON}",
        "*MATERIAL, NAME=steel", "*ELASTIC", "1e5, 0.3",
        "*SOLID SECTION, ELSET=disk, MATERIAL=CIARLET_EL", "1.",
        "*SOLID SECTION, ELSET=top, MATERIAL=steel", "1.", "*SOLID SECTION, ELSET=bottom, MATERIAL=steel", "1.",
        "*SURFACE INTERACTION, NAME=touch", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness * YOUNG / RADIUS:.6g}, 0., 1e-6",
        "*CONTACT PAIR, INTERACTION=touch, TYPE=SURFACE TO SURFACE", "above, over", "below, under",
        "*NSET, NSET=axis", *map(str, axis), "*NSET, NSET=middle", str(middle[0]),
        "*BOUNDARY", "axis, 1", "middle, 2", "top, 1", "bottom, 1",
        "*STEP, NLGEOM, INC=10000", "*STATIC, DIRECT", f"{1 / steps:.12g}, 1.",
        "*BOUNDARY", f"top, 2, 2, {-way:.12g}", f"bottom, 2, 2, {way:.12g}",
        "*NODE PRINT, NSET=top, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(lines) + "\n"


def forces(text):
    """(time, total force on the upper plate) of each increment."""
    time = None
    for line in text.splitlines():
        if "total force" in line:
            time = float(line.split()[-1])
        elif time is not None and len(line.split()) == 3:
            yield time, -float(line.split()[1])
            time = None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rings", default="12,13", help="half the cells across the middle square, layers around it")
    parser.add_argument("--steps", type=int, default=20)
    parser.add_argument("--to", type=float, default=0.3, help="way of a plate over the radius")
    parser.add_argument("--stiffness", type=float, default=1e4, help="pressure per overlap, in E/R")
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    if shutil.which("ccx") is None:
        sys.exit("ccx is not here: Debian's package calculix-ccx")
    arguments.folder.mkdir(parents=True, exist_ok=True)
    rings = tuple(int(number) for number in arguments.rings.split(","))
    (arguments.folder / "disk.inp").write_text(deck(rings, arguments.steps, arguments.to, arguments.stiffness), encoding="utf-8")
    done = subprocess.run(["ccx", "disk"], cwd=arguments.folder, capture_output=True, text=True, check=False,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    found = list(forces((arguments.folder / "disk.dat").read_text(encoding="utf-8"))) if done.returncode == 0 else []
    if len(found) < arguments.steps:
        sys.exit(f"ccx came to {len(found)} of {arguments.steps} steps:\n{done.stdout[-1500:]}")
    lines = ["way_over_R,force_over_E_R"] + [f"{arguments.to * time:.6g},{force / (YOUNG * RADIUS):.9g}" for time, force in found]
    deck_tables.write(lines, arguments.out)


if __name__ == "__main__":
    main()
