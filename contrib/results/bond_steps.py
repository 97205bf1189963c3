#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the length of a step does to bonded grains: mean and fluctuation of the force on one grain, over arrangements of its primaries.

Runs gallery/one_grain_bpm.prm at the rate of strain of the thesis's compaction, with steps of 0.024 and 0.24 sqrt(m a0/F0), as 0.1
and 1 us are there. Prints differences from the shortest, arrangement by arrangement: their mean and its standard error."""
import statistics

from running import parser_of, run

UNIT = 1.21e-5  # sqrt(m a0 / F0) of the scene [s]
SHARES = (0.024, 0.24)
SPEED = 0.6
FROM = 0.06


def sums(rows):
    """Mean of the force on the upper wall beyond a strain, and its fluctuation about a straight line over the mean."""
    points = [(row["axial_strain"], row["top_force_N_per_m"]) for row in rows if row["axial_strain"] >= FROM]
    mean = statistics.fmean(force for _, force in points)
    at = statistics.fmean(strain for strain, _ in points)
    slope = sum((strain - at) * force for strain, force in points) / sum((strain - at) ** 2 for strain, _ in points)
    # Forces of 100 steps of the longest are one: a longer step averages over more.
    n_bins = 40
    low, high = points[0][0], points[-1][0] + 1e-12
    bins = [[] for _ in range(n_bins)]
    for strain, force in points:
        bins[int((strain - low) / (high - low) * n_bins)].append(force - mean - slope * (strain - at))
    return mean, statistics.pstdev(statistics.fmean(inside) for inside in bins if inside) / mean


def main():
    parser = parser_of(__doc__, "bond-steps")
    parser.add_argument("--arrangements", type=int, default=24)
    parser.add_argument("--shares", type=float, nargs="+", default=SHARES)
    arguments = parser.parse_args()
    found = {}
    for seed in range(1, arguments.arrangements + 1):
        for share in arguments.shares:
            changes = {"Time/Time step": share * UNIT, "Primaries/Seed": seed, "Walls/top/Velocity": SPEED, "Output/Fields every": 0,
                       "Output/Number of field outputs": 0, "Output/History every": 1}
            summary, rows = run(arguments.program, "gallery/one_grain_bpm.prm", arguments.folder / f"{share}-{seed}", changes, threads=1, again=False)
            found[share, seed] = (*sums(rows), summary["processor_seconds"], len(rows) - 1)
    first = arguments.shares[0]
    seeds = range(1, arguments.arrangements + 1)
    for share in arguments.shares:
        change = [100 * (found[share, seed][0] / found[first, seed][0] - 1) for seed in seeds]
        scatter = [100 * found[share, seed][1] for seed in seeds]
        seconds = statistics.fmean(found[share, seed][2] for seed in seeds)
        error = len(change) ** -0.5
        print(f"| {share} | {statistics.fmean(found[share, seed][3] for seed in seeds):.0f} | {seconds:.2f} | "
              f"{statistics.fmean(change):+.1f} ± {error * statistics.stdev(change):.1f} | "
              f"{statistics.fmean(scatter):.2f} ± {error * statistics.stdev(scatter):.2f} |")


if __name__ == "__main__":
    main()
