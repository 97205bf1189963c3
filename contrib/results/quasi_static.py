#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs gallery/thirty_grains_mpm.prm without inertia, ten packings, and prints the tables of
doc/results/quasi-static.md."""
import math

from running import parser_of, run

SEEDS = tuple(range(1, 11))
FRACTIONS = (0.80, 0.82, 0.84, 0.86, 0.88, 0.90, 0.92, 0.94)
WALLS = ("bottom", "top", "left", "right")
WIDTH = 10e-3  # of the box [m]
# The packings are loose enough for every seed.
LOOSE = {"Packing/Packing fraction": 0.70, "Stop/End time": 1, "Output/Fields every": 0, "Output/Snapshots every": 0}
STATIC = {"Time/Scheme": "quasi_static"}


def friction(coefficient):
    return {"Contact/Friction": coefficient, **{f"Walls/{wall}/Friction": coefficient for wall in WALLS}}


def at(rows, column, fraction):
    """@column of the history where the packing fraction first reaches @fraction."""
    for before, after in zip(rows, rows[1:]):
        if before["packing_fraction"] < fraction <= after["packing_fraction"]:
            share = (fraction - before["packing_fraction"]) / (after["packing_fraction"] - before["packing_fraction"])
            return before[column] + share * (after[column] - before[column])
    return math.nan


def stresses(rows):
    return [0.5 * (at(rows, "top_force_N_per_m", f) + at(rows, "bottom_force_N_per_m", f)) / WIDTH / 1e6 for f in FRACTIONS]


def line(name, summary, rows):
    steps = len(rows) - 1
    full = max(row["dt_s"] for row in rows)
    cut = sum(row["dt_s"] < 0.9 * full for row in rows[1:-1])
    newton = sum(row["newton_iterations"] for row in rows[1:])
    gave = most = 0.0
    for row in rows:
        # What contacts give in held steps is energy that is released with the wrong sign. What resists bodies in
        # a step takes energy that held steps give back.
        taken = row["contact_loss_J_per_m"] + row["released_energy_J_per_m"] + row["regularisation_work_J_per_m"]
        most = max(most, taken)
        gave = max(gave, most - taken)
    sides = abs(rows[-1]["top_force_N_per_m"] / rows[-1]["bottom_force_N_per_m"] - 1)
    return (f"| {name} | {rows[-1]['packing_fraction']:.4f} | {steps} | {cut} | {rows[-1]['held_steps']:.0f} | "
            f"{newton / steps:.1f} | {summary['wall_seconds']:.0f} | "
            f"{max(row['unbalanced_force'] for row in rows):.1e} | {sides:.0e} | {gave:.1e} | "
            f"{rows[-1]['elastic_energy_J_per_m']:.1f} | {summary['energy_balance_error']:.4f} |")


def main():
    parser = parser_of(__doc__, "quasi_static")
    parser.add_argument("--seeds", type=int, nargs="+", default=SEEDS)
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.5))
    parser.add_argument("--cell-sizes", type=float, nargs="+", default=(3.2e-4,), help="[m]")
    parser.add_argument("--to", type=float, default=0.95, help="packing fraction at which runs end")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    arguments = parser.parse_args()
    more = dict(item.split("=", 1) for item in arguments.set)
    counted, stress = [], []
    for cell in arguments.cell_sizes:
        for coefficient in arguments.friction:
            for seed in arguments.seeds:
                changes = {**LOOSE, **STATIC, **friction(coefficient), "Packing/Seed": seed, "Mesh/Cell size": cell,
                           "Stop/Packing fraction": arguments.to, **more}
                name = f"{seed}, μ = {coefficient}, h = {1e3 * cell:g} mm"
                folder = arguments.folder / f"seed-{seed}-friction-{coefficient}-cell-{cell}"
                summary, rows = run(arguments.program, "gallery/thirty_grains_mpm.prm", folder, changes, threads=1,
                                    again=False)
                counted.append(line(name, summary, rows))
                stress.append(f"| {name} | " + " | ".join("" if math.isnan(s) else f"{s:.4f}" for s in stresses(rows)) + " |")
                print(counted[-1], flush=True)
    print("\n| packing | to | steps | cut | held steps | Newton iterations a step | seconds | unbalanced force, at most | "
          "top over bottom less 1 | contact gave [J/m] | elastic [J/m] | energy balance |\n" + "|---" * 12 + "|")
    print("\n".join(counted))
    print("\nStress on the walls, mean of top and bottom [MPa]:\n\n| packing | " + " | ".join(f"Φ = {f:.2f}" for f in FRACTIONS) + " |\n"
          + "|---" * (len(FRACTIONS) + 1) + "|")
    print("\n".join(stress))


if __name__ == "__main__":
    main()
