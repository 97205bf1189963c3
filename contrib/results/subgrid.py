#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures what grids miss of light line contacts: the function g of doc/results/quasi-static.md.

Presses the disk of verification/line_contact.prm without sub-grid compliance at three resolutions, each with five cuts of
the grid, and prints the mean of g = (δ_Johnson(F) - δ) π E*/(2 F) in bins of a/h, without and with friction at the plates."""
import math

from running import parser_of, run

YOUNG, POISSON, RADIUS = 10e6, 0.45, 5e-3  # of the scene [Pa, 1, m]
SPACINGS = (0.17, 0.10, 0.058)  # of the material points over the radius
CUTS = (0.0, 0.2, 0.4, 0.6, 0.8)  # shift of the grid [cells]
BINS = (0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.9)  # of a/h


def softness(poisson):
    """1/(π E*) [1/Pa]."""
    return (1 - poisson**2) / (math.pi * YOUNG)


def half_width(force, poisson=POISSON):
    return math.sqrt(4 * force * RADIUS * softness(poisson))


def missing(force, approach, poisson=POISSON):
    """g of a run at one approach [m]."""
    johnson = force * softness(poisson) * (2 * math.log(4 * RADIUS / half_width(force, poisson)) - 1)
    return (johnson - approach) / (2 * force * softness(poisson))


def mesh(cell, cut):
    """Cells of a size, shifted by @cut of one against the disk."""
    left, low = (-(math.ceil(reach * RADIUS / cell) + 1 + cut) * cell for reach in (1.6, 1.2))
    return {"Mesh/Cell size": cell, "Mesh/Lower": f"{left}, {low}", "Mesh/Upper": f"{cell - left}, {cell - low}"}


def points(program, folder, spacing, cut, friction):
    """(a/h, g) of one run, up to where Johnson's force is that of finite elements."""
    cell = 2 * spacing * RADIUS
    changes = {**mesh(cell, cut), "Contact/Sub-grid compliance": "false", "Stop/End time": 0.03, "Time/Time step": 2e-3,
               "Output/Number of field outputs": 0, "Walls/bottom/Friction": friction, "Walls/top/Friction": friction}
    _, rows = run(program, "verification/line_contact.prm", folder, changes, threads=1)
    forces = [(row["top_force_N_per_m"], row["time_s"] * RADIUS) for row in rows]
    return [(half_width(force) / cell, missing(force, approach)) for force, approach in forces if force > 0]


def main():
    parser = parser_of(__doc__, "subgrid")
    arguments = parser.parse_args()
    print("| a/h | " + " | ".join(f"{low}–{high}" for low, high in zip(BINS, BINS[1:])) + " |\n" + "|---" * len(BINS) + "|")
    for friction in (0, 0.5):
        for spacing in SPACINGS:
            found = [point for cut in CUTS for point in
                     points(arguments.program, arguments.folder / f"{friction}-{spacing}-{cut}", spacing, cut, friction)]
            cells = []
            for low, high in zip(BINS, BINS[1:]):
                values = [g for width, g in found if low <= width < high]
                cells.append(f"{sum(values) / len(values):.2f}" if values else "")
            print(f"| μ = {friction}, ξ = {spacing} | " + " | ".join(cells) + " |", flush=True)
    middles = [0.5 * (low + high) for low, high in zip(BINS, BINS[1:])]
    print("| ln(0.62 h/a) | " + " | ".join(f"{max(0.0, math.log(0.62 / width)):.2f}" for width in middles) + " |")


if __name__ == "__main__":
    main()
