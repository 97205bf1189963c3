#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thirty regular polygons with 5 to 8 corners at random angles, compacted without inertia: the scene is made from a packing
of disks that they are inscribed in. Prints the line of doc/results/quasi-static.md."""
import argparse
import math
import pathlib
import random

import quasi_static
from running import PARAMETERS, rows_of, softgrain

SCENE = PARAMETERS / "gallery" / "thirty_grains_mpm.prm"


def write_scene(program, folder, seed):
    """A parameter file with the polygons of packing @seed."""
    folder.mkdir(parents=True, exist_ok=True)
    table = folder / f"disks-{seed}.csv"
    softgrain.run(SCENE, set={**quasi_static.LOOSE, "Packing/Seed": seed, "Packing/Save to": str(table),
                              "Stop/End time": 1e-9, "Stop/Packing fraction": 0}, output=str(folder / "disks"),
                  program=str(program), overwrite=True)
    chance = random.Random(seed)
    names, sections = [], []
    for number, line in enumerate(table.read_text(encoding="utf-8").split()[1:]):
        x, y, radius = (float(word) for word in line.split(",")[:3])
        corners, angle = chance.randint(5, 8), chance.uniform(0, 2 * math.pi)
        places = [(x + radius * math.cos(angle + 2 * math.pi * k / corners), y + radius * math.sin(angle + 2 * math.pi * k / corners))
                  for k in range(corners)]
        names.append(f"grain{number}")
        vertices = "; ".join(f"{px:.8g}, {py:.8g}" for px, py in places)
        sections.append(f"  subsection {names[-1]}\n    set Shape    = polygon\n    set Vertices = {vertices}\n  end\n")
    text = SCENE.read_text(encoding="utf-8")
    before, rest = text.split("subsection Packing\n", 1)
    after = rest.split("end\n", 1)[1]
    scene = folder / f"polygons-{seed}.prm"
    scene.write_text(before + f"subsection Bodies\n  set Names = {', '.join(names)}\n" + "".join(sections) + "end\n" + after,
                     encoding="utf-8")
    return scene


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/polygons"),
                        help="for the scenes and the output folders of the runs (default: %(default)s)")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1,))
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.5))
    arguments = parser.parse_args()
    for seed in arguments.seeds:
        scene = write_scene(arguments.program, arguments.folder, seed)
        for friction in arguments.friction:
            changes = {name: value for name, value in quasi_static.LOOSE.items() if not name.startswith("Packing/")}
            folder = arguments.folder / f"seed-{seed}-friction-{friction}"
            found = softgrain.run(scene, set={**changes, **quasi_static.STATIC, **quasi_static.friction(friction)},
                                  output=str(folder), threads=1, program=str(arguments.program), overwrite=True, verbose=True)
            rows = rows_of(found)
            print(quasi_static.line(f"{seed}, μ = {friction}", found.summary, rows))


if __name__ == "__main__":
    main()
