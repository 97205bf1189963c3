#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a grid misses of the dent of a sphere between two plates: the numbers behind the sub-grid law of doc/results/three-dimensions.md.

The sphere is pressed without that law. At the forces of finite elements the grid's travel is less than theirs, by the dent
that it misses. The table holds x = a/h, with Hertz's radius of contact a, and f = δ E* h/F, at every travel of a plate."""
import math

import numpy as np
from running import parser_of, run
from sphere_between_plates import ELEMENTS, RADIUS, SCENE, YOUNG, changes_of


def missed(program, folder, poisson, cells, cut, more):
    """[(travel over radius, x, f)] of one cut of the grid, and the cosines of the place in its cell."""
    h = RADIUS / cells
    changes = {**changes_of(poisson, cells, cut, 0.3), "Time/Wall way": 0.04, "Contact/Sub-grid compliance": "false", **more}
    _, rows = run(program, SCENE, folder / f"{poisson}-{cells:g}-{cut:.2f}", changes, threads=1, again=False)
    travel = np.array([row["time_s"] for row in rows])
    force = np.array([row["top_force_N"] for row in rows])
    pressed = (force > 0) & (travel > 0)
    modulus = YOUNG / (1 - poisson**2)
    found = []
    for at, scaled in ELEMENTS[poisson].items():
        load = scaled * YOUNG * RADIUS**2
        if force[pressed][0] < load < force[-1]:
            of_grid = math.exp(np.interp(math.log(load), np.log(force[pressed]), np.log(travel[pressed])))
            radius = (0.75 * load * RADIUS / modulus) ** (1 / 3)
            found.append((at, radius / h, (at - of_grid) * RADIUS * modulus * h / load))
    low = 1.1 + cut + cells
    waves = 0.5 * sum(math.cos(2 * math.pi * place) for place in (low, low - 0.3 * cut))
    return found, waves


def main():
    parser = parser_of(__doc__, "dent_of_a_sphere")
    parser.add_argument("--poisson", type=float, nargs="+", default=(0.45, 0.30), choices=tuple(ELEMENTS))
    parser.add_argument("--cells", type=float, nargs="+", default=(3, 4), help="in the radius")
    parser.add_argument("--cuts", type=int, default=5, help="their number")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of the scene")
    arguments = parser.parse_args()
    more = dict(text.split("=", 1) for text in arguments.set)
    for poisson in arguments.poisson:
        for cells in arguments.cells:
            for k in range(arguments.cuts):
                found, waves = missed(arguments.program, arguments.folder, poisson, cells, k / arguments.cuts, more)
                columns = " | ".join(f"{at}: x {x:.3f}, f {f:+.3f}" for at, x, f in found)
                print(f"| {poisson}, {cells:g}, cosines {waves:+.2f} | {columns} |", flush=True)


if __name__ == "__main__":
    main()
