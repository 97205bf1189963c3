#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gels that swell in a box that stays, for doc/results/confluence.md: pressure on the walls over the part of the box that they fill, beside
that of one gel of the same swelling without pores, by the closed form of the law; and the energy that is missing."""
import numpy as np

from running import parser_of, run

SCENE = "gallery/swelling_gels_mpm.prm"
SHEAR, MIXING, CHI = 4e4, 1.36e8, 0.4  # of the scene [Pa], [Pa]
EDGES = 10e-3, 10.6e-3  # of the box [m]
FRACTIONS = (0.84, 0.88, 0.92, 0.95, 0.97, 0.98, 0.984)


def potential(time):
    return -4e-3 * np.exp(-time)


def dry_stress(squared_stretch, volume, m):
    """Principal Kirchhoff stress per volume of the dry network [Pa]."""
    return SHEAR * (squared_stretch - 1) + MIXING * (volume * np.log1p(-1 / volume) + 1 + CHI / volume - m * volume)


def root(low, high, function):
    for _ in range(100):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return low


SWOLLEN = root(1.06, 1e4, lambda volume: dry_stress(volume ** (2 / 3), volume, potential(0)))


def pressure_without_pores(area, time):
    """Of a gel whose area in the plane is @area times that at the start, out of the plane as at the start [Pa]."""
    return -dry_stress(SWOLLEN ** (2 / 3) * area, SWOLLEN * area, potential(time)) / SWOLLEN / area


def free_area(time):
    """By which a gel grows in the plane where nothing presses it."""
    return root(1e-3, 1e3, lambda area: dry_stress(SWOLLEN ** (2 / 3) * area, SWOLLEN * area, potential(time)))


def pressure(row):
    return 0.25 * ((row["top_force_N_per_m"] + row["bottom_force_N_per_m"]) / EDGES[0]
                   + (row["left_force_N_per_m"] + row["right_force_N_per_m"]) / EDGES[1])


def main():
    parser = parser_of(__doc__, "swelling_gels")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3))
    arguments = parser.parse_args()
    found, lines = [], []
    for seed in arguments.seeds:
        summary, rows = run(arguments.program, SCENE, arguments.folder / f"{seed}", {"Packing/Seed": seed}, threads=1, again=False)
        columns = {name: np.array([row[name] for row in rows]) for name in ("time_s", "packing_fraction", "coordination")}
        fraction, of_walls = columns["packing_fraction"], np.array([pressure(row) for row in rows])
        at = {name: np.interp(FRACTIONS, fraction, values) for name, values in {**columns, "p": of_walls}.items()}
        alone = [pressure_without_pores(phi / fraction[0], time) for phi, time in zip(FRACTIONS, at["time_s"])]
        free = [fraction[0] * free_area(time) for time in at["time_s"]]
        found.append([at["p"], np.array(alone), at["coordination"], np.array(free)])
        lines.append(f"seed {seed}: {len(rows) - 1} steps, {sum(row['newton_iterations'] for row in rows):.0f} iterations, "
                     f"{summary['processor_seconds']:.1f} s of processor time, energy missing {100 * summary['energy_balance_error']:.3f} %")
    print("| filled | would fill | pressure [kPa] | without pores [kPa] | Z |\n|---|---|---|---|---|")
    for i, phi in enumerate(FRACTIONS):
        p, alone, contacts, free = np.array([[values[i] for values in one] for one in found]).T
        print(f"| {phi:g} | {free.mean():.3f} | {p.mean() / 1e3:.2f} ± {p.std(ddof=1) / np.sqrt(len(p)) / 1e3:.2f} | {alone.mean() / 1e3:.2f} "
              f"| {contacts.mean():.2f} |")
    print(*lines, sep="\n")


if __name__ == "__main__":
    main()
