#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A perfectly plastic sphere between two plates against finite elements, and twelve in a box that becomes smaller beside the contact law
MDR: tables of doc/results/three-dimensions.md."""
import csv
import pathlib
import statistics

from running import parser_of, run

# Of plastic_sphere_elements.py --elements 20: F/(Y R^2) at travels of each plate over R. Y/E = .05, nu = .3.
ELEMENTS = {0.02: 0.0882977, 0.05: 0.333311, 0.1: 0.833542, 0.15: 1.30894, 0.2: 1.67306, 0.25: 1.955, 0.3: 2.19685}
YOUNG, YIELD, RADIUS = 1e9, 50e6, 5e-3  # [Pa, m]
LAW = "Materials/gel/J2 plastic/"
SCENE = "gallery/twelve_plastic_spheres.prm"
VOLUME = 6.2748  # of the twelve [m^3]
WALLS = ("left", "right", "front", "back", "bottom", "top")


def sphere(program, folder, cells, cuts):
    """A row of the table: errors with @cells in the radius, mean of the cuts of the grid."""
    found, seconds, lost = [], [], []
    for cut in cuts:
        h = RADIUS / cells
        low = -RADIUS - (1.1 + cut) * h
        changes = {"Mesh/Cell size": h, "Mesh/Lower": f"{low}, {low + 0.3 * cut * h}, {low + RADIUS}",
                   "Mesh/Upper": f"{-low}, {-low}, {RADIUS - low + h}", "Stop/End time": 0.3,
                   "Output/Number of field outputs": 0, "Output/Fields every": 0.01, "Output/Field parts": "contacts",
                   "Walls/top/Velocity": 2 * RADIUS, "Materials/gel/Law": "j2_plastic", LAW + "Young's modulus": YOUNG,
                   LAW + "Poisson's ratio": 0.3, LAW + "Yield stress": YIELD}
        summary, rows = run(program, "verification/sphere_between_plates.prm", folder / f"{cells:g}-{cut}", changes, threads=1, again=False)
        found.append({at: min(rows, key=lambda row: abs(row["time_s"] - at))["top_force_N"] / (YIELD * RADIUS**2) for at in ELEMENTS})
        seconds.append(summary["processor_seconds"])
        lost.append(sum(rows[-1][name] for name in ("elastic_energy_J", "dissipated_energy_J")) / rows[-1]["external_work_J"] - 1)
    columns = []
    for at, known in ELEMENTS.items():
        errors = [100 * (force[at] / known - 1) for force in found]
        columns.append(f"{statistics.fmean(errors):+.1f} [{min(errors):+.1f}, {max(errors):+.1f}]")
    return f"| {cells:g} | " + " | ".join(columns) + f" | {100 * max(lost, key=abs):+.2f} % | {statistics.median(seconds):.0f} s |"


def twelve(program, folder, cell, speed):
    """{side of the box: mean pressure of the six walls over the yield stress} of one run, and its summary. @speed 0: at rest, where later
    steps become short."""
    changes = {"Mesh/Cell size": cell, "Stop/End time": 0.499 / speed if speed else 40}
    changes.update({f"Walls/{wall}/Velocity": speed or 0.01 for wall in WALLS})
    if not speed:
        changes.update({"Time/Scheme": "quasi_static", "Time/Wall way": 0.2, "Time/CFL multiple": 20})
    summary, rows = run(program, SCENE, folder / f"twelve-{cell:g}-{speed:g}", changes, threads=1, again=False)
    curve = {}
    for row in rows:
        side = row["right_position_m"] - row["left_position_m"]
        curve[side] = statistics.fmean(row[f"{wall}_force_N"] for wall in WALLS) / side**2 / YIELD
    return curve, summary


def of_lammps(path):
    """The same of a table of LAMMPS with columns edge_m, stress_xx_Pa, stress_yy_Pa, stress_zz_Pa."""
    with open(path, newline="", encoding="utf-8") as table:
        return {float(row["edge_m"]): statistics.fmean(float(row[f"stress_{axis}_Pa"]) for axis in ("xx", "yy", "zz")) / YIELD
                for row in csv.DictReader(table)}


def at(curve, side):
    """A curve between its rows; nothing beyond its end."""
    sides = sorted(curve)
    if not sides[0] <= side <= sides[-1]:
        return None
    right = next(k for k, other in enumerate(sides) if other >= side)
    if right == 0 or sides[right] == side:
        return curve[sides[right]]
    left, end = sides[right - 1], sides[right]
    return curve[left] + (side - left) / (end - left) * (curve[end] - curve[left])


def draw(picture, curves):
    """All curves over the packing fraction at rest."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, axes = pyplot.subplots(figsize=(5.5, 3.6), layout="constrained")
    for (name, curve), style in zip(curves.items(), ("k-", "C0o", "C1-", "C2-", "C3-")):
        sides = sorted(curve, reverse=True)
        axes.plot([VOLUME / side**3 for side in sides], [curve[side] for side in sides], style, markersize=4, label=name)
    axes.set_xlim(0.35, 0.8)
    axes.set_ylim(0, 0.8)
    axes.set_xlabel("volume of the balls at rest over that of the box")
    axes.set_ylabel("mean pressure of the walls, yield stresses")
    axes.legend(frameon=False)
    figure.savefig(picture, dpi=110)


def compare(arguments):
    """Runs the twelve; a table, a file and a figure of what is asked for."""
    curves = {"MDR, .1 m/s": of_lammps(arguments.mdr)} if arguments.mdr else {}
    for speed in arguments.twelve:
        curve, summary = twelve(arguments.program, arguments.folder, arguments.cell, speed)
        curves[f"softgrain, {speed:g} m/s" if speed else "softgrain, at rest"] = curve
        print(f"{speed:g} m/s: {summary['steps']} steps, {summary['processor_seconds']:.0f} s of processor time, energy balance "
              f"{summary['energy_balance_error']:.1e}")
    sides = [2.6 - 0.05 * k for k in range(12)] + [2.002]
    table = [[f"{side:.4g}", f"{VOLUME / side**3:.3f}", *("" if at(curve, side) is None else f"{at(curve, side):.4f}" for curve in curves.values())]
             for side in sides]
    for row in [["side_m", "packing_fraction_at_rest", *curves], *table]:
        print("| " + " | ".join(row) + " |")
    if arguments.curve:
        with open(arguments.curve, "w", newline="", encoding="utf-8") as out:
            csv.writer(out).writerows([["side_m", "packing_fraction_at_rest", *curves], *table])
    if arguments.picture:
        draw(arguments.picture, curves)


def main():
    parser = parser_of(__doc__, "plastic_spheres")
    parser.add_argument("--cells", type=float, nargs="*", default=(3, 4), help="in the radius of the sphere between plates")
    parser.add_argument("--cuts", type=float, nargs="+", default=(0.0, 0.2, 0.4, 0.6, 0.8), help="shifts of the grid in cells")
    parser.add_argument("--twelve", type=float, nargs="*", default=(), metavar="SPEED", help="of the walls of the twelve [m/s]; 0: at rest")
    parser.add_argument("--cell", type=float, default=0.16, help="for the twelve [m]")
    parser.add_argument("--mdr", type=pathlib.Path, help="table of LAMMPS for the same balls")
    parser.add_argument("--curve", type=pathlib.Path, help="their curves are written there")
    parser.add_argument("--picture", type=pathlib.Path, help="and drawn there")
    arguments = parser.parse_args()
    if arguments.cells:
        print("| R/h | " + " | ".join(f"d/R {way:g}" for way in ELEMENTS) + " | energy | processor time |", flush=True)
    for cells in arguments.cells:
        print(sphere(arguments.program, arguments.folder, cells, arguments.cuts), flush=True)
    if arguments.twelve:
        compare(arguments)


if __name__ == "__main__":
    main()
