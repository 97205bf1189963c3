#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shear and bulk modulus of packings at rest against pressure: packings/small_shear.prm with its stages once for every pressure, each from
the packing of the one before; fits near jamming and the solid beside it, for doc/results/confluence.md."""
import math
import pathlib

import numpy as np
from running import PARAMETERS, parser_of, run, softgrain

import confluence

SCENE = "packings/small_shear.prm"
YOUNG, POISSON = 10e6, 0.45
STEP = 0.04  # of the scene [s]
SLACK, STRAIN = 0.02, 2e-3  # share of the pressure that is taken off; shear strain there and back
PRESSURES = (0.0025, 0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.45)  # over Young's modulus
COLUMNS = ("packing", "pressure_over_E", "packing_fraction", "coordination", "shear_there_over_E", "shear_back_over_E", "left_over_stress", "bulk_off_over_E",
           "bulk_on_over_E", "nonaffine", "nonaffine_left", "scatter_of_triangles")


def named(kind, k):
    """Name of a stage; those of the first pressure have the names of the scene."""
    return f"{kind}_{k}" if k else kind


def scene_of(pressures, height, path, include):
    """The scene with these stages for each of @pressures (over E), written to @path. @height: of the cell, for the velocity of the shear."""
    names, parts, before = ["gather"], [], pressures[0] / 2

    def stage(name, seconds, drives):
        names.append(name)
        lines = [f"  subsection {name}", "    subsection Stop", f"      set End time = {seconds}", "    end"]
        for wall, settings in drives.items():
            lines += [f"    subsection {wall}", *(f"      set {key} = {value}" for key, value in settings.items()), "    end"]
        parts.extend([*lines, "  end"])

    def pressed(formula):
        return {wall: {"Drive": "pressure", "Pressure": formula, **({"Tangential velocity": 0} if wall == "top" else {})} for wall in ("top", "right")}

    def sheared(velocity):
        return {"top": {"Drive": "velocity", "Velocity": 0, "Tangential velocity": velocity}, "right": {"Drive": "velocity", "Velocity": 0}}

    for k, pressure in enumerate(pressures):
        steps = max(3, math.ceil(math.log(pressure / before) / math.log(1.25)))
        seconds = steps * STEP
        stage(named("press", k), f"{seconds:.6g}", pressed(f"{before * YOUNG:.6g}*exp({math.log(pressure / before):.6g}*min(1, t/{seconds:.6g}))"))
        stage(named("slacken", k), STEP, pressed(f"{(1 - SLACK) * pressure * YOUNG:.6g}"))
        stage(named("return", k), STEP, pressed(f"{pressure * YOUNG:.6g}"))
        velocity = STRAIN * height / (2 * STEP)
        stage(named("shear", k), 2 * STEP, sheared(f"{-velocity:.6g}"))
        stage(named("back", k), 2 * STEP, sheared(f"{velocity:.6g}"))
        before = pressure
    parts[:0] = ["  subsection gather", "    subsection Stop", "      set Packing fraction = 0.85", "      set End time = 2", "    end", "  end"]
    text = [f"include {include}", "subsection Quasi-static", "  set Unbalanced force = 1e-5", "end", "subsection Stages", f"  set Names = {', '.join(names)}", *parts, "end",
            "subsection Output", "  set Fields every = 0", "  set Snapshots every = 1000", "  set History every = 1000", "  set Measures = packing, coordination, stress", "end"]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(text) + "\n", encoding="utf-8")
    return path, names


class State:
    """Of a snapshot: strain of the cell, its area, stresses, centres of the grains."""

    def __init__(self, state):
        walls = {str(name): k for k, name in enumerate(state.walls.name)}
        place = np.ravel(state.walls.position_m)
        self.width, self.height = (abs(place[walls[a]] - place[walls[b]]) for a, b in (("right", "left"), ("top", "bottom")))
        self.area = self.width * self.height
        self.offset = float(np.ravel(state.walls.offset_m)[walls["top"]])
        row = state.measures
        self.shear_stress, self.pressure = row["stress_xy_Pa"], row["mean_pressure_Pa"]
        self.fraction, self.coordination = row["packing_fraction"], row["coordination"]
        self.center = np.array(state.bodies.center_m)
        pressed = (state.pairs.normal_force_N_per_m > 0) & (state.pairs.wall < 0)
        self.pairs = np.stack([state.pairs.body_a[pressed], state.pairs.body_b[pressed]], axis=1)

    def branches(self, first, second):
        """From grains @first to the nearest images of @second."""
        way = self.center[second] - self.center[first]
        above = np.round(way[:, 1] / self.height)
        way -= np.stack([above * self.offset, above * self.height], axis=1)
        way[:, 0] -= np.round(way[:, 0] / self.width) * self.width
        return way


def ways(before, after, strain):
    """Root mean square of the ways of centres beside a shear of the cell by @strain."""
    way = after.center - before.center
    size = np.array([after.width, after.height])
    way[:, 0] -= strain * before.center[:, 1]
    way -= np.round(way / size) * size
    way -= way.mean(axis=0)
    return np.sqrt((way**2).sum(axis=1).mean())


def scatter_of_triangles(before, after, strain):
    """Standard deviation of the shear strain of triangles of grains in contact, weighted by their area, over @strain."""
    beside = [set() for _ in before.center]
    for a, b in before.pairs:
        beside[a].add(b)
        beside[b].add(a)
    corners = np.array([(a, b, c) for a, b in before.pairs for c in beside[a] & beside[b] if c > max(a, b)])
    old, new = (np.stack([state.branches(corners[:, 0], corners[:, k]) for k in (1, 2)], axis=1) for state in (before, after))
    gradient = np.linalg.solve(old, new)  # its transpose
    shear, area = gradient[:, 0, 1] + gradient[:, 1, 0], np.abs(np.linalg.det(old))
    mean = np.average(shear, weights=area)
    return math.sqrt(np.average((shear - mean)**2, weights=area)) / strain


def moduli(states, ends, k):
    """A row of the table but the packing."""
    rest = [State(states[index]) for index in ends[k]]
    pressed, slack, back, sheared, again = rest
    strain = (sheared.offset - back.offset) / sheared.height
    shear_there, shear_back = ((sheared.shear_stress - other.shear_stress) / strain for other in (back, again))
    bulk_off, bulk_on = ((other.pressure - slack.pressure) / math.log(slack.area / other.area) for other in (pressed, back))
    unit = strain * math.sqrt(back.area / len(back.center))  # the way of neighbours to each other
    return (back.pressure / YOUNG, back.fraction, back.coordination, shear_there / YOUNG, shear_back / YOUNG, (again.shear_stress - back.shear_stress)
            / (strain * shear_there), bulk_off / YOUNG, bulk_on / YOUNG, ways(back, sheared, strain) / unit, ways(back, again, 0) / unit, scatter_of_triangles(back, sheared, strain))


def solid(pressure):
    """Shear and bulk modulus of the neo-Hookean solid itself, pressed in its plane to @pressure; all over E."""
    mu, lame = 0.5 / (1 + POISSON), POISSON / ((1 + POISSON) * (1 - 2 * POISSON))

    def load(area):
        return -(mu * (area - 1) + lame * math.log(area)) / area
    low, high = 0.2, 1.0
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if load(middle) > pressure else (low, middle)
    small = 1e-5
    return mu, (load(low * (1 - small)) - load(low * (1 + small))) / (2 * small)


def print_means(table):
    """Means of the packings with their standard deviations, of those pressures that all have."""
    print("\n| P/E | Φ | Z | G/E | G over solid | K/E | K over solid |\n|---|---|---|---|---|---|---|")
    for pressure in sorted(set(np.round(table[:, 1], 5))):
        kept = table[np.abs(table[:, 1] / pressure - 1) < 1e-2]
        mu, bulk = solid(pressure)
        shear, off = kept[:, 5], kept[:, 7]
        print(f"| {pressure:.4g} | {kept[:, 2].mean():.4f} | {kept[:, 3].mean():.2f} | {shear.mean():.3f} ± {shear.std(ddof=1) if len(kept) > 1 else math.nan:.3f} | {shear.mean() / mu:.2f} "
              f"| {off.mean():.3f} ± {off.std(ddof=1) if len(kept) > 1 else math.nan:.3f} | {off.mean() / bulk:.2f} |")
    print()


def draw(picture, rows):
    """Both moduli over the pressure, with the solid's."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    table = np.array(rows)
    figure, axes = pyplot.subplots(figsize=(4.5, 3.6))
    axes.loglog(table[:, 1], table[:, 5], "o", ms=4, label="shear modulus")
    axes.loglog(table[:, 1], table[:, 7], "s", ms=4, label="bulk modulus")
    pressure = np.geomspace(table[0, 1], table[:, 1].max())
    of_solid = np.array([solid(p) for p in pressure])
    axes.loglog(pressure, of_solid, "k--", lw=0.8)
    low = pressure[pressure < 0.1]
    axes.loglog(low, 0.35 * np.sqrt(low), "k:", lw=0.8, label="power 1/2")
    axes.set(xlabel="pressure / E", ylabel="modulus / E")
    axes.legend(frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = parser_of(__doc__, "moduli")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3))
    parser.add_argument("--number", type=int, default=confluence.NUMBER, help="grains (default: %(default)s)")
    parser.add_argument("--cell", type=float, default=2.4e-4, help="cells of the grid [m] (default: %(default)s)")
    parser.add_argument("--pressures", type=float, nargs="+", default=PRESSURES, help="over Young's modulus")
    parser.add_argument("--limit", type=float, default=3600, help="wall seconds of one run (default: %(default)s)")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure")
    parser.add_argument("--table", type=pathlib.Path, help="all rows are written there")
    arguments = parser.parse_args()
    height = 0.93 * confluence.SIDE * math.sqrt(arguments.number / confluence.NUMBER)
    scene, names = scene_of(arguments.pressures, height, arguments.folder.resolve() / "moduli.prm", PARAMETERS / "packings/confluence.prm")
    rows = []
    for seed in arguments.seeds:
        folder = arguments.folder / f"{arguments.number}-cells-{arguments.cell:g}-seed-{seed}"
        try:
            run(arguments.program, scene, folder, confluence.changes(seed, arguments.number, arguments.cell), threads=1, limit=arguments.limit, again=False)
        except softgrain.RunFailed as trouble:
            print(f"packing {seed}: {trouble}", flush=True)
        rows += [(seed, *row) for row in rows_of(softgrain.open(folder), names, len(arguments.pressures))]
    print_table(rows)
    if arguments.picture:
        draw(arguments.picture, rows)
    if arguments.table:
        np.savetxt(arguments.table, np.array(rows), delimiter=",", fmt="%.6g", comments="", header=",".join(COLUMNS))


def rows_of(found, names, number):
    """A row for every pressure whose stages have all ended."""
    stage = np.asarray(found.history_table["stage"])
    time = np.asarray(found.history_table["time_s"])
    states, times = found.snapshots, np.asarray(found.snapshots.times)
    # The last stage that a run has come to has not ended, unless the run has.
    ended = int(stage.max()) - (0 if found.finished else 1)

    def end(which):
        return int(np.argmin(np.abs(times - time[stage == which][-1])))

    ends = []
    for k in range(number):
        numbers = [1 + names.index(named(kind, k)) for kind in ("press", "slacken", "return", "shear", "back")]
        if numbers[-1] > ended:
            break
        ends.append([end(which) for which in numbers])
    return [moduli(states, ends, k) for k in range(len(ends))]


def print_table(rows):
    print("| packing | P/E | Φ | Z | G/E there | G/E back | stress left over | G over solid | K/E less load | K/E more load | K over solid | non-affine | left | triangles |\n" + "|---" * 14 + "|")
    for r in rows:
        mu, bulk = solid(r[1])
        print(f"| {r[0]} | {r[1]:.4f} | {r[2]:.4f} | {r[3]:.2f} | {r[4]:.4f} | {r[5]:.4f} | {r[6]:.3f} | {r[5] / mu:.3f} | {r[7]:.3f} | {r[8]:.3f} | {r[7] / bulk:.3f} | {r[9]:.2f} | {r[10]:.2f} | {r[11]:.2f} |")
    table = np.array(rows)
    if len(np.unique(table[:, 0])) > 1:
        print_means(table)
    near = table[(table[:, 1] < 0.05) & (table[:, 5] > 0)]
    for name, column in (("G", 5), ("K", 7)):
        if len(near) > 3:
            (slope, _), covariance = np.polyfit(np.log(near[:, 1]), np.log(near[:, column]), 1, cov=True)
            print(f"{name} ~ P^b below P = 0.05 E: b = {slope:.2f} ± {math.sqrt(covariance[0, 0]):.2f} ({len(near)} states)")


if __name__ == "__main__":
    main()
