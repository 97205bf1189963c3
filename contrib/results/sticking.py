#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact that sticks, beside what is known of it: a disk pulled off a plane (Johnson, Kendall, Roberts; Maugis), partial slip
(Cattaneo, Mindlin), and slip to and fro: the tables of doc/results/laws.md."""
import math

import numpy as np

from running import RunFailed, parser_of, run, softgrain

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


def small_contact(program, folder, levels, spacing, poisson, halvings):
    """A stiffer disk between two plates that go apart: a/R = 0.06, cells halved near contact. The largest force that is in balance. With
    @halvings contact, gaps and strain of the surface are so often halved, at equal Tabor's number."""
    print("| Tabor's number | row of markers over range of the pull along the surface | JKR [N/m] | Baney and Hui | found | difference |\n" + "|---" * 6 + "|")
    modulus, small = 2e6 / 0.91, 2**halvings
    for strength, reach in ((1.15e5 / small, 3.24e-5 / small**2), (2.3e5 / small, 1.62e-5 / small**2)):
        for level in levels:
            changes = {"Mesh/Lower": "-6e-3, -6e-3", "Mesh/Upper": "6e-3, 6e-3", "Mesh/Cell size": 2.5e-4, "Mesh/Refine near contact": level,
                       "Material points/Shape function": "linear", "Materials/gel/Neo-Hookean/Young's modulus": modulus * (1 - poisson**2),
                       "Material points/F-bar": "on" if poisson > 0.45 else "off",
                       "Materials/gel/Neo-Hookean/Poisson's ratio": poisson, "Bodies/disk/Body force": "0; 0", "Contact/Law": "cohesive",
                       "Contact/Adhesion": strength, "Contact/Adhesion range": reach, "Contact/Marker spacing": spacing,
                       "Time/Time step": 0.5 / small**2, "Stop/End time": 75 / small**2, "Output/Snapshots every": 0, "Output/Fields every": 0}
            for wall in ("bottom", "top"):
                changes |= {f"Walls/{wall}/Friction": 0, f"Walls/{wall}/Position": f"2e-6*(t < {5 / small**2:g} ? t : {10 / small**2:g} - t)"}
            name = folder / f"small-{strength:g}-{level}-{spacing:g}-{poisson:g}"
            try:
                run(program, "verification/partial_slip.prm", name, changes, threads=1, again=False)
            except RunFailed:
                pass  # the disk flies off: without inertia there is no balance then
            found = -min(softgrain.open(name).history_table["bottom_force_N_per_m"])
            exact, tabor = maugis(modulus, strength, reach), (RADIUS * (strength * reach) ** 2 / (modulus**2 * reach**3)) ** (1 / 3)
            zone = math.pi / 4 * modulus * reach / strength  # of Dugdale's crack
            print(f"| {tabor:.2f} | {spacing * 2.5e-4 / 2**level / zone:.3f} | {jkr(modulus, strength * reach)[0]:.1f} | {exact:.2f} | {found:.2f} | "
                  f"{100 * (found / exact - 1):+.1f} % |", flush=True)


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


def cycles(program, folder, number, push):
    """Pushed to and fro, by 0.4 of what friction bears with a push of 1066, four steps a cycle, on a coarse grid."""
    changes = {"Mesh/Cell size": 2.9e-4, "Time/Time step": 0.25, "Stop/End time": 1 + number, "Output/Snapshots every": 1,
               "Output/Fields every": 0, "Bodies/disk/Body force": f"t < 1 ? 0 : {push:g}*sin(2*pi*t); 0"}
    _, rows = run(program, "verification/partial_slip.prm", folder, changes, threads=1, again=False)
    found = places(folder)
    ends = [found[time][0] for time in sorted(found) if time >= 1]
    shown = [n for n in (1, 2, 5, 10, 20, 50, 100, 200, 500) if n < len(ends) - 1] + [len(ends) - 1]
    print("after cycles the disk is off by " + ", ".join(f"{n}: {1e9 * (ends[n] - ends[0]):.2f}" for n in shown) + " nm; from the tenth on by "
          + f"{1e9 * (min(ends[10:]) - ends[0]):.2f} to {1e9 * (max(ends[10:]) - ends[0]):.2f}; load "
          + f"{rows[-1]['bottom_force_N_per_m']:.4f} N/m, at the start "
          + f"{next(row['bottom_force_N_per_m'] for row in rows if row['time_s'] >= 1):.4f}")


def main():
    parser = parser_of(__doc__, "sticking")
    tasks = ("pull_off", "small", "slip", "cycles")
    parser.add_argument("--only", nargs="+", choices=tasks, default=tasks)
    parser.add_argument("--levels", type=int, nargs="+", default=[2, 3, 4], help="halvings near contact of the task small (default: 2 3 4)")
    parser.add_argument("--spacing", type=float, default=1, help="of rows of the task small [cells] (default: 1)")
    parser.add_argument("--poisson", type=float, default=0.3, help="ratio of the task small, at equal E*; with F-bar above 0.45 (default: 0.3)")
    parser.add_argument("--halvings", type=int, default=0, help="of contact and strain of the task small (default: 0)")
    parser.add_argument("--cycles", type=int, default=30)
    parser.add_argument("--push", type=float, default=1066, help="of the cycles, force on the volume [N/m^3] (default: %(default)s)")
    arguments = parser.parse_args()
    if "pull_off" in arguments.only:
        pull_off(arguments.program, arguments.folder / "pull_off")
    if "small" in arguments.only:
        small_contact(arguments.program, arguments.folder / "small", arguments.levels, arguments.spacing, arguments.poisson, arguments.halvings)
    if "slip" in arguments.only:
        slip(arguments.program, arguments.folder)
    if "cycles" in arguments.only:
        cycles(arguments.program, arguments.folder / f"cycles-{arguments.push:g}", arguments.cycles, arguments.push)


if __name__ == "__main__":
    main()
