#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Force of a sphere between two plates on grids of several sizes and cuts, against axisymmetric finite elements: the tables of
doc/results/three-dimensions.md."""
import itertools
import statistics

from running import parser_of, run

SCENE = "verification/sphere_between_plates.prm"
YOUNG, RADIUS = 10e6, 5e-3  # of the scene [Pa, m]
CUTS = (0.0, 0.2, 0.4, 0.6, 0.8)  # shift of the grid [cells]
# F/(E R^2) at travels of each plate over R: 1200 quadratic axisymmetric elements (a coarser mesh agrees within .3 %).
ELEMENTS = {
    0.30: {0.02: 0.00445107, 0.04: 0.0128935, 0.1: 0.0552029, 0.2: 0.174068, 0.3: 0.360371, 0.4: 0.642018, 0.5: 1.08895},
    0.45: {0.01: 0.00174435, 0.02: 0.00499513, 0.05: 0.0205799, 0.1: 0.0611559, 0.2: 0.191906, 0.3: 0.399657, 0.4: 0.725853,
           0.5: 1.26813},
}


def changes_of(poisson, cells, cut, last):
    """Parameters of a run with @cells in the radius, on a grid that is shifted by @cut cells."""
    h = RADIUS / cells
    low = -RADIUS - (1.1 + cut) * h
    return {"Mesh/Cell size": h, "Mesh/Lower": f"{low}, {low + 0.3 * cut * h}, {low + RADIUS}",
            "Mesh/Upper": f"{-low}, {-low}, {RADIUS - low + h}", "Stop/End time": last,
            "Materials/gel/Neo-Hookean/Poisson's ratio": poisson, "Output/Number of field outputs": 0,
            "Output/Fields every": 0.01, "Output/Field parts": "contacts", "Walls/top/Velocity": 2 * RADIUS}


def forces(program, folder, poisson, cells, cut, last, more):
    """{travel: F/(E R^2)} of one run, and its summary."""
    changes = {**changes_of(poisson, cells, cut, last), "Time/Wall way": 0.1, **more}
    summary, rows = run(program, SCENE, folder / f"{poisson}-{cells:g}-{cut}", changes, threads=1, again=False)
    return {at: min(rows, key=lambda row: abs(row["time_s"] - at))["top_force_N"] / (YOUNG * RADIUS**2)
            for at in ELEMENTS[poisson] if at <= last + 1e-9}, summary


def main():
    parser = parser_of(__doc__, "sphere_between_plates")
    parser.add_argument("--poisson", type=float, nargs="+", default=(0.45, 0.30), choices=tuple(ELEMENTS))
    parser.add_argument("--cells", type=float, nargs="+", default=(3, 4, 6), help="in the radius")
    parser.add_argument("--cuts", type=float, nargs="+", default=CUTS, help="shifts of the grid in cells")
    parser.add_argument("--last", type=float, default=0.3, help="travel of each plate over the radius")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of the scene")
    arguments = parser.parse_args()
    more = dict(text.split("=", 1) for text in arguments.set)
    for poisson, cells in itertools.product(arguments.poisson, arguments.cells):
        found, seconds = [], []
        for cut in arguments.cuts:
            force, summary = forces(arguments.program, arguments.folder, poisson, cells, cut, arguments.last, more)
            found.append(force)
            seconds.append(summary["wall_seconds"])
        columns = []
        for at in found[0]:
            errors = [100 * (force[at] / ELEMENTS[poisson][at] - 1) for force in found]
            columns.append(f"{at}: {statistics.fmean(errors):+.1f} [{min(errors):+.1f}, {max(errors):+.1f}]")
        print(f"| {poisson}, {cells:g} | " + " | ".join(columns) + f" | {statistics.median(seconds):.1f} s |", flush=True)


if __name__ == "__main__":
    main()
