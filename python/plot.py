#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draws columns of history.csv and measures.csv as curves, several runs side by side, with theory
where there is one.
"""

import argparse
import os
from typing import Any, List

from needed import packages_of

with packages_of("plot"):
    import matplotlib.pyplot as plt
    import numpy as np
    from softgrain import InputError, Run, fits, split_unit
    from softgrain.command import Parser, run_tool, save_figure, warn
    from softgrain.curves import (
        DIAMETRAL,
        Curves,
        default_x,
        draw_panel,
        in_lines,
        panels_of,
        run_labels,
        usual_columns,
    )
    from softgrain.dissipation import draw_dissipation
    from softgrain.drawing import STYLE
    from softgrain.options import add_shared, check_labels
    from softgrain.theory import THEORIES

THEORY_DASHES = {"hertz": (0, (6, 2)), "johnson": (0, (1.5, 1.5))}


def parse_arguments():
    parser = Parser(
        prog="softgrain plot",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog=(
            "Units may be left out of the names. A column of measures.csv is drawn at the times of"
            " its rows, with\npoints.\n\nexamples:\n  softgrain plot out                           "
            "             force on a wall against strain, or energies\n  softgrain plot out --list "
            "                                columns there are\n  softgrain plot fine coarse --y"
            " packing_fraction coordination\n  softgrain plot out --x packing_fraction --y"
            " coordination_without_rattlers contact_anisotropy\n  softgrain plot out --x"
            " packing_fraction --y coordination_of_bodies --fit power --fit-range 0.84 0.98\n "
            " softgrain plot disk --preset diametral --output fig3.10.svg\n  softgrain plot out"
            " --preset dissipation                   what has become of the energy that is gone\n"
        ),
    )
    parser.add_argument("directories", metavar="DIR", nargs="+", help="output folder of a run")
    parser.add_argument(
        "--x", metavar="COLUMN", help="default: axial_strain when it changes, else time_s"
    )
    parser.add_argument(
        "--y",
        metavar="COLUMN",
        nargs="+",
        help=(
            "columns with one unit share a panel, others get their own (default: the force on the "
            "wall bottom; else the forces on the walls there are; without walls the energies)"
        ),
    )
    parser.add_argument(
        "--preset",
        choices=("diametral", "dissipation"),
        help=(
            "diametral: a disk between two walls as in the thesis, F/L against ln(h0/h), with"
            " theory; dissipation: what contacts, materials and the method have taken, one on the"
            " other, of one run"
        ),
    )
    parser.add_argument(
        "--theory",
        metavar="NAME[,NAME]",
        help=(
            "theories to draw with a force against axial_strain: hertz (thesis, eq. 3.31), johnson "
            "(line contact), none (default: both for a disk between two walls, else none)"
        ),
    )
    for name, text in (
        ("young", "Young's modulus [Pa]"),
        ("poisson", "Poisson's ratio"),
        ("radius", "radius [m]"),
    ):
        parser.add_argument(
            f"--{name}",
            type=float,
            metavar="NUMBER",
            help=f"{text} of the theory (default: from parameters.prm of the first run)",
        )
    parser.add_argument(
        "--fit",
        choices=("line", "power", "exponential"),
        help=(
            "fits a + b x, a + b (x - x0)^c or a + b exp(c (x - x0)) to every curve, where x0 is"
            " the start of the fit, draws it and prints its constants and R²; warns when R² is"
            " below 0.9"
        ),
    )
    parser.add_argument(
        "--fit-range",
        nargs=2,
        type=float,
        metavar=("MIN", "MAX"),
        help="part of x that is fitted, in the column's SI unit (default: all)",
    )
    add_shared(parser, "labels")
    parser.add_argument(
        "--xlim", nargs=2, type=float, metavar=("MIN", "MAX"), help="in the column's SI unit"
    )
    parser.add_argument(
        "--ylim", nargs=2, type=float, metavar=("MIN", "MAX"), help="in the column's SI unit"
    )
    parser.add_argument("--logx", action="store_true", help="logarithmic x axis")
    parser.add_argument("--logy", action="store_true", help="logarithmic y axis")
    add_shared(parser, "title")
    parser.add_argument(
        "--output",
        metavar="FILE",
        help="picture to write: .png, .svg, .pdf (default: DIR/pictures/Y-against-X.png)",
    )
    add_shared(parser, "dpi", default=220)
    parser.add_argument(
        "--list", action="store_true", help="print the columns of every run, draw nothing"
    )
    arguments = parser.parse_args()
    check_labels(arguments)
    if arguments.fit_range and not arguments.fit:
        raise InputError("--fit-range needs --fit")
    if arguments.fit_range and not arguments.fit_range[1] > arguments.fit_range[0]:
        raise InputError("--fit-range: the second number must be above the first")
    return arguments


def tables_of(run):
    """history.csv and measures.csv, as far as they are there; one of them must be."""
    found = [
        run.table(name)
        for name in ("history.csv", "measures.csv")
        if os.path.exists(run.path(name))
    ]
    return found or [run.history_table]  # says that it is missing


def choose_columns(arguments, curves):
    x, columns = arguments.x, arguments.y
    if arguments.preset == "diametral":
        x, columns = x or "axial_strain", columns or [DIAMETRAL]
    x, columns = x or default_x(curves), columns or usual_columns(curves)
    for one in curves[1:]:
        for name in (x, *columns):
            one.full_name(name)  # says when one run does not have it
    return curves[0].full_name(x), [curves[0].full_name(name) for name in columns]


def disk_between_walls(arguments, run):
    """
    Whether this is one disk between a bottom and a top wall, of a law that has what the theory
    needs.
    """
    parameters = run.parameters
    names = parameters.names("Bodies")
    return (
        len(names) == 1
        and sorted(parameters.names("Walls")) == ["bottom", "top"]
        and parameters.get(f"Bodies/{names[0]}/Shape", "disk") == "disk"
        and parameters.get("Packing/Number", 0) == 0
        and run.model == "mpm"
        and None not in theory_numbers(arguments, run).values()
    )


def choose_theories(arguments, run, x, columns):
    diametral = arguments.preset == "diametral" or (
        x == "axial_strain" and not arguments.y and disk_between_walls(arguments, run)
    )
    text = arguments.theory or ("hertz,johnson" if diametral else "none")
    names = [] if text == "none" else [name.strip() for name in text.split(",") if name.strip()]
    for name in names:
        if name not in THEORIES:
            raise InputError(f"--theory {name}: there are {', '.join(THEORIES)}, none")
    fits = x == "axial_strain" and all(
        c == DIAMETRAL or c.endswith("_force_N_per_m") for c in columns
    )
    if names and not fits:
        raise InputError(
            "--theory needs a wall's force, or --preset diametral, against axial_strain"
        )
    return names


def theory_numbers(arguments, run):
    """E, ν, R of the theory, None for what neither the user nor the run gives."""
    found = {
        "young": run.parameters.find_number("Young's modulus", "Materials"),
        "poisson": run.parameters.find_number("Poisson's ratio", "Materials"),
        "radius": run.parameters.find_number("Radius", "Bodies"),
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
            raise InputError(
                f"{run.directory}/parameters.prm does not give what the theory needs: use --{name}"
            )
    if not (found["young"] > 0 and -1 < found["poisson"] < 1 and found["radius"] > 0):
        raise InputError(
            "the theory needs a Young's modulus and a radius above 0 and a Poisson's ratio in"
            " (-1, 1)"
        )
    return found


def draw_theories(axes, arguments, curves, names, column, scale):
    constants = theory_constants(arguments, curves.run)
    strains = curves.values("axial_strain")
    finite = strains[np.isfinite(strains)]
    if len(finite) == 0:
        return
    strain = np.linspace(0, finite.max(), 400)
    divisor: Any = 1.0
    if column == DIAMETRAL:  # the width that the run has at this strain
        widths = curves.width()
        known = np.isfinite(strains) & np.isfinite(widths)
        order = np.argsort(strains[known], kind="stable")
        divisor = np.interp(strain, strains[known][order], widths[known][order])
    for name in names:
        formula, label = THEORIES[name]
        axes.plot(
            strain,
            formula(strain, **constants) / divisor / scale,
            color="#2b2b2b",
            linewidth=1.3,
            linestyle=THEORY_DASHES[name],
            label=label,
            zorder=2,
        )


def draw_fits(axes, arguments, curves, x, columns, x_scale, scale):
    """The fitted curves of a panel; returns what is to be printed of each, and warnings."""
    told, poor = [], []
    for one in curves:
        for column in columns:
            x_values, y_values, _ = one.pair(x, column)
            if arguments.fit_range:
                inside = (x_values >= arguments.fit_range[0]) & (x_values <= arguments.fit_range[1])
                x_values, y_values = x_values[inside], y_values[inside]
            name = f"{column} of {one.run.directory}"
            found = fits.curve(x_values, y_values, arguments.fit)
            if found is None:
                raise InputError(f"--fit: {name} has fewer than {fits.FEWEST} points to fit")
            numbers = ", ".join(f"{key} = {value:.6g}" for key, value in found.constants.items())
            told.append(f"{name} = {found.formula}, x = {x}: {numbers}, R² = {found.quality:.4f}")
            if found.quality < fits.POOR:
                poor.append(
                    f"the {arguments.fit} of {name} fits poorly, R² = {found.quality:.2f}: it does"
                    " not describe these data"
                )
            elif found.at_limit:
                poor.append(
                    f"the {arguments.fit} of {name} has no certain c: {found.constants['c']:.3g} is"
                    " the end of what is tried"
                )
            places = np.linspace(np.nanmin(x_values), np.nanmax(x_values), 300)
            axes.plot(
                places / x_scale,
                found(places) / scale,
                color="#2b2b2b",
                linewidth=1.2,
                linestyle=(0, (1.2, 1.4)),
                label=f"${found.formula}$, $R^2$ = {found.quality:.3f}",
                zorder=4,
            )
    return told, poor


def finish_panel(axes, arguments, x_scale, scale, negative):
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
    elif not arguments.logy and not negative:
        axes.set_ylim(bottom=0)
    if len(axes.lines) > 1:
        axes.legend(frameon=False, fontsize=10, handlelength=2.6)


def draw_stack(arguments, run):
    """The preset 'dissipation'; returns the path of the picture."""
    if len(arguments.directories) > 1:
        raise InputError("--preset dissipation is for one run")
    if given := [
        name
        for name in ("y", "fit", "theory", "xlim", "ylim", "logx", "logy", "labels")
        if getattr(arguments, name)
    ]:
        raise InputError(f"--preset dissipation goes without --{given[0]}")
    x = Curves(run).full_name(arguments.x or run.coordinate or "time_s")
    path = arguments.output or os.path.join(run.directory, "pictures", "dissipation.png")
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(6.4, 4.4), constrained_layout=True)
        draw_dissipation(axes, run, x)
        axes.set_title(arguments.title or "", pad=10)
        save_figure(figure, path, arguments.dpi)
        plt.close(figure)
    return path


def file_name(x, columns):
    """Columns without their units, which would make the name very long."""
    return f"{'-'.join(split_unit(name)[0] for name in columns)[:120]}-against-{split_unit(x)[0]}"


def main():
    arguments = parse_arguments()
    labels = arguments.labels or run_labels(arguments.directories)
    curves = [
        Curves(Run(directory), label) for directory, label in zip(arguments.directories, labels)
    ]
    tables = [tables_of(one.run) for one in curves]
    if arguments.list:
        for one, found in zip(curves, tables):
            for table in found:
                print(
                    f"{os.path.join(one.run.directory, os.path.basename(table.path))}:"
                    f" {len(table)} rows: {', '.join(table)}"
                )
        return 0
    if arguments.preset == "dissipation":
        print(draw_stack(arguments, curves[0].run))
        return 0
    x, columns = choose_columns(arguments, curves)
    theories = choose_theories(arguments, curves[0].run, x, columns)
    for one in curves:
        if not np.isfinite(one.values(x)).any():
            raise InputError(f"the column {x} of {one.run.directory} has no values yet")
    printed: List[str] = []
    warnings: List[str] = []
    with plt.rc_context(STYLE):
        panels = panels_of(columns)
        figure, all_axes = plt.subplots(
            len(panels),
            1,
            sharex=True,
            squeeze=False,
            constrained_layout=True,
            figsize=(6.4, 4.4 if len(panels) == 1 else 0.6 + 2.7 * len(panels)),
        )
        for axes, panel in zip(all_axes[:, 0], panels):
            x_scale, scale, x_label, negative = draw_panel(axes, curves, x, panel)
            if arguments.fit:
                told, poor = draw_fits(axes, arguments, curves, x, panel, x_scale, scale)
                printed, warnings = printed + told, warnings + poor
            if theories:
                draw_theories(axes, arguments, curves[0], theories, panel[0], scale)
            finish_panel(axes, arguments, x_scale, scale, negative)
            if len(panels) > 1:  # a low panel has no room for a long line
                axes.set_ylabel(in_lines(axes.get_ylabel()))
        all_axes[-1, 0].set_xlabel(x_label)
        if arguments.title:
            all_axes[0, 0].set_title(arguments.title, pad=10)
        name = "diametral" if arguments.preset else file_name(x, columns)
        path = arguments.output or os.path.join(arguments.directories[0], "pictures", name + ".png")
        save_figure(figure, path, arguments.dpi)
        plt.close(figure)
    print(path)
    print(*printed, sep="\n", end="\n" if printed else "")
    for text in warnings:
        warn("plot", text)
    return 0


if __name__ == "__main__":
    run_tool(main)
