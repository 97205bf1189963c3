#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Force of a disk between two plates on coarse and fine grids, five cuts of each, against Johnson's line contact up to
d/R = 0.02 and the finest grid beyond: the table of doc/results/line-contact.md."""
import math
import statistics

from running import parser_of, run, softgrain
from subgrid import CUTS, RADIUS, YOUNG, mesh

APPROACHES = (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3)  # of a plate over the radius
FINEST = 0.0145
JOHNSON = 0.02  # up to here his force is that of finite elements


def forces(program, folder, spacing, cut, poisson):
    """{approach: force} of one run [N/m]; its time is the approach."""
    changes = {**mesh(2 * spacing * RADIUS, cut), "Time/Time step": 5e-3, "Stop/End time": max(APPROACHES),
               "Materials/gel/Neo-Hookean/Poisson's ratio": poisson, "Output/Number of field outputs": 0}
    _, rows = run(program, "verification/line_contact.prm", folder, changes, threads=1, again=False)
    return {at: min(rows, key=lambda row: abs(row["time_s"] - at))["top_force_N_per_m"] for at in APPROACHES}


def main():
    parser = parser_of(__doc__, "light_contact")
    parser.add_argument("--spacings", type=float, nargs="+", default=(0.17, 0.10, 0.029), help="of points over the radius")
    arguments = parser.parse_args()
    print("| ν, ξ | " + " | ".join(f"d/R = {at}" for at in APPROACHES) + " |\n" + "|---" * (1 + len(APPROACHES)) + "|")
    for poisson in (0.30, 0.45, 0.49):
        fine = forces(arguments.program, arguments.folder / f"{poisson}-{FINEST}", FINEST, 0.0, poisson)
        reference = {at: softgrain.theory.johnson(-math.log(1 - at), YOUNG, poisson, RADIUS) if at <= JOHNSON else fine[at]
                     for at in APPROACHES}
        for spacing in arguments.spacings:
            found = [forces(arguments.program, arguments.folder / f"{poisson}-{spacing}-{cut}", spacing, cut, poisson) for cut in CUTS]
            cells = []
            for at in APPROACHES:
                errors = [100 * (force[at] / reference[at] - 1) for force in found]
                cells.append(f"{statistics.fmean(errors):+.1f} [{min(errors):.1f}, {max(errors):.1f}]")
            print(f"| {poisson}, {spacing} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
