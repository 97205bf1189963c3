# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figure of doc/results/rivals.md: what an error costs for one disk, and how far springs carry for thirty."""
import csv

import numpy as np
from running import softgrain  # noqa: F401, brings the package onto the path

# Height of the wall [mm] and force on it [N/m], mean of top and bottom, by LMGC90: see doc/results/rivals.md.
LMGC90 = ((9.6, 1778), (9.4, 2927), (9.2, 4064), (9.0, 5642), (8.8, 7294), (8.6, 8887), (8.4, 11729), (8.32, 13170))
COLOURS = {"softgrain": "#0b5394", "GetFEM": "#c2571a", "CalculiX": "#38761d", "LAMMPS": "#7f6000", "LMGC90": "#741b47"}


def rows_of(table):
    with open(table, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def worth(row):
    """Root of the mean square of a row's errors."""
    return float(np.sqrt(np.mean([float(row[f"error_{n}"])**2 for n in range(1, 7)])))


def points_of(rows, code):
    """(seconds, error) of each resolution: of runs that differ by the cut of the grid alone, the means."""
    groups = {}
    for row in rows:
        if row["scene"] == "disk" and row["code"] == code and "law" not in row["setting"]:
            groups.setdefault(row["setting"].split(", cut")[0], []).append(row)
    return sorted((np.mean([float(row["seconds"]) for row in group]), np.sqrt(np.mean([worth(row)**2 for row in group]))) for group in groups.values())


def draw_cost(axes, rows):
    for code, mark in (("GetFEM", "s"), ("CalculiX", "^"), ("softgrain", "o")):
        points = points_of(rows, code)
        if points:
            seconds, errors = zip(*points)
            axes.loglog(seconds, [100 * error for error in errors], mark + "-", color=COLOURS[code], label=code)
    axes.set_xlabel("processor time [s]")
    axes.set_ylabel("error of the force [%]")
    axes.set_title("one disk to $d/R$ = 0.3", fontsize=11)
    axes.legend(frameon=False)


def draw_forces(axes, folder):
    table = softgrain.open(str(folder / "grains 0.2 m/s")).history_table
    height, force = 1e3 * table["top_position_m"], 0.5 * (table["top_force_N_per_m"] + table["bottom_force_N_per_m"])
    axes.plot(height, 1e-3 * force, color=COLOURS["softgrain"], label="softgrain")
    axes.plot(*zip(*((height, 1e-3 * force) for height, force in LMGC90)), "o", color=COLOURS["LMGC90"], fillstyle="none", label="LMGC90")
    springs = folder / "lammps.csv"
    if springs.exists():
        found = np.genfromtxt(springs, delimiter=",", names=True)
        axes.plot(1e3 * found["height_m"], 1e-3 * found["force_N_per_m"], "--", color=COLOURS["LAMMPS"], label="springs (LAMMPS)")
    axes.set_xlim(10.6, 8.1)
    axes.set_ylim(0, 15)
    axes.set_xlabel("height of the wall [mm]")
    axes.set_ylabel("force [kN/m]")
    axes.set_title("thirty disks, no friction, 0.2 m/s", fontsize=11)
    axes.legend(frameon=False)


def draw(picture, table, folder):
    """Writes the picture from the rows of a table and the runs of a folder."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from softgrain.drawing import STYLE
    with plt.rc_context(STYLE):
        figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
        draw_cost(left, rows_of(table))
        draw_forces(right, folder)
        figure.tight_layout()
        figure.savefig(picture, dpi=110)
