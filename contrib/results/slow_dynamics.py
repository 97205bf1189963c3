#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs gallery/thirty_grains_mpm.prm with inertia and walls from 5 to 0.05 m/s, five packings, and prints the table of
doc/results/quasi-static.md."""
import argparse
import pathlib

from quasi_static import LOOSE, at, friction
from running import run

SPEEDS = {5: 4, 1: 20, 0.2: 100, 0.05: 400}  # velocity of the wall [m/s]: length of a step [CFL steps]
FRACTIONS = (0.84, 0.90, 0.94)


def line(name, summary, rows):
    steps = len(rows) - 1
    full = max(row["dt_s"] for row in rows)
    cut = sum(row["dt_s"] < 0.9 * full for row in rows[1:-1])
    gave = most = 0.0
    spin_loose = spin = 0.0
    for row in rows:
        most = max(most, row["contact_loss_J_per_m"])
        gave = max(gave, most - row["contact_loss_J_per_m"])
        share = row["rotational_energy_J_per_m"] / max(row["kinetic_energy_J_per_m"], 1e-30)
        if row["packing_fraction"] < 0.80:
            spin_loose = max(spin_loose, share)
        else:
            spin = max(spin, share)
    last = rows[-1]
    work = last["elastic_energy_J_per_m"] + last["kinetic_energy_J_per_m"] + last["dissipated_energy_J_per_m"]
    sides = [f"{at(rows, 'top_force_N_per_m', f) / 1e4:.3f} / {at(rows, 'bottom_force_N_per_m', f) / 1e4:.3f}" 
             for f in FRACTIONS]
    return (f"| {name} | {steps} | {cut} | {summary['wall_seconds']:.1f} | "
            f"{gave / work:.1e} | {summary['energy_balance_error']:.4f} | {spin_loose:.1e}, {spin:.1e} | " + " | ".join(sides) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/slow_dynamics"),
                        help="for the output folders of the runs (default: %(default)s)")
    parser.add_argument("--seeds", type=int, nargs="+", default=range(1, 6))
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.5))
    options = parser.parse_args()
    print("| run | steps | cut | seconds | contact gave / work | energy balance | rotational / kinetic energy below .80, above | "
          + " | ".join(f"top / bottom [MPa] at {f:.2f}" for f in FRACTIONS) + " |")
    print("|" + "---|" * (7 + len(FRACTIONS)))
    for coefficient in options.friction:
        for speed, multiple in SPEEDS.items():
            for seed in options.seeds:
                name = f"{speed} m/s, μ = {coefficient}, packing {seed}"
                changes = {**LOOSE, "Packing/Seed": seed, "Walls/top/Velocity": speed, "Time/CFL multiple": multiple}
                if coefficient > 0:
                    changes.update(friction(coefficient))
                print(line(name, *run(options.program, "gallery/thirty_grains_mpm.prm",
                                      options.folder / f"{speed}-{coefficient}-{seed}", changes, threads=1)),
                      flush=True)


if __name__ == "__main__":
    main()
