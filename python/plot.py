#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws columns of history.csv as curves, several runs side by side, with theory where there is one."""

import argparse
import os
import sys

from reading import (InputError, Parser, describe, find_number, need, read_grid, read_history, read_parameters,
                     read_series, run_tool, scaled_unit, split_unit, with_unit)

try:
    import matplotlib
    matplotlib.use("Agg")  # no display is needed
    import matplotlib.pyplot as plt
    import numpy as np
    from drawing import STYLE
    from theory import THEORIES
except ImportError as missing:
    print(f"plot: {need('python3-matplotlib', missing)}", file=sys.stderr)
    sys.exit(2)

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#5a5a5a"]  # told apart by everyone
DASHES = ["-", (0, (5, 1.6)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5))]
THEORY_DASHES = {"hertz": (0, (6, 2)), "johnson": (0, (1.5, 1.5))}
DIAMETRAL = "mean_stress_F_over_L_Pa"


def parse_arguments():
    parser = Parser(
        prog="plot", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="examples:\n"
               "  plot.py out                                        force on the bottom wall against strain\n"
               "  plot.py out --list                                 columns there are\n"
               "  plot.py fine coarse --y packing_fraction coordination\n"
               "  plot.py disk --preset diametral --output fig3.10.svg\n")
    parser.add_argument("directories", metavar="DIR", nargs="+", help="output folder of a run")
    parser.add_argument("--x", metavar="COLUMN", help="default: axial_strain when it changes, else time_s")
    parser.add_argument("--y", metavar="COLUMN", nargs="+",
                        help="columns with one unit share a panel, others get their own (default: "
                             "bottom_force_N_per_m)")
    parser.add_argument("--preset", choices=("diametral",),
                        help="diametral: a disk between two walls as in the thesis, F/L against ln(h0/h), with theory")
    parser.add_argument("--theory", metavar="NAME[,NAME]",
                        help="curves to lay beside a force against axial_strain: hertz (thesis, eq. 3.31), johnson "
                             "(line contact), none (default: both for a disk between two walls, else none)")
    for name, text in (("young", "Young's modulus [Pa]"), ("poisson", "Poisson's ratio"), ("radius", "radius [m]")):
        parser.add_argument(f"--{name}", type=float, metavar="NUMBER",
                            help=f"{text} of the theory (default: from parameters.prm of the first run)")
    parser.add_argument("--labels", nargs="+", metavar="TEXT", help="names of the runs (default: of their folders)")
    parser.add_argument("--xlim", nargs=2, type=float, metavar=("MIN", "MAX"), help="in the column's SI unit")
    parser.add_argument("--ylim", nargs=2, type=float, metavar=("MIN", "MAX"), help="in the column's SI unit")
    parser.add_argument("--logx", action="store_true", help="logarithmic x axis")
    parser.add_argument("--logy", action="store_true", help="logarithmic y axis")
    parser.add_argument("--title", help="text above the picture")
    parser.add_argument("--output", metavar="FILE",
                        help="picture to write: .png, .svg, .pdf (default: DIR/pictures/Y-against-X.png)")
    parser.add_argument("--dpi", type=int, default=220, help="dots per inch (default: %(default)s)")
    parser.add_argument("--list", action="store_true", help="print the columns of every run, draw nothing")
    arguments = parser.parse_args()
    if arguments.labels and len(arguments.labels) != len(arguments.directories):
        raise InputError(f"--labels gives {len(arguments.labels)} names for {len(arguments.directories)} runs")
    if not 10 <= arguments.dpi <= 2400:
        raise InputError("--dpi must be 10 to 2400")
    return arguments


def width_over_time(directory, times):
    """The horizontal diameter at @times from the outlines of the pictures, None without them."""
    try:
        frames = [frame for frame in read_series(directory) if "outlines" in frame.files]
    except InputError:
        return None
    known, widths = [], []
    for frame in frames:
        points = read_grid(frame.files["outlines"]).points
        if len(points):
            known.append(frame.time)
            widths.append(np.ptp(points[:, 0]))
    return np.interp(times, known, widths) if known else None


class Run:
    """One output folder: its history, with columns that are worked out on demand."""

    def __init__(self, directory, label):
        self.directory = directory
        self.label = label
        self.history = read_history(directory)

    def column(self, name):
        if name == DIAMETRAL and name not in self.history:
            self.history[name] = self.column("bottom_force_N_per_m") / self.width()
        if name not in self.history:
            raise InputError(f"there is no column '{name}' in {self.directory}/history.csv; there are " +
                             ", ".join(self.history))
        return self.history[name]

    def width(self):
        if "width_m" in self.history:
            return self.history["width_m"]
        widths = width_over_time(self.directory, self.column("time_s"))
        if widths is None:
            raise InputError(f"{self.directory} does not say how wide the disk is: neither a column width_m in "
                             "history.csv nor outlines in fields.pvd")
        return widths


def run_labels(directories):
    """Names of the folders, as much of the path as makes them differ."""
    paths = [os.path.abspath(directory).split(os.sep) for directory in directories]
    for depth in range(1, max(map(len, paths)) + 1):
        labels = ["/".join(path[-depth:]) for path in paths]
        if len(set(labels)) == len(labels):
            return labels
    return [f"{path[-1]} ({number})" for number, path in enumerate(paths, start=1)]


def choose_columns(arguments, runs):
    if arguments.preset == "diametral":
        return arguments.x or "axial_strain", arguments.y or [DIAMETRAL]
    x = arguments.x
    if x is None:
        strains = [run.history.get("axial_strain") for run in runs]
        moves = all(s is not None and np.isfinite(s).any() and np.nanmax(np.abs(s)) > 0 for s in strains)
        x = "axial_strain" if moves else "time_s"
    return x, arguments.y or ["bottom_force_N_per_m"]


def disk_between_walls(arguments, run):
    """Whether this is one disk between a bottom and a top wall, of a law that has what the theory needs."""
    parameters = read_parameters(run.directory)
    names = [name.strip() for name in parameters.get(("Bodies", "Names"), "").split(",") if name.strip()]
    walls = sorted(name.strip() for name in parameters.get(("Walls", "Names"), "").split(","))
    return (len(names) == 1 and walls == ["bottom", "top"] and
            parameters.get(("Bodies", names[0], "Shape"), "disk") == "disk" and
            int(parameters.get(("Packing", "Number"), "0")) == 0 and parameters.get(("Model",), "mpm") == "mpm" and
            None not in theory_numbers(arguments, run).values())


def choose_theories(arguments, run, x, columns):
    diametral = arguments.preset == "diametral" or (x == "axial_strain" and not arguments.y and
                                                    disk_between_walls(arguments, run))
    text = arguments.theory or ("hertz,johnson" if diametral else "none")
    names = [] if text == "none" else [name.strip() for name in text.split(",") if name.strip()]
    for name in names:
        if name not in THEORIES:
            raise InputError(f"--theory {name}: there are {', '.join(THEORIES)}, none")
    fits = x == "axial_strain" and all(c == DIAMETRAL or c.endswith("_force_N_per_m") for c in columns)
    if names and not fits:
        raise InputError("--theory needs a wall's force, or --preset diametral, against axial_strain")
    return names


def theory_numbers(arguments, run):
    """E, ν, R of the theory, None for what neither the user nor the run gives."""
    parameters = read_parameters(run.directory)
    found = {
        "young": find_number(parameters, "Young's modulus", "Materials"),
        "poisson": find_number(parameters, "Poisson's ratio", "Materials"),
        "radius": find_number(parameters, "Radius", "Bodies"),
    }
    for name in found:
        if getattr(arguments, name) is not None:
            found[name] = getattr(arguments, name)
    return found


def theory_constants(arguments, run):
    """E, ν, R of the theory."""
    found = theory_numbers(arguments, run)
    for name in found:
        if found[name] is None:
            raise InputError(f"{run.directory}/parameters.prm does not give what the theory needs: use --{name}")
    if not (found["young"] > 0 and -1 < found["poisson"] < 1 and found["radius"] > 0):
        raise InputError("the theory needs a Young's modulus and a radius above 0 and a Poisson's ratio in (-1, 1)")
    return found


def draw_theories(axes, arguments, run, names, column, x_values, scale):
    constants = theory_constants(arguments, run)
    finite = x_values[np.isfinite(x_values)]
    if len(finite) == 0:
        return
    strain = np.linspace(0, finite.max(), 400)
    divisor = 1.0
    if column == DIAMETRAL:  # the width that the run has at this strain
        strains, widths = run.column("axial_strain"), run.width()
        known = np.isfinite(strains) & np.isfinite(widths)
        order = np.argsort(strains[known], kind="stable")
        divisor = np.interp(strain, strains[known][order], widths[known][order])
    for name in names:
        formula, label = THEORIES[name]
        axes.plot(strain, formula(strain, **constants) / divisor / scale, color="#2b2b2b", linewidth=1.3,
                  linestyle=THEORY_DASHES[name], label=label, zorder=2)


def label_of(name):
    if name == DIAMETRAL:
        return r"Stress $\sigma = F/L$"
    return describe(name)


def draw_panel(axes, arguments, runs, x, columns, theories):
    """The columns of one unit; returns the scale of the x axis' unit."""
    unit = split_unit(columns[0])[1]
    largest = max(np.nanmax(np.abs(run.column(c)), initial=0) for run in runs for c in columns)
    scale, unit = scaled_unit(unit, largest)
    x_base, x_unit = split_unit(x)
    x_largest = max(np.nanmax(np.abs(run.column(x)), initial=0) for run in runs)
    x_scale, x_unit = scaled_unit(x_unit, x_largest)
    for number, run in enumerate(runs):
        for position, column in enumerate(columns):
            if len(runs) == 1:
                colour, dashes, label = COLOURS[position % len(COLOURS)], "-", label_of(column)
                if len(columns) == 1:
                    label = run.label
            else:
                colour, dashes = COLOURS[number % len(COLOURS)], DASHES[position % len(DASHES)]
                label = run.label if len(columns) == 1 else f"{run.label}: {label_of(column)}"
            axes.plot(run.column(x) / x_scale, run.column(column) / scale, color=colour, linestyle=dashes,
                      linewidth=1.8, label=label, zorder=3)
    if theories:
        draw_theories(axes, arguments, runs[0], theories, columns[0], runs[0].column(x), scale)
    if len(columns) == 1:
        text = label_of(columns[0])
    else:
        kinds = {split_unit(c)[0].rsplit("_", 1)[-1] for c in columns}
        text = kinds.pop().capitalize() if len(kinds) == 1 else ""
    axes.set_ylabel(with_unit(text, unit).strip())
    if arguments.logx:
        axes.set_xscale("log")
    if arguments.logy:
        axes.set_yscale("log")
    if arguments.xlim:
        axes.set_xlim(arguments.xlim[0] / x_scale, arguments.xlim[1] / x_scale)
    elif not arguments.logx:
        axes.margins(x=0.02)
    if arguments.ylim:
        axes.set_ylim(arguments.ylim[0] / scale, arguments.ylim[1] / scale)
    elif not arguments.logy and all(np.nanmin(run.column(c), initial=0) >= -1e-9 * largest
                                    for run in runs for c in columns):
        axes.set_ylim(bottom=0)
    axes.minorticks_on()
    axes.tick_params(which="both", top=True, right=True)
    axes.grid(color="#d9d9d9", linewidth=0.6, zorder=0)
    axes.set_axisbelow(True)
    if len(axes.lines) > 1:
        axes.legend(frameon=False, fontsize=10, handlelength=2.6)
    return with_unit(describe(x), x_unit)


def panels_of(columns):
    """Columns by their unit, in the order they were asked for; pure numbers each for themselves."""
    panels = {}
    for column in columns:
        unit = split_unit(column)[1]
        panels.setdefault(unit if unit else column, []).append(column)
    return list(panels.values())


def save(figure, arguments, path):
    folder = os.path.dirname(path)
    if folder:
        os.makedirs(folder, exist_ok=True)
    temporary = os.path.join(folder, ".part-" + os.path.basename(path))
    try:
        figure.savefig(temporary, dpi=arguments.dpi, facecolor="white")
    except ValueError as error:  # an ending that matplotlib does not know
        raise InputError(f"cannot write {path}: {str(error).splitlines()[0]}") from error
    os.replace(temporary, path)
    print(path)


def main():
    arguments = parse_arguments()
    labels = arguments.labels or run_labels(arguments.directories)
    runs = [Run(directory, label) for directory, label in zip(arguments.directories, labels)]
    if arguments.list:
        for run in runs:
            print(f"{run.directory}: {len(next(iter(run.history.values())))} rows: {', '.join(run.history)}")
        return 0
    x, columns = choose_columns(arguments, runs)
    theories = choose_theories(arguments, runs[0], x, columns)
    for run in runs:
        if not np.isfinite(run.column(x)).any():
            raise InputError(f"the column {x} of {run.directory} has no values yet")
    plt.rcParams.update(STYLE)
    panels = panels_of(columns)
    figure, all_axes = plt.subplots(len(panels), 1, sharex=True, squeeze=False, constrained_layout=True,
                                    figsize=(6.4, 4.4 if len(panels) == 1 else 0.6 + 2.7 * len(panels)))
    for axes, panel in zip(all_axes[:, 0], panels):
        x_label = draw_panel(axes, arguments, runs, x, panel, theories)
    all_axes[-1, 0].set_xlabel(x_label)
    if arguments.title:
        all_axes[0, 0].set_title(arguments.title, pad=10)
    name = "diametral" if arguments.preset else f"{'-'.join(columns)[:120]}-against-{x}"
    save(figure, arguments, arguments.output or os.path.join(arguments.directories[0], "pictures", name + ".png"))
    return 0


if __name__ == "__main__":
    run_tool(main)
