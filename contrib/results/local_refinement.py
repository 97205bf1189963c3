#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Local refinement against uniform meshes, error and processor time: the tables of doc/results/line-contact.md."""
import math
import resource

from running import parser_of, run

CUTS = (0.0, 0.3, 0.6)  # of a cell by which the grid is moved: errors are root mean squares over them


def pressure(row):
    """Mean pressure of four plates on the box between them [Pa]."""
    sides = ("top", "bottom", "left", "right")
    return sum(row[f"{side}_force_N_per_m"] for side in sides) / 8 / row["top_position_m"]


# Scene, half width and height of the mesh, what to change, what is compared, over what, where, and the reference.
SCENES = {
    "Light line contact": ("line_contact.prm", (8e-3, 6e-3), {"Time/Time step": "1e-3", "Stop/End time": "0.03"},
                           lambda row: row["top_force_N_per_m"], "time_s", (0.002, 0.005, 0.01, 0.03),
                           ("quadratic", 3e-4, 3)),
    "Heavy line contact": ("line_contact.prm", (8e-3, 6e-3), {"Time/Time step": "1e-2"},
                           lambda row: row["top_force_N_per_m"], "time_s", (0.05, 0.1, 0.3), ("bspline", 1.5e-4, 0)),
    "Four plates": ("four_plates.prm", (6e-3, 6e-3), {"Time/Time step": "5e-3", "Stop/Packing fraction": "0.985"},
                    pressure, "packing_fraction", (0.85, 0.95, 0.98), ("bspline", 1.5e-4, 0)),
}
# Shape function, largest cells [m], levels.
MESHES = [(shape, cell, 0) for shape in ("bspline", "linear", "quadratic")
          for cell in (1.2e-3, 8.5e-4, 6e-4, 4.2e-4, 3e-4, 2.1e-4) if (shape, cell) != ("quadratic", 2.1e-4)]
MESHES += [("linear", 6e-4, 1), ("linear", 6e-4, 2), ("linear", 3e-4, 1)]
MESHES += [("quadratic", 1.2e-3, levels) for levels in (1, 2, 3)] + [("quadratic", 6e-4, 1), ("quadratic", 6e-4, 2)]
# Where contact becomes wide, steps are cut for such small cells, and runs take minutes.
LIGHT_ALONE = [("linear", 3e-4, 2), ("quadratic", 1.2e-3, 4)]


def settings(shape, cell, levels, half, cut):
    corner = lambda sign: ", ".join(repr((sign * (math.ceil(h / cell) + (sign > 0)) - cut) * cell) for h in half)
    changes = {"Mesh/Cell size": cell, "Mesh/Lower": corner(-1), "Mesh/Upper": corner(1), "Mesh/Refine near contact": levels,
               "Material points/Shape function": shape, "Output/Fields every": "0", "Output/Number of field outputs": "0"}
    return {**changes, **({"Material points/Points per direction": 3} if shape == "quadratic" else {})}


def value_at(rows, value, over, place):
    """What grows by a power between two rows of the history."""
    k = next(i for i, row in enumerate(rows) if row[over] > place * (1 - 1e-9))
    before, after = rows[k - 1], rows[k]
    if after[over] < place * (1 + 1e-9):
        return value(after)
    share = math.log(place / before[over]) / math.log(after[over] / before[over])
    return value(before) ** (1 - share) * value(after) ** share


def measure(program, folder, scene, mesh, cut):
    """Values, unknowns and processor time of one run."""
    name, half, changes, value, over, places, _ = SCENES[scene]
    output = folder / "-".join(str(word).replace(" ", "-") for word in (scene, *mesh, cut))
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    _, rows = run(program, "verification/" + name, output, {**changes, **settings(*mesh, half, cut)}, threads=1)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    unknowns = next(line.split()[1] for line in (output / "log").read_text(encoding="utf-8").splitlines()
                    if line.strip().startswith("unknowns"))
    return [value_at(rows, value, over, place) for place in places], int(unknowns), seconds


def main():
    parser = parser_of(__doc__, "local_refinement")
    parser.add_argument("--scenes", nargs="+", choices=SCENES, default=list(SCENES), help="which tables (default: all)")
    arguments = parser.parse_args()
    for scene in arguments.scenes:
        *_, over, places, best = SCENES[scene]
        reference, *_ = measure(arguments.program, arguments.folder, scene, best, CUTS[1])
        print(f"\n{scene}; reference {best}: " + ", ".join(f"{x:.6g}" for x in reference) + "\n")
        print("| shape function | cell [mm] | levels | unknowns | seconds | " + " | ".join(f"{over} {p}" for p in places) + " |")
        print("|---|---|---|---|---|" + "---|" * len(places))
        for mesh in MESHES + (LIGHT_ALONE if scene.startswith("Light") else []):
            values, unknowns, seconds = zip(*(measure(arguments.program, arguments.folder, scene, mesh, cut) for cut in CUTS))
            errors = [math.sqrt(sum((v[k] / reference[k] - 1) ** 2 for v in values) / len(CUTS)) for k in range(len(places))]
            print(f"| `{mesh[0]}` | {1e3 * mesh[1]:g} | {mesh[2]} | {unknowns[0]} | {sum(seconds) / len(CUTS):.2f} | " +
                  " | ".join(f"{100 * e:.2f} %" for e in errors) + " |", flush=True)


if __name__ == "__main__":
    main()
