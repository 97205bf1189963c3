#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Disks without friction compressed until there are no pores, packings/confluence.prm: contact numbers on their way to six, sides, areas and
perimeters of the grains, Lewis's and Aboav and Weaire's laws, for doc/results/confluence.md."""
import math
import pathlib

import numpy as np
from running import parser_of, run, softgrain

SCENE = "packings/confluence.prm"
YOUNG = 10e6  # [Pa]
SIDE, NUMBER = 19e-3, 100  # of the scene: edge of the cell [m] and grains in it
COLUMNS = ("packing", "pressure_over_E", "packing_fraction", "pressed", "coordination", "without_rattlers", "variance_of_sides", "shape_index",
           "shape_index_deviation", "pore_area_over_grain_area", "three_sided_pores_at_most")


def changes(seed, number, cell):
    side = SIDE * math.sqrt(number / NUMBER)
    margin = 3e-3
    return {"Packing/Seed": seed, "Packing/Number": number, "Packing/Upper": f"{side:.6g}, {side:.6g}", "Mesh/Upper": f"{side + margin:.6g}, {side + margin:.6g}",
            "Walls/top/Point": f"0, {side:.6g}", "Walls/right/Point": f"{side:.6g}, 0", "Mesh/Cell size": cell}


def pressed_to(highest):
    """Pressure from a hundredth of Young's modulus on, by a factor that is the same in every step."""
    pressure = f"{0.01 * YOUNG:g}*exp({math.log(highest / 0.01):.4g}*t)"
    return {f"Stages/press/{wall}/Pressure": pressure for wall in ("top", "right")}


class Tissue:
    """Sides, areas and perimeters of the grains of a state, and who touches whom."""

    def __init__(self, state):
        pairs = state.pairs
        pressed = (pairs.normal_force_N_per_m > 0) & (pairs.wall < 0)
        self.first, self.second = pairs.body_a[pressed], pairs.body_b[pressed]
        number = len(state.bodies.area_m2)
        self.sides = np.bincount(np.concatenate([self.first, self.second]), minlength=number)
        self.area = np.asarray(state.bodies.area_m2)
        lines = [state.outlines[body][0] for body in range(number)]
        self.perimeter = np.array([np.linalg.norm(np.roll(line, -1, axis=0) - line, axis=1).sum() for line in lines])
        self.fraction = state.measures["packing_fraction"]
        self.pressure = state.measures["mean_pressure_Pa"]
        self.without_rattlers = state.measures["coordination_without_rattlers"]

    def of_neighbours(self):
        """Mean number of sides of the neighbours of every grain."""
        total = np.bincount(self.first, self.sides[self.second], len(self.sides)) + np.bincount(self.second, self.sides[self.first], len(self.sides))
        return total / np.maximum(1, self.sides)

    def row(self, packing):
        sides, shape = self.sides, self.perimeter / np.sqrt(self.area)
        # Corners of a map on a torus: contacts less grains. Where all are of three grains there are two to a grain.
        corners = len(self.first) / len(sides) - 1
        return (packing, self.pressure / YOUNG, self.fraction, len(self.first), sides.mean(), self.without_rattlers, sides.var(), shape.mean(), shape.std(),
                1 / self.fraction - 1, corners / 2)


def farthest(history):
    """Pressure and packing fraction of the last step in balance; snapshots may end before."""
    pressure = history["top_force_N_per_m"] / (history["right_position_m"] - history["left_position_m"]) / YOUNG
    k = np.flatnonzero(pressure > 0)[-1]
    return f"pressure {pressure[k]:.3f} E, packing fraction {history['packing_fraction'][k]:.4f}"


def with_error(x, y):
    """Slope and intercept of a straight line, and the standard error of the slope."""
    (slope, start), covariance = np.polyfit(x, y, 1, cov=True)
    return slope, start, math.sqrt(covariance[0, 0])


def laws(tissues):
    """Lewis: mean area of grains with n sides; Aboav and Weaire: sides of their neighbours; of all grains of @tissues together."""
    sides = np.concatenate([t.sides for t in tissues])
    area = np.concatenate([t.area / t.area.mean() for t in tissues])
    around = np.concatenate([t.of_neighbours() for t in tissues])
    shape = np.concatenate([t.perimeter / np.sqrt(t.area) for t in tissues])
    print("\n| sides | grains | area over mean ± its error | sides of neighbours m | n m | perimeter over root of area | regular polygon |\n|---|---|---|---|---|---|---|")
    for n in range(sides.min(), sides.max() + 1):
        kept = sides == n
        if kept.sum() >= 2:
            regular = 2 * math.sqrt(n * math.tan(math.pi / n)) if n > 2 else math.nan
            print(f"| {n} | {kept.sum()} | {area[kept].mean():.3f} ± {area[kept].std() / math.sqrt(kept.sum()):.3f} | {around[kept].mean():.2f} "
                  f"| {n * around[kept].mean():.1f} | {shape[kept].mean():.3f} | {regular:.3f} |")
    mean, variance = sides.mean(), sides.var()
    slope, start, error = with_error(sides, area)
    print(f"\nLewis: area over mean = 1 + {slope:.3f} (n - {mean:.2f}), standard error of the slope {error:.3f}; value at the mean {start + slope * mean:.3f}")
    slope, start, error = with_error(sides - mean, sides * around)
    print(f"Aboav and Weaire: n m = {slope:.2f} (n - {mean:.2f}) + {start:.2f}, a = {mean - slope:.2f} ± {error:.2f}; variance of n {variance:.2f}, "
          f"mean squared {mean**2:.1f} + variance = {mean**2 + variance:.2f}")


def draw(picture, rows, tissues):
    """Contact numbers and the form of grains over the packing fraction; areas and sides of neighbours of the last states."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    table = np.array(rows)
    table = table[table[:, 1] > 1e-4]
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(10, 3.2))
    left.plot(table[:, 2], table[:, 5], "o", ms=3)
    left.axhline(6, color="k", ls="--", lw=0.8)
    left.set(xlabel="packing fraction", ylabel="contacts of a grain")
    middle.plot(table[:, 2], table[:, 7], "o", ms=3)
    middle.axhline(2 * math.sqrt(6 * math.tan(math.pi / 6)), color="k", ls="--", lw=0.8)
    middle.set(xlabel="packing fraction", ylabel="perimeter / root of area")
    sides = np.concatenate([t.sides for t in tissues])
    area = np.concatenate([t.area / t.area.mean() for t in tissues])
    around = np.concatenate([t.of_neighbours() for t in tissues])
    right.plot(sides + np.random.default_rng(1).uniform(-0.15, 0.15, len(sides)), area, ".", ms=2, label="area / mean")
    for n in np.unique(sides):
        right.plot(n, area[sides == n].mean(), "ks", ms=5)
        right.plot(n, around[sides == n].mean() - 5, "r^", ms=5)
    right.plot([], [], "r^", label="sides of neighbours - 5")
    right.set(xlabel="sides")
    right.legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = parser_of(__doc__, "confluence")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3))
    parser.add_argument("--number", type=int, default=NUMBER, help="grains (default: %(default)s)")
    parser.add_argument("--cell", type=float, default=2.4e-4, help="cells of the grid [m] (default: %(default)s)")
    parser.add_argument("--highest", type=float, default=0.5, help="pressure at the end over Young's modulus (default: %(default)s)")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    parser.add_argument("--limit", type=float, default=3600, help="wall seconds of one run (default: %(default)s)")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure")
    parser.add_argument("--curves", type=pathlib.Path, help="all states are written there as a table")
    arguments = parser.parse_args()
    further = {**pressed_to(arguments.highest), **dict(item.split("=", 1) for item in arguments.set)}
    rows, last = [], []
    for seed in arguments.seeds:
        folder = arguments.folder / f"{arguments.number}-cells-{arguments.cell:g}-seed-{seed}"
        try:
            run(arguments.program, SCENE, folder, {**changes(seed, arguments.number, arguments.cell), **further}, threads=1,
                limit=arguments.limit, again=False)
        except softgrain.RunFailed as trouble:
            print(f"packing {seed}: {trouble}", flush=True)
        output = softgrain.open(folder)
        tissues = [Tissue(state) for state in output.snapshots]
        rows += [t.row(seed) for t in tissues if len(t.first)]
        last.append([t for t in tissues if len(t.first)][-1])  # the state in which a run fails has no contacts
        print(f"packing {seed}: {farthest(output.history_table)}", flush=True)
    print("\n| packing | P/E | Φ | Z | without rattlers | variance of sides | perimeter over root of area ± deviation | pores over grains | (contacts - grains)/(2 grains) |\n"
          + "|---" * 9 + "|")
    for r in rows:
        print(f"| {r[0]} | {r[1]:.4f} | {r[2]:.4f} | {r[4]:.2f} | {r[5]:.2f} | {r[6]:.2f} | {r[7]:.3f} ± {r[8]:.3f} | {r[9]:.4f} | {r[10]:.3f} |")
    laws(last)
    if arguments.picture:
        draw(arguments.picture, rows, last)
    if arguments.curves:
        np.savetxt(arguments.curves, np.array(rows), delimiter=",", fmt="%.6g", comments="", header=",".join(COLUMNS))


if __name__ == "__main__":
    main()
