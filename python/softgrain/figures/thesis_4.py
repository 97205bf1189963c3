# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draws figures 4.1-4.5 and 4.8-4.11 of Nguyen (2016) from compaction runs, and fits its laws to them.
"""

from __future__ import annotations

import numpy as np

from .. import InputError, fits
from ..drawing import INK
from . import grains
from .compaction import (
    CONSTANTS,
    PACKINGS,
    densities,
    gamma_near,
    groups_of,
    mean_and_spread,
    read_run,
)
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

COLOURS = {"mpm": ("#0072B2", "#56B4E9"), "bpm": ("#D55E00", "#E69F00")}
PACKING_COLOURS = ("#0072B2", "#009E73", "#E69F00", "#D55E00")
REGIMES = (0.78, 0.95)  # of the thesis


EPILOG = """\
Runs of one model and friction are one group: their constants are given as mean and spread. The
runs need the walls bottom, top, left and right, Output/Snapshots every, and Output/Measures = all
(or 'softgrain measure DIR' afterwards).

examples:
  softgrain figures thesis-4 output/uniaxial_compaction_*
  softgrain figures thesis-4 mpm mpm_friction bpm bpm_friction --output doc/pictures --format svg
"""


def parse_arguments(words):
    parser = parser_of("thesis-4", __doc__, EPILOG, 200, FIGURES)
    parser.add_argument(
        "--reference",
        type=float,
        default=0.8,
        metavar="PHI",
        help="packing fraction of the reference state (default: %(default)s)",
    )
    options = parser.parse_args(words)
    if not 0 < options.reference < 1:
        raise InputError("--reference must be between 0 and 1")
    return options


def style_of(run, markers=False):
    """Colour by model, dashes and open markers with friction."""
    rough = run.friction > 0
    colour = COLOURS.get(run.model, COLOURS["bpm"])[rough]
    result = {
        "color": colour,
        "linewidth": 1.5,
        "linestyle": (0, (4, 1.5)) if rough else "-",
        "zorder": 3,
    }
    if markers:
        result.update(
            marker="s" if rough else "o",
            markersize=3.2,
            linewidth=0.8,
            markerfacecolor="white" if rough else colour,
        )
    return result


def labelled(groups):
    """Every run with the text for the legend, given once for each group."""
    for group in groups:
        for position, run in enumerate(group):
            yield run, run.label if position == 0 else None


def references(groups):
    """(run, label, normalised curve) of the runs that pass through the reference state."""
    found = [
        (run, label, run.normalised()) for run, label in labelled(groups) if run.reference_stress
    ]
    if not found:
        raise NotDrawn("no run carries stress at the reference packing")
    return found


def stress_against_strain(groups):
    figure, (axes,) = axes_of("Fig. 4.2: stress over that of the reference state")
    for run, label, (strain, stress, packing) in references(groups):
        shown = packing >= run.reference
        axes.plot(strain[shown], stress[shown], label=label, **style_of(run))
    for group in groups:
        found = mean_and_spread(group, "beta")
        if found and group[0].model == "mpm" and group[0].friction == 0:
            end = axes.get_xlim()[1]
            axes.plot(
                [0, end],
                [1, 1 + found[0] * end],
                color=INK,
                linewidth=0.9,
                linestyle=":",
                zorder=2,
                label=f"(4.3), β = {found[0]:.3g} (thesis: 10)",
            )
    finish(
        axes,
        "strain since the reference state $\\varepsilon'$",
        "$\\sigma/\\sigma_0$",
        xlim=(0, None),
    )
    return figure


def packing_against_stress(groups):
    figure, (axes,) = axes_of("Fig. 4.3: packing fraction against stress")
    for run, label, (_, stress, packing) in references(groups):
        shown = packing >= run.reference
        axes.plot(stress[shown], packing[shown], label=label, **style_of(run, markers=True))
    ends = axes.get_xlim()
    stress = np.linspace(1, max(1.01, ends[1]), 200)
    for group in groups:
        run = group[0]
        if run.friction > 0:
            continue
        if run.model == "mpm" and (found := mean_and_spread(group, "packing_slope")):
            line = run.reference + found[0] * (stress - 1)
            axes.plot(
                stress[line <= 1],
                line[line <= 1],
                color=INK,
                linewidth=0.9,
                linestyle=":",
                zorder=2,
                label=f"(4.5), $\\Phi_0/\\beta$ = {found[0]:.3g} (thesis: 0.08)",
            )
        elif run.model != "mpm" and (found := mean_and_spread(group, "alpha")):
            axes.plot(
                stress,
                1 - (1 - run.reference) * np.exp(-found[0] * (stress - 1)),
                color=INK,
                linewidth=0.9,
                zorder=2,
                label=f"(4.1), α = {found[0]:.3g} (thesis: 0.27)",
            )
    finish(axes, "$\\sigma/\\sigma_0$", "packing fraction $\\Phi$", xlim=ends, ylim=(None, 1.005))
    return figure


def against(axes, groups, x, y, name_of_measure):
    """Draws one measure against another of every run that has both."""
    drawn = False
    for run, label in labelled(groups):
        if found := run.measured(x, y):
            axes.plot(*found, label=label, **style_of(run, markers=True))
            drawn = True
    if not drawn:
        raise NotDrawn(
            f"no run has the measure '{name_of_measure}' in measures.csv (softgrain measure DIR)"
        )


def coordination_and_packing(groups):
    figure, (left, right) = axes_of(
        "Fig. 4.4: coordination number and packing fraction against strain", 2
    )
    against(left, groups, "axial_strain", "coordination_of_bodies", "coordination")
    for run, label in labelled(groups):
        right.plot(*fits.means(run.strain, run.packing, 0.002), label=label, **style_of(run))
    found = mean_and_spread([run for group in groups for run in group], "initial_packing")
    strain = np.linspace(0, max(run.strain.max() for group in groups for run in group), 100)
    right.plot(
        strain,
        found[0] * np.exp(strain),
        color=INK,
        linewidth=0.9,
        linestyle=":",
        zorder=2,
        label=f"{found[0]:.3f} exp ε (thesis: 0.7)",
    )
    finish(left, "axial strain $\\varepsilon$", "coordination number $Z$", ylim=(0, None))
    finish(right, "axial strain $\\varepsilon$", "packing fraction $\\Phi$")
    return figure


def collapse_of_coordination(groups):
    figure, (axes,) = axes_of("Fig. 4.5: coordination number against packing fraction")
    drawn = False
    for run, label in labelled(groups):
        lower, upper = (
            run.constants["coordination_at_reference"],
            run.constants["coordination_when_full"],
        )
        if None in (lower, upper):
            continue
        packing, coordination = run.measured("packing_fraction", "coordination_of_bodies")
        shown = packing >= run.reference
        exponent = run.constants["coordination_exponent"]
        axes.plot(
            packing[shown],
            (coordination[shown] - lower) / (upper - lower),
            label=label and f"{label}: exponent {exponent:.2f}, $Z_1$ = {upper:.2f}",
            **{**style_of(run, markers=True), "linestyle": "none"},
        )
        drawn, reference = True, run.reference
    if not drawn:
        raise NotDrawn("no run has the measure 'coordination' above the reference packing")
    packing = np.linspace(reference, 1, 300)
    axes.plot(
        packing,
        ((packing - reference) / (1 - reference)) ** 0.5,
        color=INK,
        linewidth=1,
        label="$(\\Phi - \\Phi_0)^{0.5}$ (thesis)",
        zorder=2,
    )
    finish(axes, "packing fraction $\\Phi$", "$(Z - Z_0)/(Z_1 - Z_0)$", ylim=(-0.1, 1.2))
    return figure


def panels_against_packing(title, groups, measures):
    figure, panels = axes_of(title, len(measures))
    for axes, (column, text, measure) in zip(panels, measures):
        against(axes, groups, "packing_fraction", column, measure)
        for limit in REGIMES:
            axes.axvline(limit, color=INK, linewidth=0.7, linestyle=":")
        finish(axes, "packing fraction $\\Phi$", text)
    return figure


def shapes(groups):
    return panels_against_packing(
        "Fig. 4.8: contact surface, orientation and aspect ratio (dotted: regimes of the thesis)",
        groups,
        (
            ("specific_contact_surface", "specific contact surface $S$", "contact_surface"),
            ("orientation_anisotropy", "orientation anisotropy $A_m$", "shape"),
            ("aspect_ratio", "aspect ratio $\\alpha$", "shape"),
        ),
    )


def shape_strains(groups):
    return panels_against_packing(
        "Fig. 4.9: strain and anisotropy of the particles (dotted: regimes of the thesis)",
        groups,
        (("shape_strain", "$\\eta$", "shape"), ("shape_anisotropy", "$A_\\eta$", "shape")),
    )


def forces(groups, model, number, thesis):
    chosen = [group for group in groups if (group[0].model == "mpm") == (model == "mpm")]
    if not chosen:
        raise NotDrawn(f"there is no run by {model.upper()}")
    figure, panels = axes_of(f"Fig. {number}: normal forces, {model.upper()}", len(chosen))
    drawn = False
    for axes, group in zip(panels, chosen):
        for packing, colour, marker in zip(PACKINGS, PACKING_COLOURS, "os^D"):
            found = [d for d in (densities(run, packing) for run in group) if d]
            if not found:
                continue
            density = np.mean([d[1] for d in found], axis=0)
            shown = density > 0
            axes.semilogy(
                found[0][0][shown],
                density[shown],
                color=colour,
                marker=marker,
                markersize=4,
                linewidth=0.8,
                label=f"Φ = {packing:.2f}",
                zorder=3,
            )
            drawn = True
        gammas = [g for g in (gamma_near(run, PACKINGS[0]) for run in group) if g is not None]
        if gammas:
            force, gamma = np.linspace(0, 4, 200), float(np.mean(gammas))
            axes.semilogy(
                force,
                fits.force_density(force, gamma),
                color=INK,
                linewidth=1.1,
                zorder=2,
                label=f"(2.32), γ = {gamma:.2g} (thesis: {thesis})",
            )
        finish(
            axes,
            "normal force over its mean",
            "probability density",
            ylim=(5e-3, 3),
            title=group[0].label,
        )
    if not drawn:
        raise NotDrawn("no run has the measure 'forces' near these packing fractions")
    return figure


FIGURES = {
    "4.1": grains.states,
    "4.2": stress_against_strain,
    "4.3": packing_against_stress,
    "4.4": coordination_and_packing,
    "4.5": collapse_of_coordination,
    "4.8": shapes,
    "4.9": shape_strains,
    "4.10": lambda groups: forces(groups, "bpm", "4.10", 0.25),
    "4.11": lambda groups: forces(groups, "mpm", "4.11", 0.15),
}


def text_of(found):
    """Mean, and spread when there are several runs."""
    if found is None:
        return "-"
    mean, spread, n = found
    return f"{mean:.4g} ± {spread:.2g}" if n > 1 else f"{mean:.4g}"


def table_of(groups):
    """The constants as a Markdown table, those of the thesis beside ours."""
    head = ["", "thesis, MPM", "thesis, BPM"]
    head += [
        group[0].label + (f" ({len(group)} runs)" if len(group) > 1 else "") for group in groups
    ]
    rows = [head]
    for name, (text, mpm, bpm) in CONSTANTS.items():
        values = ["-" if value is None else f"{value:g}" for value in (mpm, bpm)]
        rows.append([text, *values, *(text_of(mean_and_spread(group, name)) for group in groups)])
    return markdown(rows)


def numbers_of(groups, reference):
    """The same for programs."""
    result = {
        "reference_packing": reference,
        "thesis": {
            name: {"mpm": mpm, "bpm": bpm}
            for name, (_, mpm, bpm) in CONSTANTS.items()
            if (mpm, bpm) != (None, None)
        },
        "groups": [],
    }
    for group in groups:
        found = {name: mean_and_spread(group, name) for name in CONSTANTS}
        result["groups"].append(
            {
                "model": group[0].model,
                "friction": group[0].friction,
                "mean": {name: value and value[0] for name, value in found.items()},
                "spread": {
                    name: value[1] if value and value[2] > 1 else None
                    for name, value in found.items()
                },
                "runs": [
                    {
                        "directory": run.directory,
                        "constants": run.constants,
                        "r_squared": run.quality,
                    }
                    for run in group
                ],
            }
        )
    return result


def main(words):
    options = parse_arguments(words)
    runs = [read_run(directory, options.reference) for directory in options.directories]
    groups = groups_of(runs)
    draw_all(FIGURES, groups, options)
    write_constants(table_of(groups), numbers_of(groups, options.reference), options)
    warn_of_poor_fits("thesis-4", runs, {name: text for name, (text, *_) in CONSTANTS.items()})
    return 0
