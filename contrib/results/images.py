#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Compacts ten disks, their image in a mirror, turned by 90 degrees and moved by whole cells, and prints how far grains are from
the image of themselves (doc/results/extremes.md). A control, one grain moved by 1e-9 cells, shows where the packing itself parts.
"""
import csv
import math

from running import parser_of, run, softgrain

CELL = 3.2e-4
WIDTH, HEIGHT = 5.8e-3, 7e-3  # of the box [m]
MESH = (-3 * CELL, 24 * CELL)   # lower and upper in both directions [m]
SCENE = "gallery/thirty_grains_mpm.prm"
TIGHT = {"Newton/Displacement tolerance": 1e-9, "Newton/Residual tolerance": 1e-9, "Newton/Energy tolerance": 1e-16,
         "Newton/Maximum iterations": 60, "Contact/Tolerance": 1e-10}
SCHEMES = {"quasi_static": {"Walls/top/Velocity": 1, "Time/Wall way": 0.1, "Output/Snapshots every": 3.2e-5},
           "moreau_jean": {"Walls/top/Velocity": 5, "Time/CFL multiple": 4, "Output/Snapshots every": 6.4e-6}}
WALLS = {"bottom": ((0., 0.), (0., 1.)), "top": ((0., HEIGHT), (0., -1.)), "left": ((0., 0.), (1., 0.)),
         "right": ((WIDTH, 0.), (-1., 0.))}
IMAGES = {"mirrored": (((-1, 0), (0, 1)), (0, 0)), "turned": (((0, -1), (1, 0)), (0, 0)),
          "moved by cells": (((1, 0), (0, 1)), (7, -3))}
SAME = (((1, 0), (0, 1)), (0, 0))
COLUMNS = (*IMAGES, "control")
FRACTIONS = (0.70, 0.75, 0.80, 0.85, 0.90, 0.95)


def image_of(image, place):
    matrix, cells = image
    return [matrix[d][0] * place[0] + matrix[d][1] * place[1] + CELL * cells[d] for d in range(2)]


def pair(values):
    return ", ".join(repr(float(value)) for value in values)


def scene_of(image, table):
    """Settings of the image of the box, filled with the grains of @table."""
    matrix, _ = image
    corners = [image_of(image, corner) for corner in ((MESH[0], MESH[0]), (MESH[1], MESH[1]))]
    settings = {"Mesh/Cell size": CELL, "Mesh/Lower": pair(map(min, *corners)), "Mesh/Upper": pair(map(max, *corners)),
                "Packing/Number": 0, "Packing/Method": "file", "Packing/File": table.resolve()}
    for name, (point, normal) in WALLS.items():
        settings[f"Walls/{name}/Point"] = pair(image_of(image, point))
        settings[f"Walls/{name}/Normal"] = pair(matrix[d][0] * normal[0] + matrix[d][1] * normal[1] for d in range(2))
    return settings


def write_table(path, grains):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(("x_m", "y_m", "radius_m"))
        writer.writerows([repr(value) for value in grain] for grain in grains)


def centers(folder):
    return {round(state.time, 12): state.bodies.center_m for state in softgrain.open(folder)}


def largest_distance(image, before, after):
    return max(math.dist(image_of(image, a), b) for a, b in zip(before, after)) / CELL


def first_grains(program, folder, seed):
    """Ten disks of a packing that the program makes."""
    table = folder / f"packing-{seed}.csv"
    changes = {"Packing/Number": 10, "Packing/Seed": seed, "Packing/Upper": f"{WIDTH}, {HEIGHT}",
               "Packing/Save to": table.resolve(), "Walls/top/Point": f"0, {HEIGHT}", "Walls/right/Point": f"{WIDTH}, 0",
               "Stop/End time": 1e-9, "Output/Fields every": 0, "Output/Snapshots every": 0}
    run(program, SCENE, folder / f"packing-{seed}", changes, threads=1, again=False)
    with open(table, newline="", encoding="utf-8") as file:
        return [[float(row[name]) for name in ("x_m", "y_m", "radius_m")] for row in csv.DictReader(file)]


def distances(program, folder, seed, scheme, friction, more):
    """Of each snapshot the packing fraction, and for each of COLUMNS the largest distance of a grain from where it should be [cells]."""
    grains = first_grains(program, folder, seed)
    states, rows = {}, None
    for name in ("scene", *COLUMNS):
        image = IMAGES.get(name, SAME)
        of_image = [[*image_of(image, grain[:2]), grain[2]] for grain in grains]
        if name == "control":
            of_image[4][0] += 1e-9 * CELL
        where = folder / f"{scheme}-{friction}-{seed}-{name.replace(' ', '-')}"
        table = where.with_suffix(".csv")
        write_table(table, of_image)
        changes = {**TIGHT, "Time/Scheme": scheme, **SCHEMES[scheme], **scene_of(image, table), "Contact/Friction": friction,
                   **{f"Walls/{wall}/Friction": friction for wall in WALLS}, "Stop/End time": 1, "Stop/Packing fraction": 0.93,
                   "Output/Fields every": 0, **more}
        _, history = run(program, SCENE, where, changes, threads=1, again=False)
        rows = rows or history
        states[name] = centers(where)
    fractions = {round(row["time_s"], 12): row["packing_fraction"] for row in rows}
    for time in sorted(states["scene"]):
        if all(time in states[name] for name in COLUMNS):
            yield fractions[time], [largest_distance(IMAGES.get(name, SAME), states["scene"][time], states[name][time])
                                    for name in COLUMNS]


def main():
    parser = parser_of(__doc__, "images")
    parser.add_argument("--schemes", nargs="+", default=tuple(SCHEMES), choices=SCHEMES)
    parser.add_argument("--seeds", type=int, nargs="+", default=(1,))
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.5))
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    more = dict(item.split("=", 1) for item in arguments.set)
    print("| scheme, friction, packing | Φ up to | " + " | ".join(COLUMNS) + " |\n|" + "---|" * (2 + len(COLUMNS)))
    for scheme in arguments.schemes:
        for friction in arguments.friction:
            for seed in arguments.seeds:
                rows = list(distances(arguments.program, arguments.folder, seed, scheme, friction, more))
                for low, high in zip((0, *FRACTIONS), FRACTIONS):
                    found = [apart for fraction, apart in rows if low <= fraction < high]
                    if found:
                        print(f"| {scheme}, {friction:g}, {seed} | {high:.2f} | " + " | ".join(f"{max(x):.0e}" for x in zip(*found)) + " |",
                              flush=True)


if __name__ == "__main__":
    main()
