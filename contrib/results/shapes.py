#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ellipses and regular polygons against disks: thirty grains of gallery/thirty_grains_quasi_static_mpm.prm compacted from a
packing fraction of 0.60, the table of doc/results/laws.md."""

from quasi_static import at
from running import RunFailed, parser_of, read_run, run

SHAPES = {"disks": {"Packing/Shapes": "disk"},
          "ellipses, 0.7": {"Packing/Shapes": "ellipse", "Packing/Aspect ratio": "0.7, 0.7"},
          "ellipses, 0.5": {"Packing/Shapes": "ellipse", "Packing/Aspect ratio": "0.5, 0.5"},
          "octagons": {"Packing/Shapes": "polygon", "Packing/Corners": "8, 8", "Packing/Aspect ratio": "1, 1"},
          "pentagons": {"Packing/Shapes": "polygon", "Packing/Corners": "5, 5", "Packing/Aspect ratio": "1, 1"}}
FRACTIONS = (0.80, 0.84, 0.88, 0.92)


def main():
    parser = parser_of(__doc__, "shapes")
    parser.add_argument("--shapes", nargs="+", choices=SHAPES, default=list(SHAPES))
    parser.add_argument("--seeds", type=int, nargs="+", default=(1,))
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    arguments = parser.parse_args()
    more = dict(item.split("=", 1) for item in arguments.set)
    print("| shape | seed | to | steps | " + " | ".join(f"σ [MPa], Z at {f:.2f}" for f in FRACTIONS) + " |\n"
          + "|---" * (4 + len(FRACTIONS)) + "|", flush=True)
    for shape in arguments.shapes:
        for seed in arguments.seeds:
            folder = arguments.folder / f"{shape.replace(', ', '-')}-{seed}"
            changes = {"Packing/Packing fraction": 0.6, "Packing/Seed": seed, "Stop/Packing fraction": 0.93, "Stop/End time": 1,
                       "Output/Fields every": 0, "Output/Snapshots every": 0, **SHAPES[shape], **more}
            try:
                run(arguments.program, "gallery/thirty_grains_quasi_static_mpm.prm", folder, changes, threads=1, again=False)
                end = ""
            except RunFailed as error:
                end = f" ended early: {str(error).splitlines()[-1]}"
            rows = read_run(folder)[1]
            cells = []
            for fraction in FRACTIONS:
                stress = (at(rows, "top_force_N_per_m", fraction) + at(rows, "bottom_force_N_per_m", fraction)) / 2 / 10e-3 / 1e6
                cells.append(f"{stress:.3f}, {at(rows, 'coordination', fraction):.2f}")
            print(f"| {shape} | {seed} | {rows[-1]['packing_fraction']:.3f}{end} | {len(rows) - 1} | " + " | ".join(cells) + " |",
                  flush=True)


if __name__ == "__main__":
    main()
