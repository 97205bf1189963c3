#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thirty grains from loose to .95 at rest: packings, friction, shapes, and soft grains between ones a hundred times harder. Does each run end,
and what do its steps cost? The table of doc/results/contact-geometry.md."""
import itertools
import statistics

from quasi_static import LOOSE, friction
from running import RunFailed, parser_of, rows_of, run, softgrain

SCENE = "gallery/thirty_grains_quasi_static_mpm.prm"
HARD = {"Materials/Names": "gel, stone", "Materials/stone/Law": "neo_hookean", "Materials/stone/Density": 990,
        "Materials/stone/Neo-Hookean/Young's modulus": 10e8, "Materials/stone/Neo-Hookean/Poisson's ratio": 0.45,
        "Packing/Classes": "0.5: 1.4e-3 to 2.4e-3, stone; 0.5: 1.4e-3 to 2.4e-3, gel"}
KINDS = {"disks": {}, "ellipses": {"Packing/Shapes": "ellipse", "Packing/Aspect ratio": "0.5, 0.9"},
         "polygons": {"Packing/Shapes": "polygon", "Packing/Corners": "5, 8"}, "hard and soft disks": HARD}


def found_of(program, folder, kind, coefficient, seed, more, limit):
    """(rows of the history, why the run ended early or None)"""
    changes = {**LOOSE, **friction(coefficient), **KINDS[kind], "Packing/Seed": seed, **more}
    place = folder / f"{kind.replace(' ', '-')}-{coefficient:g}-{seed}"
    try:
        _, rows = run(program, SCENE, place, changes, threads=1, limit=limit, again=False)
        return rows, None
    except RunFailed as error:
        return rows_of(softgrain.open(place)), str(error).strip().rsplit("\n", maxsplit=1)[-1]


def summary(kind, coefficient, found):
    """One line: what @found, the runs of all packings, have in common."""
    ended = [rows for rows, trouble in found.values() if trouble is None]
    line = f"| {kind} | {coefficient:g} | {len(ended)} of {len(found)} "
    if ended:
        means = [sum(row["newton_iterations"] for row in rows) / (len(rows) - 1) for rows in ended]
        worst = [max(row["newton_iterations"] for row in rows) for rows in ended]
        cut = [sum(row["dt_s"] < 0.9 * max(row["dt_s"] for row in rows) for row in rows[1:-1]) for rows in ended]
        steps = [len(rows) - 1 for rows in ended]
        balance = [max(row["unbalanced_force"] for row in rows) for rows in ended]
        missing = [abs(1 - (rows[-1]["kinetic_energy_J_per_m"] + rows[-1]["elastic_energy_J_per_m"] + rows[-1]["dissipated_energy_J_per_m"])
                       / rows[-1]["external_work_J_per_m"]) for rows in ended]
        line += (f"| {min(steps)} to {max(steps)} | {statistics.median(means):.1f}, {max(means):.1f} "
                 f"| {statistics.median(worst):.0f}, {max(worst):.0f} | {max(cut)} | {max(balance):.1e} "
                 f"| {100 * statistics.median(missing):.2f}, {100 * max(missing):.2f} |")
    return line


def main():
    parser = parser_of(__doc__, "seeds_and_shapes")
    parser.add_argument("--seeds", type=int, nargs="+", default=range(1, 9))
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.1, 0.5, 1.0))
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS))
    parser.add_argument("--limit", type=float, default=600, help="seconds a run may take")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    arguments = parser.parse_args()
    more = dict(item.split("=", 1) for item in arguments.set)
    print("| grains | friction | ended | steps | iterations a step: median, most | worst step: median, most | steps that are cut, at most "
          "| unbalanced force, at most | energy missing, %: median, most |\n" + "|---" * 9 + "|", flush=True)
    for kind, coefficient in itertools.product(arguments.kinds, arguments.friction):
        found = {seed: found_of(arguments.program, arguments.folder, kind, coefficient, seed, more, arguments.limit)
                 for seed in arguments.seeds}
        print(summary(kind, coefficient, found), flush=True)
        for seed, (rows, trouble) in found.items():
            if trouble:
                print(f"|   | seed {seed} | at {rows[-1]['packing_fraction']:.3f}: {trouble} |", flush=True)


if __name__ == "__main__":
    main()
