#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of a light dent a grid misses, by Poisson's ratio, by the angle between the plates and the lines of the grid, and by
where between two of them the contact is; and the force that comes out: the tables of doc/results/rim.md.

The disk of verification/line_contact.prm is pressed by plates that stand at any angle. k is the half width, in cells, on
which the grid puts a line force: g = ln(k h/a), see SubgridCompliance."""
import math
import statistics

import numpy as np

from running import parser_of, run, softgrain
from subgrid import POISSON, RADIUS, YOUNG, half_width, missing

RATIOS = (0.0, 0.15, 0.3, 0.4, 0.45, 0.49)
SHIFTS = (0.0, 0.2, 0.4, 0.6, 0.8)  # of the grid [cells]
# Angles with R in cells for which both contacts are at the same place between lines, one of them at least along the plate.
ANGLES = ((0.0, 4.8), (15.0, 3.8637), (22.5, 5.22625), (45.0, 4.24264))
TURNED = (0.0, 10.0, 22.5, 35.0, 45.0)
APPROACHES = (0.005, 0.01, 0.02)  # of a plate over the radius
COARSE = 1.7e-3  # cells of a disk of six [m]


def press(program, folder, cell, shift, angle, poisson, subgrid, way, step):
    """(approach over R, force) of a run whose plates are turned by @angle [degrees] against the grid."""
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    n = math.ceil(1.7 * RADIUS / cell) + 1
    changes = {"Mesh/Cell size": cell, "Contact/Sub-grid compliance": subgrid, "Stop/End time": way, "Time/Time step": step,
               "Mesh/Lower": f"{-(n + shift[0]) * cell}, {-(n + shift[1]) * cell}",
               "Mesh/Upper": f"{(n + 1 - shift[0]) * cell}, {(n + 1 - shift[1]) * cell}",
               "Materials/gel/Neo-Hookean/Poisson's ratio": poisson, "Output/Number of field outputs": 0}
    for wall, side in (("bottom", -1), ("top", 1)):
        changes[f"Walls/{wall}/Point"] = f"{side * RADIUS * sine}, {side * RADIUS * cosine}"
        changes[f"Walls/{wall}/Normal"] = f"{-side * sine}, {-side * cosine}"
    name = f"{poisson}-{cell:.5g}-{shift[0]:.2f}-{shift[1]:.2f}-{angle}-{subgrid}-{way}"
    _, rows = run(program, "verification/line_contact.prm", folder / name, changes, threads=1, again=False)
    return [(row["time_s"], row["top_force_N_per_m"]) for row in rows if row["top_force_N_per_m"] > 0]


def log_width(program, folder, cell, shift, angle, poisson):
    """Mean ln k of a run, while the contact is narrow."""
    found = []
    for approach, force in press(program, folder, cell, shift, angle, poisson, "false", 0.03, 2.5e-3):
        width = half_width(force, poisson) / cell
        if 0.1 < width < 0.42:
            found.append(missing(force, approach * RADIUS, poisson) + math.log(width))
    return statistics.fmean(found)


def by_ratio(program, folder):
    print("| ν | ln k, mean over ten cuts | at a line | between lines |\n|---|---|---|---|")
    for poisson in RATIOS:
        cuts = [[log_width(program, folder, 2 * spacing * RADIUS, (cut / 10, cut / 10), 0.0, poisson) for cut in range(10)]
                for spacing in (0.17, 0.10)]
        line, between = (statistics.fmean(values[place] for values in cuts) for place in (0, 5))
        print(f"| {poisson} | {np.mean(cuts):.3f} | {line:.3f} | {between:.3f} |", flush=True)


def by_angle(program, folder):
    print("| ν | angle | ln k, mean | cos 2πx | cos 2πy | r.m.s. about the mean | about the fit |\n" + "|---" * 7 + "|")
    for poisson in (POISSON, 0.3):
        for angle, radius in ANGLES:
            places, found = [], []
            for x in SHIFTS:
                for y in SHIFTS:
                    found.append(log_width(program, folder, RADIUS / radius, (x, y), angle, poisson))
                    ends = [(x + side * radius * math.sin(math.radians(angle)), y + side * radius * math.cos(math.radians(angle)))
                            for side in (1, -1)]
                    places.append([1.0] + [statistics.fmean(math.cos(2 * math.pi * end[d]) for end in ends) for d in (0, 1)])
            fit = np.linalg.lstsq(np.array(places), np.array(found), rcond=None)[0]
            left = np.array(found) - np.array(places) @ fit
            print(f"| {poisson} | {angle}° | {fit[0]:.3f} | {fit[1]:.3f} | {fit[2]:.3f} | {np.std(found):.3f} | {left.std():.3f} |", flush=True)


def forces(program, folder):
    print("| ν | angle | " + " | ".join(f"{kind}, d/R = {at}" for kind in ("without", "with") for at in APPROACHES) + " |\n" + "|---" * 8 + "|")
    for poisson in (POISSON, 0.3):
        for angle in TURNED:
            cells = []
            for subgrid in ("false", "true"):
                errors = {at: [] for at in APPROACHES}
                for k in range(6):
                    curve = press(program, folder, COARSE * (1 + 0.07 * (k % 3)), (0.37 * k % 1, 0.61 * k % 1), angle, poisson, subgrid,
                                  max(APPROACHES), 5e-3)
                    for at in APPROACHES:
                        force = min(curve, key=lambda row: abs(row[0] - at))[1]
                        errors[at].append(100 * (force / softgrain.theory.johnson(-math.log(1 - at), YOUNG, poisson, RADIUS) - 1))
                cells += [f"{statistics.fmean(errors[at]):+.1f} [{min(errors[at]):.1f}, {max(errors[at]):.1f}]" for at in APPROACHES]
            print(f"| {poisson} | {angle}° | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = parser_of(__doc__, "rim")
    arguments = parser.parse_args()
    for table in (by_ratio, by_angle, forces):
        table(arguments.program, arguments.folder)


if __name__ == "__main__":
    main()
