#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs parameters/verification/line_contact.prm at four resolutions and prints the table of doc/results/line-contact.md."""
import argparse
import math
import pathlib

from running import run

YOUNG, POISSON, RADIUS = 10e6, 0.45, 5e-3
SPACINGS = (0.1, 0.058, 0.029, 0.0145)  # of the material points over the radius
STRAINS = (0.01, 0.02, 0.03, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3)  # approach of each plate over the radius


def johnson(approach):
    """Force of Johnson's line contact for an approach per side: Contact Mechanics (1985), section 5.6."""
    compliance = (1 - POISSON**2) / (math.pi * YOUNG)

    def approach_of(force):
        half_width = math.sqrt(4 * force * RADIUS * compliance)
        return force * compliance * (2 * math.log(4 * RADIUS / half_width) - 1)

    low, high = 1.0, 1e5
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if approach_of(middle) < approach else (low, middle)
    return low


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/line_contact"),
                        help="for the output folders of the runs (default: %(default)s)")
    arguments = parser.parse_args()
    forces = {}
    for spacing in SPACINGS:
        # The corner of the mesh puts the centre of the disk at a place in its cell that no symmetry favours.
        changes = {"Mesh/Cell size": 2 * spacing * RADIUS, "Mesh/Lower": "-8e-3, -6e-3", "Mesh/Upper": "8e-3, 6e-3",
                   "Output/Fields every": "0.01"}
        _, rows = run(arguments.program, "verification/line_contact.prm", arguments.folder / f"xi-{spacing}", changes)
        forces[spacing] = {round(row["time_s"], 6): row["top_force_N_per_m"] for row in rows}
    print("| d/R | Johnson [N/m] | " + " | ".join(f"ξ = {spacing}" for spacing in SPACINGS) + " | 0.029 against 0.0145 |")
    print("|---" * (len(SPACINGS) + 3) + "|")
    for strain in STRAINS:
        exact = johnson(strain * RADIUS)
        cells = [f"{forces[s][strain]:.1f} ({100 * (forces[s][strain] / exact - 1):+.2f} %)" for s in SPACINGS]
        change = 100 * (forces[0.029][strain] / forces[0.0145][strain] - 1)
        print(f"| {strain} | {exact:.1f} | " + " | ".join(cells) + f" | {change:+.2f} % |")


if __name__ == "__main__":
    main()
