#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grains of two laws of which one takes longer, on several ranks: the processor seconds of the busiest rank, and the bodies that have
moved, as the log tells them; figures of doc/ranks.md. Takes a minute for each program that is named."""
import argparse
import os
import pathlib
import shutil
import subprocess

from running import PARAMETERS

SCENE = "gallery/thirty_grains_mpm.prm"
COLUMNS, DEAR, DIAMETER, MARGIN = 12, 3, 1.9e-3, 1e-4  # grains side by side, of which so many with the law that takes longer


def changes(table):
    """Of the scene; writes the grains to @p table."""
    side = COLUMNS * DIAMETER + 2 * MARGIN
    places = [(i + 0.5) * DIAMETER + MARGIN for i in range(COLUMNS)]
    grains = [f"{x},{y},0.93e-3,{'clay' if i < DEAR else 'gel'}" for i, x in enumerate(places) for y in places]
    table.write_text("\n".join(["x_m,y_m,radius_m,material", *grains]) + "\n")
    end = side + 1e-3
    return {"Mesh/Upper": f"{end}, {end}", "Packing/Number": 0, "Packing/File": table.resolve(), "Packing/Upper": "1, 1",
            "Materials/Names": "gel, clay", "Materials/clay/Law": "j2_plastic", "Materials/clay/Density": 990,
            "Walls/top/Point": f"0, {side}", "Walls/right/Point": f"{side}, 0", "Walls/top/Velocity": 10,
            "Output/Fields every": 0, "Output/Snapshots every": 0, "Stop/End time": 4e-4}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("programs", nargs="+", help="build/release/bin/softgrain, and others to compare it with")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("output/uneven_ranks"), help="default: %(default)s")
    parser.add_argument("--ranks", type=int, default=2, help="default: %(default)s")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    sets = [word for name, value in changes(arguments.folder / "grains.csv").items() for word in ("--set", f"{name}={value}")]
    for program in arguments.programs:
        output = arguments.folder / "run"
        shutil.rmtree(output, ignore_errors=True)
        subprocess.run(["mpirun", "--oversubscribe", "-n", str(arguments.ranks), program, "run", PARAMETERS / SCENE, "--threads", "1",
                        "--output", output, *sets], check=True, stdout=subprocess.DEVNULL, timeout=600,
                       env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
        print(program)
        for line in (output / "run.log").read_text().splitlines():
            if "have moved" in line or "processor seconds of a rank" in line:
                print("  " + line.strip())


if __name__ == "__main__":
    main()
