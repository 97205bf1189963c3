#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact that sticks, beside what is known of it: a disk pulled off a plane (Johnson, Kendall, Roberts; Maugis), partial slip
(Cattaneo, Mindlin), and slip to and fro: the tables of doc/results/laws.md."""
import argparse
import math
import pathlib

import numpy as np

from running import run, softgrain

RADIUS = 5e-3  # of both scenes [m]
MASS = 1000 * math.pi * RADIUS**2  # [kg/m]


def jkr(modulus, work):
    """Pull-off force of line contact [N/m] and half width at pull-off [m]; Barquins, Journal of Adhesion 26 (1988)."""
    half = (2 * work * RADIUS**2 / (math.pi * modulus)) ** (1 / 3)
    return 0.75 * math.pi * modulus * half**2 / RADIUS, half


def maugis(modulus, strength, reach):
    """The same for a constant pull within a range; Baney and Hui, Journal of Adhesion Science and Technology 11 (1997)."""
    def pull(half):
        def opening(m):
            root = math.sqrt(m * m - 1)
            return (half**2 / (2 * RADIUS) * (m * root - math.log(m + root))
                    + 4 * strength * half / (math.pi * modulus) * (root * math.log(m + root) - m * math.log(m)) - reach)
        low, high = 1.0, 2.0
        while opening(high) < 0:
            high *= 2
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if opening(middle) < 0 else (low, middle)
        return 2 * strength * half * math.sqrt(low * low - 1) - math.pi * modulus * half**2 / (4 * RADIUS)
    return max(pull(half) for half in np.linspace(1e-3, 0.4, 2000) * RADIUS)


def pull_off(program, folder):
    summary, rows = run(program, "verification/pull_off.prm", folder, {}, threads=1, again=False)
    held = [-row["bottom_force_N_per_m"] for row in rows]
    strength, reach, modulus = 2.465e5, 2.8e-4, 2e6 / 0.91
    found, (limit, half) = max(held), jkr(modulus, strength * reach)
    tabor = (RADIUS * (strength * reach) ** 2 / (modulus**2 * reach**3)) ** (1 / 3)
    print(f"| pull-off, Tabor's number {tabor:.2f}, a/R = {half / RADIUS:.2f} in JKR's limit [N/m] | {maugis(modulus, strength, reach):.0f} "
          f"(JKR {limit:.0f}) | {found:.0f} |")
    print(f"  energy balance of the run: {summary['energy_balance_error']:.2g}, work of adhesion "
          f"{rows[-1]['adhesion_work_J_per_m']:.3g} J/m")


def places(folder):
    """Time and place of the disk along x [s, m], and the forces on the plate at the bottom [N/m]."""
    found = {}
    for state in softgrain.open(folder):
        force = np.asarray(state.contacts["force_N_per_m"])[np.asarray(state.contacts["wall"]) == 0]
        found[round(state.time, 6)] = (float(np.asarray(state.bodies["center_m"])[0, 0]), *np.abs(force.sum(axis=0)))
    return found


def slip(program, folder):
    """The way at some loads over that of a disk that sticks, with what Cattaneo's slip adds to it."""
    runs = []
    for friction in (0.5, 10):
        changes = {f"Walls/{wall}/Friction": friction for wall in ("bottom", "top")}
        run(program, "verification/partial_slip.prm", folder / f"friction-{friction}", changes, threads=1, again=False)
        runs.append(places(folder / f"friction-{friction}"))
    slips, sticks = runs
    print("| Q/(μP) | a/R | way [µm] | expected | difference | of which slip | expected |\n|---|---|---|---|---|---|---|")
    for time, (place, shear, load) in slips.items():
        if time < 1.01:
            continue
        way, stuck = place - slips[1.0][0], sticks[time][0] - sticks[1.0][0]
        share, modulus = shear / (0.5 * load), 1e6 / (1 - 0.499**2)
        more = 0.5 * load / (math.pi * modulus) * (share + (1 - share) * math.log(1 - share))
        half = math.sqrt(4 * load * RADIUS / (math.pi * modulus))
        print(f"| {share:.3f} | {half / RADIUS:.3f} | {1e6 * way:.2f} | {1e6 * (stuck + more):.2f} | "
              f"{100 * (way / (stuck + more) - 1):+.1f} % | {1e6 * (way - stuck):.2f} | {1e6 * more:.2f} |")


def cycles(program, folder, number):
    """Pushed to and fro by 0.4 of what friction bears, four steps a cycle, on a coarse grid."""
    changes = {"Mesh/Cell size": 2.9e-4, "Time/Time step": 0.25, "Stop/End time": 1 + number, "Output/Snapshots every": 1,
               "Output/Fields every": 0, "Bodies/disk/Body force": "t < 1 ? 0 : 1066*sin(2*pi*t); 0"}
    _, rows = run(program, "verification/partial_slip.prm", folder, changes, threads=1, again=False)
    found = places(folder)
    ends = [found[time][0] for time in sorted(found) if time >= 1]
    print(f"after 1, {len(ends) // 2} and {len(ends) - 1} cycles the disk is off by "
          + ", ".join(f"{1e9 * (ends[n] - ends[0]):.3f}" for n in (1, len(ends) // 2, len(ends) - 1)) + " nm; load "
          + f"{rows[-1]['bottom_force_N_per_m']:.4f} N/m, at the start "
          + f"{next(row['bottom_force_N_per_m'] for row in rows if row['time_s'] >= 1):.4f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/sticking"),
                        help="for the output folders of the runs (default: %(default)s)")
    parser.add_argument("--only", nargs="+", choices=("pull_off", "slip", "cycles"), default=("pull_off", "slip", "cycles"))
    parser.add_argument("--cycles", type=int, default=30)
    arguments = parser.parse_args()
    if "pull_off" in arguments.only:
        pull_off(arguments.program, arguments.folder / "pull_off")
    if "slip" in arguments.only:
        slip(arguments.program, arguments.folder)
    if "cycles" in arguments.only:
        cycles(arguments.program, arguments.folder / "cycles", arguments.cycles)


if __name__ == "__main__":
    main()
