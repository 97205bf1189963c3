#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Force of the punch and mean pressure on the tube of a sphere in a die, against axisymmetric finite elements: a table of
doc/results/three-dimensions.md."""
import math

from running import parser_of, run, softgrain

SCENE = "verification/sphere_in_a_die.prm"
YOUNG, RADIUS = 10e6, 5e-3  # of the scene [Pa, m]
# Travel of each punch over R: F/(E R^2), p/E on the tube, of 1200 quadratic axisymmetric elements.
ELEMENTS = {0.03: (0.00961686, 0.000489076), 0.06: (0.0287824, 0.00176036), 0.09: (0.0556904, 0.00397614),
            0.12: (0.0910434, 0.00741798), 0.15: (0.135217, 0.0124414), 0.18: (0.190397, 0.0195965), 0.21: (0.258546, 0.0296456),
            0.24: (0.344112, 0.0439304), 0.27: (0.454328, 0.0644672), 0.3: (0.598398, 0.0943843), 0.33: (0.794571, 0.13908), 0.36: (1.0699, 0.206993)}
TUBE = 2  # after the two walls


def main():
    parser = parser_of(__doc__, "sphere_in_a_die")
    parser.add_argument("--cells", type=float, default=4, help="in the radius")
    arguments = parser.parse_args()
    folder = arguments.folder / f"{arguments.cells:g}"
    run(arguments.program, SCENE, folder, {"Mesh/Cell size": RADIUS / arguments.cells, "Output/Number of field outputs": 0,
                                           "Output/Fields every": 0.1, "Stop/End time": 1.2, "Output/Field parts": "contacts"}, threads=1, again=False)
    print("| d/R | force, % | pressure on the tube, % |\n|---|---|---|")
    for state in softgrain.open(folder):
        travel = 0.3 * state.time  # of each punch over the radius
        right = next((value for key, value in ELEMENTS.items() if abs(key - travel) < 1e-6), None)
        if right is None:
            continue
        force, wall = state.contacts["normal_force_N"], state.contacts["wall"]
        punch = force[wall == 1].sum() / (YOUNG * RADIUS**2)
        area = 2 * math.pi * RADIUS * 2 * RADIUS * (1 - travel)
        tube = force[wall == TUBE].sum() / area / YOUNG
        print(f"| {travel:.2f} | {100 * (punch / right[0] - 1):+.1f} | {100 * (tube / right[1] - 1):+.1f} |")


if __name__ == "__main__":
    main()
