# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draws figures 3.10-3.12 of Nguyen (2016), a grain between two walls, and measures plateau and
unloading.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ..drawing import INK
from .one_grain import CONSTANTS, Run, compare_slopes, read_run
from .tool import (
    NotDrawn,
    axes_of,
    draw_all,
    finish,
    markdown,
    parser_of,
    warn_of_poor_fits,
    write_constants,
)

COLOURS = ("#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#5a5a5a")
MPM_COLOUR = "#0072B2"
THESIS = {
    "plateau_Pa": 0.5e6,
    "characteristic_stress_Pa": 0.5e6,
    "plateau_over_characteristic": 1.0,
    "linear_until_strain": 0.02,
    "unloading_slope_Pa": 25e6,
    "unloading_slope_over_plateau": 50.0,
}
DASHES = ("-", (0, (5, 1.6)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5)))
THESIS_DIAMETERS = (0.16e-3, 0.26e-3)
MPA = 1e-6


EPILOG = """\
What a run is, its parameters.prm and history.csv tell: the model, F0 and the diameters of the
primaries, whether the walls open again. The runs need the walls bottom and top and, unless
history.csv has a column width_m, outlines in snapshots.h5 or fields.pvd.

examples:
  softgrain figures thesis-3 output/diametral_compression_*
  softgrain figures thesis-3 mpm bpm unloaded --output doc/pictures --format svg
"""


def same_diameters(run, diameters):
    return run.diameters is not None and np.allclose(run.diameters, diameters, rtol=1e-6)


def loading_runs(runs):
    """
    Runs of primaries to draw while loading: of one grain those that only load, unless another was
    loaded farther.
    """
    chosen = []
    for key in dict.fromkeys(run.key for run in runs if run.model != "mpm"):
        same = [run for run in runs if run.key == key]
        farthest = max(same, key=lambda run: run.loading[0][-1])
        only = [
            run
            for run in same
            if not run.unloading and run.loading[0][-1] > 0.9 * farthest.loading[0][-1]
        ]
        chosen += only or [farthest]
    return chosen


def draw_loading(axes, run, colour, label):
    """The mean, and for primaries the rows themselves, faint."""
    if run.model != "mpm":
        axes.plot(
            run.loading[0], MPA * run.loading[1], color=colour, linewidth=0.4, alpha=0.22, zorder=2
        )
    axes.plot(
        run.smooth[0], MPA * run.smooth[1], color=colour, linewidth=1.8, label=label, zorder=4
    )


def limit_by_means(axes, runs):
    """The noise may leave the panel, the means may not."""
    curves = [run.smooth for run in runs]
    axes.set(
        xlim=(0, 1.02 * max(curve[0].max() for curve in curves)),
        ylim=(0, 1.5 * MPA * max(curve[1].max() for curve in curves)),
    )


def finish_stress(axes, **settings):
    finish(
        axes,
        "axial strain $\\varepsilon = \\ln(h_0/h)$",
        "stress $\\sigma = F/L$  [MPa]",
        **settings,
    )


def two_models(runs):
    solid, bonded = [run for run in runs if run.model == "mpm"], loading_runs(runs)
    bonded = [run for run in bonded if same_diameters(run, THESIS_DIAMETERS)] or bonded
    if not solid or not bonded:
        raise NotDrawn("it needs a run by MPM and one by BPM")
    figure, (axes,) = axes_of("Fig. 3.10: a grain between two walls, MPM and BPM")
    for number, run in enumerate(solid):
        draw_loading(axes, run, MPM_COLOUR, "MPM" if number == 0 else None)
    for run, colour in zip(bonded, np.resize(COLOURS, len(bonded))):
        draw_loading(axes, run, colour, run.label)
    limit_by_means(axes, solid + bonded)
    finish_stress(axes)
    return figure


def polydispersities(runs):
    panels: dict[Any, list[Run]] = {}
    for run in loading_runs(runs):
        panels.setdefault(run.force, []).append(run)
    panels = {
        force: sorted(found, key=lambda run: run.mean_diameter or run.smallest)
        for force, found in sorted(panels.items(), key=lambda item: item[0] or 0)
        if None not in [run.diameters for run in found]
        and len({run.diameters for run in found}) > 1
    }
    if not panels:
        raise NotDrawn("it needs runs by BPM with different diameters and the same F0")
    if len(panels) > len(DASHES):
        raise NotDrawn(f"more than {len(DASHES)} values of F0 have no room")
    figure, all_axes = axes_of("Fig. 3.11: primaries of different sizes", len(panels) + 1)
    sizes = dict.fromkeys(run.diameters for found in panels.values() for run in found)
    colours = {diameters: COLOURS[i % len(COLOURS)] for i, diameters in enumerate(sizes)}
    scaled = all_axes[-1]
    for axes, dashes, (force, found) in zip(all_axes, DASHES, panels.items()):
        for run in found:
            text = f"{1e3 * run.diameters[0]:.2f}\u2013{1e3 * run.diameters[1]:.2f} mm"
            if run.mean_diameter:
                text += f", $\\langle a_0\\rangle$ = {1e3 * run.mean_diameter:.3f} mm"
            draw_loading(axes, run, colours[run.diameters], text)
            if run.characteristic_stress:
                scaled.plot(
                    run.smooth[0],
                    run.smooth[1] / run.characteristic_stress,
                    linewidth=1.3,
                    linestyle=dashes,
                    color=colours[run.diameters],
                )
        limit_by_means(axes, found)
        finish_stress(axes)
        axes.set_title(f"$F_0$ = {force:g} N/m" if force else "", fontsize=10)
        scaled.plot(
            [], [], color=INK, linestyle=dashes, linewidth=1.3, label=f"$F_0$ = {force or 0:g} N/m"
        )
    finish(
        scaled,
        "axial strain $\\varepsilon$",
        "$\\sigma/p_I$ with $p_I = F_0/\\langle a_0\\rangle$",
        xlim=(0, None),
        ylim=(0, 1.4 * scaled.get_ylim()[1]),
    )
    return figure


def unloading(runs):
    found = sorted(
        (run for run in runs if run.unloading and run.model != "mpm"),
        key=lambda run: run.loading[0][-1],
    )
    if not found:
        raise NotDrawn("it needs runs by BPM whose walls open again")
    figure, (axes, near) = axes_of("Fig. 3.12: unloading", 2)
    for run, colour in zip(found, np.resize(COLOURS, len(found))):
        numbers = run.constants
        label = f"from $\\varepsilon$ = {numbers['reversal_strain']:.3f}"
        if len({other.key for other in found}) > 1:
            label += f", {run.label}"
        draw_loading(axes, run, colour, label)
        axes.plot(
            run.smooth_unloading[0],
            MPA * run.smooth_unloading[1],
            color=colour,
            linewidth=1.8,
            zorder=4,
        )
        axes.plot(
            run.unloading[0],
            MPA * run.unloading[1],
            color=colour,
            linewidth=0.4,
            alpha=0.22,
            zorder=2,
        )
        # The way back alone, against what is recovered.
        back = numbers["reversal_strain"]
        if numbers["unloading_slope_Pa"]:
            label += f": E' = {MPA * numbers['unloading_slope_Pa']:.0f} MPa"
        near.plot(
            back - run.unloading[0],
            MPA * run.unloading[1],
            color=colour,
            linewidth=0.4,
            alpha=0.35,
            zorder=2,
        )
        near.plot(
            back - run.smooth_unloading[0],
            MPA * run.smooth_unloading[1],
            color=colour,
            linewidth=1.8,
            label=label,
            zorder=4,
        )
    limit_by_means(axes, found)
    finish_stress(axes)
    highest = MPA * max(run.smooth_unloading[1].max() for run in found)
    recovered = max(run.constants["recovered_strain"] or np.ptp(run.unloading[0]) for run in found)
    finish(
        near,
        "strain recovered",
        "stress $\\sigma = F/L$  [MPa]",
        xlim=(0, 1.5 * recovered),
        ylim=(0, 1.5 * highest),
    )
    return figure


FIGURES = {"3.10": two_models, "3.11": polydispersities, "3.12": unloading}


def text_of(value):
    return "-" if value is None else f"{value:.4g}"


def table_of(runs):
    """The constants as a Markdown table, those of the thesis (BPM, F0 = 100 N/m) beside ours."""
    names = [os.path.basename(os.path.normpath(run.directory)) for run in runs]
    rows = [
        ["", "thesis, BPM", *names],
        ["model", "BPM", *(run.model.upper() for run in runs)],
        ["F0 [N/m]", "100", *(text_of(run.force) for run in runs)],
        [
            "<a0> [mm]",
            "0.2",
            *(text_of(run.mean_diameter and 1e3 * run.mean_diameter) for run in runs),
        ],
    ]
    for name, text in CONSTANTS.items():
        rows.append(
            [text, text_of(THESIS.get(name)), *(text_of(run.constants[name]) for run in runs)]
        )
    return markdown(rows)


def numbers_of(runs):
    """The same for programs."""
    return {
        "thesis": THESIS,
        "runs": [
            {
                "directory": run.directory,
                "model": run.model,
                "force_at_contact_N_per_m": run.force,
                "diameters_m": run.diameters,
                "mean_diameter_m": run.mean_diameter,
                "largest_strain": float(run.loading[0][-1]),
                "constants": run.constants,
                "r_squared": run.quality,
            }
            for run in runs
        ],
    }


def main(words):
    options = parser_of("thesis-3", __doc__, EPILOG, 200).parse_args(words)
    runs = [read_run(directory) for directory in options.directories]
    compare_slopes(runs)
    draw_all(FIGURES, runs, options)
    write_constants(table_of(runs), numbers_of(runs), options)
    warn_of_poor_fits("thesis-3", runs, CONSTANTS)
    return 0
