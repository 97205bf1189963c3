#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction between bonded grains with and without rolling resistance of their primaries, for doc/results/bonded.md.

Compacts gallery/thirty_grains_bpm.prm (or more grains of the same sizes) for every friction, rolling resistance and seed, and
prints stress, coordination, anisotropy of orientation and what a run took. Writes the means to a CSV file."""
import argparse
import csv
import math
import pathlib
import resource
import statistics

from running import run, softgrain

FRACTIONS = (0.80, 0.85, 0.90)
COLUMNS = ("coordination", "orientation_anisotropy")


def changes(grains, friction, rolling, seed, coarse, velocity):
    side = math.sqrt(grains / 30)
    made = {
        "Packing/Number": grains, "Packing/Seed": seed, "Packing/Upper": f"{10e-3 * side}, {11.4e-3 * side}",
        "Walls/top/Point": f"0, {11.4e-3 * side}", "Walls/right/Point": f"{10e-3 * side}, 0",
        "Walls/top/Velocity": velocity * side,  # of one rate of strain
        "Contact/Friction": friction, "Contact/Rolling resistance": rolling,
        "Primaries/Smallest diameter": 0.1e-3 * coarse, "Primaries/Largest diameter": 0.18e-3 * coarse,
        "Output/Measures": "packing, coordination, shape", "Output/Snapshots every": 5e-5 / velocity, "Output/Fields every": 0,
        "Output/Inner forces": "false", "Output/History every": 1, "Stop/End time": 7e-3 / velocity, "Stop/Packing fraction": FRACTIONS[-1] + 0.005}
    for wall in ("bottom", "top", "left", "right"):
        made[f"Walls/{wall}/Friction"] = 0
    return made


def at(rows, place, column):
    """Mean of a column of history or measures over 0.01 of packing fraction around @place."""
    near = [row[column] for row in rows if abs(row["packing_fraction"] - place) < 0.005 and math.isfinite(row[column])]
    return statistics.fmean(near) if near else math.nan


def deviation(values):
    """Standard deviation, nan where there is none."""
    return statistics.stdev(values) if len(values) > 1 and all(map(math.isfinite, values)) else math.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("output/rolling"))
    parser.add_argument("--grains", type=int, default=30)
    parser.add_argument("--frictions", type=float, nargs="+", default=[0, 0.3, 0.6])
    parser.add_argument("--rolling", type=float, nargs="+", default=[0, 0.1, 0.5])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--coarse", type=float, default=1.5, help="size of the primaries over that of the scene")
    parser.add_argument("--velocity", type=float, default=5, help="of the wall for thirty grains, m/s (default: 5)")
    parser.add_argument("--table", type=pathlib.Path, help="CSV file for the means")
    words = parser.parse_args()
    table = []
    for friction in words.frictions:
        for rolling in words.rolling if friction > 0 else [0]:
            values = []
            for seed in words.seeds:
                folder = words.output / f"{words.grains}-{friction}-{rolling}-{seed}"
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                summary, rows = run(words.program, "gallery/thirty_grains_bpm.prm", folder,
                                    changes(words.grains, friction, rolling, seed, words.coarse, words.velocity), threads=1)
                cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                measures = softgrain.open(folder).measures
                measured = [dict(zip(measures, row)) for row in zip(*(measures[name] for name in measures))]
                for row in rows:
                    width = row["right_position_m"] - row["left_position_m"]
                    row["stress"] = 0.5 * (abs(row["top_force_N_per_m"]) + abs(row["bottom_force_N_per_m"])) / width
                values.append([at(rows, place, "stress") for place in FRACTIONS] +
                              [at(measured, place, column) for column in COLUMNS for place in FRACTIONS] +
                              [cpu, summary["steps"]])
            means = [statistics.fmean(column) for column in zip(*values)]
            scatter = [deviation(column) for column in zip(*values)]
            table.append([friction, rolling, *means, *scatter[:len(FRACTIONS)]])
            print(f"μ = {friction}, rolling resistance {rolling}: " + ", ".join(f"{value:.4g}" for value in means), flush=True)
    if words.table:
        names = ([f"stress_at_{place}_Pa" for place in FRACTIONS] +
                 [f"{column}_at_{place}" for column in COLUMNS for place in FRACTIONS] + ["cpu_s", "steps"] +
                 [f"scatter_of_stress_at_{place}_Pa" for place in FRACTIONS])
        with words.table.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["friction", "rolling_resistance", *names])
            writer.writerows([[f"{value:.5g}" for value in row] for row in table])


if __name__ == "__main__":
    main()
