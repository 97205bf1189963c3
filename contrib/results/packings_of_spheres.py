#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random packings of balls in a box of six walls, pressed from all sides until the balls at rest would fill .95 of it: how far each
comes, and what it costs. The tables of doc/results/three-dimensions.md."""
import itertools
import resource
import time

from running import ROOT, RunFailed, parser_of, rows_of, softgrain

SCENE = ROOT / "contrib" / "results" / "twenty_seven_spheres.prm"
DIAMETER, SPEED, FULL = 10e-3, 1e-3, 0.95  # mean [m], of each wall [m/s], volume at rest over that of the box at the end
NORMALS = {"left": 0, "front": 1, "bottom": 2, "right": 0, "back": 1, "top": 2}


def changes_of(number, seed, friction, fraction, cells):
    """Parameters of a run: a cube that @number balls fill by @fraction, to the time at which they would fill FULL."""
    edge = DIAMETER * (number * 3.14159265 / 6 / fraction) ** (1 / 3)
    last = edge * (fraction / FULL) ** (1 / 3)
    far = {name: ", ".join(f"{edge:.7g}" if d == NORMALS[name] else "0" for d in range(3)) for name in ("right", "back", "top")}
    return {"Packing/Number": number, "Packing/Seed": seed, "Packing/Packing fraction": fraction,
            "Packing/Upper": f"{edge:.7g}, {edge:.7g}, {edge:.7g}", **{f"Walls/{name}/Point": point for name, point in far.items()},
            "Mesh/Lower": "-0.1e-3, -0.1e-3, -0.1e-3", "Mesh/Upper": ", ".join([f"{edge + 1e-4:.7g}"] * 3),
            "Mesh/Cell size": 0.5 * DIAMETER / cells, "Contact/Friction": friction, "Contact/Friction at walls": "same",
            "Stop/End time": f"{0.5 * (edge - last) / SPEED:.5g}", "Output/Number of field outputs": 0}


def row(program, folder, number, seed, friction, arguments):
    """One row of the table."""
    name = f"{number}-{seed}-{friction:g}"
    changes = {**changes_of(number, seed, friction, arguments.fraction, arguments.cells),
               **dict(text.split("=", 1) for text in arguments.set)}
    begin, used, trouble = time.time(), resource.getrusage(resource.RUSAGE_CHILDREN), "to its end"
    try:
        softgrain.run(str(SCENE), set=changes, output=str(folder / name), threads=arguments.threads, program=str(program),
                      timeout=arguments.limit, overwrite=True, verbose=True)
    except RunFailed as error:
        trouble = str(error).strip().rsplit("\n", maxsplit=1)[-1]
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    rows = rows_of(softgrain.open(folder / name))
    last, walls = rows[-1], [rows[-1][f"{wall}_force_N"] for wall in NORMALS]
    edge = [last[f"{b}_position_m"] - last[f"{a}_position_m"] for a, b in (("left", "right"), ("front", "back"), ("bottom", "top"))]
    pressure = sum(force / (edge[0] * edge[1] * edge[2] / edge[NORMALS[wall]]) for wall, force in zip(NORMALS, walls)) / 6
    booked = last["kinetic_energy_J"] + last["elastic_energy_J"] + last["dissipated_energy_J"]
    missing = 1 - booked / last["external_work_J"]
    return (f"| {number}, seed {seed}, mu {friction:g} | {last['packing_fraction']:.3f} | {len(rows) - 1} "
            f"| {sum(entry['newton_iterations'] for entry in rows):.0f} | {time.time() - begin:.0f} "
            f"| {now.ru_utime - used.ru_utime:.0f} | {now.ru_maxrss / 1e6:.2f} | {last['coordination']:.2f} "
            f"| {pressure / 10e6:.4f} | {100 * missing:.2f} | {trouble} |")


def main():
    parser = parser_of(__doc__, "packings_of_spheres")
    parser.add_argument("--number", type=int, nargs="+", default=(27,))
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3, 4, 5))
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.5))
    parser.add_argument("--fraction", type=float, default=0.5, help="packing fraction at the start")
    parser.add_argument("--cells", type=float, default=3.03, help="in the mean radius")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--limit", type=float, default=3600, help="seconds a run may take")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of the scene")
    arguments = parser.parse_args()
    print("| balls | packing fraction | steps | iterations | s | processor s | GB | Z | p/E | work missing, % | |\n" + "|---" * 11 + "|")
    for number, seed, friction in itertools.product(arguments.number, arguments.seeds, arguments.friction):
        print(row(arguments.program, arguments.folder, number, seed, friction, arguments), flush=True)


if __name__ == "__main__":
    main()
