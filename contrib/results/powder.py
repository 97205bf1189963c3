#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plastic grains in a die, packings/powder_die.prm: Heckel's and Kawakita's fits, stress on the die, spring-back, for
doc/results/powder.md."""
import math
import pathlib

import numpy as np
from running import RunFailed, box, parser_of, read_run, run

SCENE = "packings/powder_die.prm"
LAW = "Materials/powder/J2 plastic/"
YIELD, YOUNG, POISSON = 50e6, 5e9, 0.3
SIDES = (10e-3, 10.6e-3)  # of the box of thirty grains [m]
HIGHEST = 3.0  # pressure of the punch over the yield stress
# Name: what differs from the scene.
CASES = {
    "as it is": {},
    "packing 2": {"Packing/Seed": 2},
    "packing 3": {"Packing/Seed": 3},
    "cells of d/6": {"Mesh/Cell size": 3.2e-4},
    "cells of d/11": {"Mesh/Cell size": 1.7e-4},
    "no friction": {"Contact/Friction": 0},
    "friction at the die": {"Contact/Friction at walls": "same"},
    "hardening": {LAW + "Hardening modulus": 50e6},
    "stiffer": {LAW + "Young's modulus": 20e9},
}


def larger(number):
    """Changes for @number grains in a box of the same shape."""
    changes, width, height = box(number, 30, *SIDES)
    margin = 1e-3
    return {**changes, "Mesh/Upper": f"{width + margin:.6g}, {height + margin:.6g}"}


def states(rows, stage):
    """Of the steps of @stage with a punch that bears its load: stress on the punch and on the die [Pa], density, height [m]."""
    kept = [row for row in rows if row["stage"] == stage]
    height = np.array([row["top_position_m"] - row["bottom_position_m"] for row in kept])
    width = np.array([row["right_position_m"] - row["left_position_m"] for row in kept])
    axial = np.array([row["top_force_N_per_m"] + row["bottom_force_N_per_m"] for row in kept]) / 2 / width
    radial = np.array([row["left_force_N_per_m"] + row["right_force_N_per_m"] for row in kept]) / 2 / height
    return axial, radial, np.array([row["packing_fraction"] for row in kept]), height


def line(x, y):
    """Slope and intercept of a straight line, and R²."""
    slope, start = np.polyfit(x, y, 1)
    return slope, start, 1 - np.sum((y - slope * x - start)**2) / np.sum((y - np.mean(y))**2)


def measure(rows):
    """The numbers of the table, from the history of one run."""
    axial, radial, density, height = states(rows, 2)
    away_axial, away_radial, away_density, away_height = states(rows, 3)
    pressure, mean = axial / YIELD, (axial + radial) / 2 / YIELD
    rising = (pressure > 0.5) & (pressure < 1.5)
    shortened = 1 - height / (rows[0]["top_position_m"] - rows[0]["bottom_position_m"])
    last = int(np.argmax(pressure))

    def at(load, values):
        return np.interp(load, pressure, values)

    def left(values):
        """Where the punch bears a tenth of what it has borne; no number where the run did not come there."""
        return np.interp(-0.1 * HIGHEST * YIELD, -away_axial, values, right=math.nan)

    first = away_axial > 0.67 * HIGHEST * YIELD
    return {"density": [at(load, density) for load in (1, 2, 3)], "heckel": line(pressure[rising], -np.log(1 - density[rising])),
            "of_mean": line(mean[rising], -np.log(1 - density[rising])),
            # P/C = P/a + 1/(ab); below the yield stress grains rearrange, and no line fits.
            "kawakita": line(pressure[pressure > 1], (pressure / shortened)[pressure > 1]),
            "ratio": [at(load, radial / axial) for load in (1, 2, 3)], "unloading": line(away_axial[first], away_radial[first])[0] if away_axial[-1] < 0.7 * HIGHEST * YIELD else math.nan,
            "left": left(away_radial) / YIELD, "spring_back": left(away_height) / height[last] - 1, "density_left": left(away_density),
            "density_after": away_density[-1] if away_axial[-1] < 0.01 * HIGHEST * YIELD else math.nan}


def elastic(young, poisson=POISSON):
    """What a solid without pores does while it unloads elastically: radial over axial stress that is taken off, spring-back."""
    return poisson / (1 - poisson), 0.9 * HIGHEST * YIELD * (1 + poisson) * (1 - 2 * poisson) / ((1 - poisson) * young)


HEADING = ("", "D at S_y", "2 S_y", "3 S_y", "Heckel's K S_y", "A", "R²", "K S_y of the mean stress", "R²", "Kawakita's a", "b S_y", "R²", "radial/axial at S_y",
           "2 S_y", "3 S_y", "unloading", "radial at 0.3 S_y, over S_y", "spring-back there", "D there", "D at the end")


def table(name, found):
    over_a, over_ab, quality = found["kawakita"]
    numbers = [f"{d:.4f}" for d in found["density"]] + [f"{x:.2f}" for x in found["heckel"][:2]] + [f"{found['heckel'][2]:.4f}", f"{found['of_mean'][0]:.2f}",
               f"{found['of_mean'][2]:.4f}", f"{1 / over_a:.3f}", f"{over_a / over_ab:.2f}", f"{quality:.4f}"] + [f"{r:.2f}" for r in found["ratio"]]
    numbers += [f"{found['unloading']:.2f}", f"{found['left']:.2f}", f"{100 * found['spring_back']:.2f} %", f"{found['density_left']:.4f}", f"{found['density_after']:.3f}"]
    print("| " + " | ".join([name, *numbers]) + " |", flush=True)


def write_curve(path, rows):
    """Loading and unloading of one run as a table of commas."""
    parts = [np.column_stack([np.full(len(axial), stage), axial / 1e6, radial / 1e6, density, 1e3 * height])
             for stage, (axial, radial, density, height) in ((stage, states(rows, stage)) for stage in (2, 3))]
    np.savetxt(path, np.vstack(parts), delimiter=",", fmt="%.6g", comments="", header="stage,axial_MPa,radial_MPa,density,height_mm")


def draw(picture, runs):
    """Heckel's plot, and the stress on the die over that of the punch, of all runs {name: rows}."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(8, 3.4))
    for name, rows in runs.items():
        axial, radial, density, _ = states(rows, 2)
        away_axial, away_radial, _, _ = states(rows, 3)
        left.plot(axial / YIELD, -np.log(1 - density), lw=1, label=name)
        right.plot(np.concatenate([axial, away_axial]) / YIELD, np.concatenate([radial, away_radial]) / YIELD, lw=1)
    load = np.array([0.3, 1.6])
    left.plot(load, 1.35 + 1.5 * load, "k--", lw=0.8, label="slope 3/2")
    left.plot(load + 0.2, 2.6 + load / 3, "k:", lw=0.8, label="slope 1/3 (Heckel)")
    left.set(xlabel="stress on the punch / $S_y$", ylabel="ln 1/(1 - D)", xlim=(0, 3), ylim=(1.4, 5.4))
    left.legend(frameon=False, fontsize=7)
    load = np.array([0, HIGHEST])
    right.plot(load, load, "k--", lw=0.8)
    right.plot(load[1] - load, 2.4 - POISSON / (1 - POISSON) * load, "k:", lw=0.8)
    right.set(xlabel="stress on the punch / $S_y$", ylabel="stress on the die / $S_y$", xlim=(0, 3), ylim=(0, 3))
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = parser_of(__doc__, "powder")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--number", type=int, default=30, help="grains (default: %(default)s)")
    parser.add_argument("--limit", type=float, default=3600, help="wall seconds of one run (default: %(default)s)")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure")
    parser.add_argument("--curve", type=pathlib.Path, help="a table of the first case is written there")
    arguments = parser.parse_args()
    print("| " + " | ".join(HEADING) + " |\n" + "|---" * len(HEADING) + "|", flush=True)
    runs = {}
    for name in arguments.cases:
        changes = {**(larger(arguments.number) if arguments.number != 30 else {}), **CASES[name]}
        folder = arguments.folder / f"{arguments.number}-{name.replace(' ', '-').replace('/', '-')}"
        try:
            _, rows = run(arguments.program, SCENE, folder, changes, threads=1, limit=arguments.limit, again=False)
        except RunFailed as trouble:
            print(f"{name}: {trouble}", flush=True)
            _, rows = read_run(folder)  # how far it came
        runs[name] = rows
        table(name, measure(rows))
        if arguments.curve and name == arguments.cases[0]:
            write_curve(arguments.curve, rows)
    if arguments.picture:
        draw(arguments.picture, runs)
    ratio, spring = elastic(YOUNG)
    print(f"\nA solid without pores: unloading {ratio:.2f}, spring-back {100 * spring:.2f} %. Closing of a round hole: K S_y of the mean stress {math.sqrt(3):.3f}")


if __name__ == "__main__":
    main()
