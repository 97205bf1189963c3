#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Discrete elements beside soft grains, for doc/results/powder.md: thirty disks in a box whose top comes down, without friction and without
inertia, as material points (every grain deforms) and as disks that stay round and have a spring at every contact. Up to which packing
fraction has the sum of springs the pressure of the full solution?

The best spring that there is: the force over approach of one grain of the same material between two plates. Beside it the straight line
through its first tenth. A contact of two grains is that of each with a plate between them, of their mean curvature."""
import math
import pathlib

import numpy as np
from running import parser_of, run, softgrain
from scipy.interpolate import PchipInterpolator
from scipy.optimize import minimize

PLATES, BOX, DIE = "verification/confined_disk.prm", "gallery/thirty_grains_quasi_static_mpm.prm", "packings/powder_die.prm"
RADIUS = 5e-3  # of the disk between plates [m]
FARTHEST = 0.35  # that plates approach its middle, over the radius
SQUEEZED = {"Walls/Names": "bottom, top", "Mesh/Lower": "-9e-3, -5.3e-3", "Mesh/Upper": "9e-3, 5.3e-3", "Mesh/Cell size": "4e-4",
            "Stop/Packing fraction": "0", "Stop/End time": f"{FARTHEST:g}", "Output/Number of field outputs": "0"}
POWDER = {"Materials/Names": "powder", "Bodies/disk/Material": "powder", "Materials/powder/Law": "j2_plastic", "Materials/powder/Density": "1500",
          "Materials/powder/J2 plastic/Young's modulus": "5e9", "Materials/powder/J2 plastic/Poisson's ratio": "0.3",
          "Materials/powder/J2 plastic/Yield stress": "50e6", "Material points/F-bar": "on"}
# Name: (scene of the packing, its changes, those of the disk between plates, what stress is measured by, its value [Pa]).
GRAINS = {"gel": (BOX, {"Output/Fields every": "0"}, {}, "E", 10e6),
          "powder": (DIE, {"Contact/Friction": "0", "Stages/Names": "fill, press", "Stages/press/top/Pressure": "7.5e7*max(t, 0.03)", "Output/Fields every": "0"},
                     POWDER, "S_y", 50e6)}
FRACTIONS = (0.82, 0.83, 0.84, 0.85, 0.86, 0.87, 0.88, 0.90, 0.92, 0.94)
WINDOW = 0.005  # of packing fraction, over which both pressures are averaged: grains rearrange
OFF = 0.1  # difference that counts


class Spring:
    """Force of a contact over its mean radius, and its energy, by the share of the radius that it has come nearer."""

    def __init__(self, near, force):
        rising = PchipInterpolator(near, force)
        energy, last = rising.antiderivative(), near[-1]
        slope = rising.derivative()(last)

        def beyond(x):
            return np.maximum(x - last, 0)
        self.force = lambda x: rising(np.clip(x, 0, last)) + slope * beyond(x)
        self.energy = lambda x: energy(np.clip(x, 0, last)) + rising(last) * beyond(x) + 0.5 * slope * beyond(x)**2


def springs_of(history):
    """The spring that one grain between two plates is, and the straight line through its first tenth."""
    near = (2 * RADIUS - (history["top_position_m"] - history["bottom_position_m"])) / 2 / RADIUS
    force = 0.5 * (history["top_force_N_per_m"] + history["bottom_force_N_per_m"]) / RADIUS
    first = near <= 0.1
    line = float(np.sum(near[first] * force[first]) / np.sum(near[first]**2))
    return {"one grain": Spring(near, force), "line": Spring(np.array([0, 1]), np.array([0, line]))}, line


class Disks:
    """Round disks in a box, and what they store and press with."""

    def __init__(self, centres, radii, width, spring):
        self.x, self.r, self.width, self.spring = centres.copy(), radii, width, spring
        self.a, self.b = np.triu_indices(len(radii), 1)
        self.mean = 2 * radii[self.a] * radii[self.b] / (radii[self.a] + radii[self.b])

    def settle(self, height):
        """Balance with the top at @height, from where the disks are."""
        scale = self.r.mean()

        def energy(flat):
            x = scale * flat.reshape(-1, 2)
            apart = x[self.b] - x[self.a]
            way = np.linalg.norm(apart, axis=1)
            near = (self.r[self.a] + self.r[self.b] - way) / 2 / self.mean
            total = 2 * np.sum(self.mean**2 * self.spring.energy(near))
            pull = (self.mean * self.spring.force(near) / way)[:, None] * apart
            gradient = np.zeros_like(x)
            np.add.at(gradient, self.a, pull)
            np.add.at(gradient, self.b, -pull)
            for axis, place, sense in self.walls(height):
                close = (self.r - sense * (x[:, axis] - place)) / self.r
                total += np.sum(self.r**2 * self.spring.energy(close))
                gradient[:, axis] -= sense * self.r * self.spring.force(close)
            unit = scale**2 * self.spring.force(0.1)
            return total / unit, scale * gradient.ravel() / unit
        found = minimize(energy, self.x.ravel() / scale, jac=True, method="L-BFGS-B", options={"maxiter": 20000, "maxfun": 40000, "ftol": 1e-15, "gtol": 1e-7})
        self.x = scale * found.x.reshape(-1, 2)

    def walls(self, height):
        return (0, 0., 1), (0, self.width, -1), (1, 0., 1), (1, height, -1)

    def pressure(self, height):
        """Mean of the stresses on the four walls."""
        total = 0.
        for axis, place, sense in self.walls(height):
            close = (self.r - sense * (self.x[:, axis] - place)) / self.r
            total += np.sum(self.r * self.spring.force(close)) / (height if axis == 0 else self.width)
        return total / 4


def full(history):
    """Height, share of the box that grains fill, mean stress on the walls."""
    height = history["top_position_m"] - history["bottom_position_m"]
    width = history["right_position_m"] - history["left_position_m"]
    stress = 0.25 * ((history["top_force_N_per_m"] + history["bottom_force_N_per_m"]) / width +
                     (history["left_force_N_per_m"] + history["right_force_N_per_m"]) / height)
    return height, history["packing_fraction"], stress


def compare(name, seed, arguments, springs):
    """Packing fraction, and the pressures of material points and of each kind of spring at the same heights of the box."""
    scene, changes, *_ = GRAINS[name]
    folder = arguments.folder / f"{name}-seed-{seed}"
    run(arguments.program, scene, folder, {**changes, "Packing/Seed": seed}, threads=1, again=False)
    output = softgrain.open(folder)
    height, fraction, stress = full(output.history_table)
    bodies = output.snapshots[0].bodies
    radii = np.sqrt(np.asarray(bodies.area_m2) / math.pi)
    width = output.history_table["right_position_m"][0] - output.history_table["left_position_m"][0]
    pressures = {}
    for kind, spring in springs.items():
        disks = Disks(np.asarray(bodies.center_m), radii, width, spring)
        pressures[kind] = np.array([(disks.settle(h), disks.pressure(h))[1] for h in height])
    return fraction, stress, pressures


def near(fraction, values, place):
    kept = np.abs(fraction - place) <= WINDOW
    return values[kept].mean() if kept.any() else math.nan


def report(name, found):
    _, _, _, unit, value = GRAINS[name]
    print(f"\n{name}, {len(found)} packings, mean stress on the walls over {unit}; in brackets over that of material points\n\n"
          "| packing fraction | material points | " + " | ".join(f"spring: {kind}" for kind in found[0][2]) + " |\n|---" + "|---" * (1 + len(found[0][2])) + "|")
    for place in FRACTIONS:
        points = np.mean([near(f, s, place) for f, s, _ in found])
        cells = [np.mean([near(f, p[kind], place) for f, _, p in found]) for kind in found[0][2]]
        if not math.isnan(points):
            print(f"| {place:g} | {points / value:.4f} | " + " | ".join(f"{cell / value:.4f} ({cell / points:.2f})" for cell in cells) + " |")
    for kind in found[0][2]:
        leaves = [leaving(f, s, p[kind]) for f, s, p in found]
        print(f"spring '{kind}' is off by more than {OFF:.0%} from a packing fraction of {', '.join(f'{place:.3f}' for place in leaves)} on")


def leaving(fraction, stress, pressure):
    """Where the averaged pressures part for good."""
    places = np.arange(fraction[stress > 0.02 * stress.max()][0], fraction[-1] - WINDOW, 0.001)
    off = np.array([abs(near(fraction, pressure, place) / near(fraction, stress, place) - 1) > OFF for place in places])
    within = np.flatnonzero(~off)
    return places[within[-1] + 1] if len(within) and within[-1] + 1 < len(places) else (places[0] if not len(within) else math.nan)


def draw(picture, parts):
    """Pressures over the packing fraction, a panel for each kind of grains {name: what compare() found}."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, panels = pyplot.subplots(1, len(parts), figsize=(4.2 * len(parts), 3.4), squeeze=False)
    for panel, (name, found) in zip(panels[0], parts.items()):
        _, _, _, unit, value = GRAINS[name]
        for k, (fraction, stress, pressures) in enumerate(found):
            label = (lambda text, first=k == 0: text if first else None)
            panel.plot(fraction, stress / value, "k-", lw=1.2, label=label("every grain deforms"))
            panel.plot(fraction, pressures["one grain"] / value, "C0-", lw=0.9, label=label("springs: one grain"))
            panel.plot(fraction, pressures["line"] / value, "C1--", lw=0.9, label=label("springs: line"))
        panel.set(xlabel="packing fraction", ylabel=f"stress on the walls / {'$' + unit + '$'}", title=name, xlim=(0.78, None), ylim=(0, None))
        panel.legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = parser_of(__doc__, "springs")
    parser.add_argument("--grains", nargs="+", choices=GRAINS, default=list(GRAINS))
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--table", type=pathlib.Path, help="all states are written there")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure")
    arguments = parser.parse_args()
    rows, parts = [], {}
    for name in arguments.grains:
        _, _, plates, unit, value = GRAINS[name]
        run(arguments.program, PLATES, arguments.folder / f"plates-{name}", {**SQUEEZED, **plates}, threads=1, again=False)
        springs, line = springs_of(softgrain.open(arguments.folder / f"plates-{name}").history_table)
        print(f"{name}: line of {line / value:.3f} {unit}")
        found = [compare(name, seed, arguments, springs) for seed in arguments.seeds]
        parts[name] = found
        report(name, found)
        rows += [f"{name},{seed},{f:.5g},{s / value:.5g}," + ",".join(f"{p[kind][k] / value:.5g}" for kind in springs)
                 for seed, (fractions, stress, p) in zip(arguments.seeds, found) for k, (f, s) in enumerate(zip(fractions, stress))]
    if arguments.picture:
        draw(arguments.picture, parts)
    if arguments.table:
        arguments.table.write_text("grains,packing,packing_fraction,material_points,spring_one_grain,spring_line\n" + "\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
