# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draws figures 5.2-5.5 and 5.7-5.23 of Nguyen (2016) from paths of isotropic and biaxial compression,
and fits its laws.
"""

from __future__ import annotations

from functools import partial

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.tri import Triangulation

from ..drawing import INK
from .grains import draw_grains, read_frame
from .paths import (
    CONSTANTS,
    constants_of,
    groups_of,
    isotropic_line,
    not_fitted,
    read_path,
    states_at,
    void_line,
)
from .tool import NotDrawn, draw_all, parser_of, write_constants
from .tool import finish as finish_panel

COLOURS = ("#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00", "#CC79A7", "#1a1a1a")
MARKERS = "os^Dv<>p"
EPS_Q = "shear strain $\\varepsilon_q$"
STRAINS = (0.0, 0.2, 0.5, 0.8)  # of the pictures


EPILOG = """\
Each run is a path of stages: the walls top and right under pressure, then top driven down (and up
again) while right keeps its pressure. Runs of one model, friction and number of grains are one
group, and laws are fitted to groups of three pressures and more. They need Output/Snapshots every
and Output/Measures = all (or 'softgrain measure DIR' afterwards).

examples:
  softgrain figures thesis-5 output/biaxial_*
  softgrain figures thesis-5 bpm-0.2 bpm-0.4 bpm-0.8 --output doc/pictures --format svg
"""


def panels(title, groups, height=3.9):
    """One pair of axes for every group of runs."""
    figure, axes = plt.subplots(
        1,
        len(groups),
        squeeze=False,
        constrained_layout=True,
        figsize=(0.6 + 4.4 * len(groups), height),
    )
    for one, group in zip(axes[0], groups):
        one.grid(color="#d9d9d9", linewidth=0.6, zorder=0)
        one.set_axisbelow(True)
        one.set_title(group[0].group, fontsize=10)
    figure.suptitle(title, fontsize=11)
    return figure, list(zip(axes[0], groups))


def finish(axes, x, y, **limits):
    finish_panel(axes, x, y, fontsize=8, **limits)


def pressure_of(path):
    return f"{path.pressure / 1e6:.3g} MPa ({path.kappa:.2g})"


def styles(group):
    """Every run with its style: a colour for each pressure."""
    seen: list[float] = []
    for path in group:
        if not any(abs(path.pressure / other - 1) < 0.05 for other in seen):
            seen.append(path.pressure)
            label = pressure_of(path)
        else:
            label = None
        n = len(seen) - 1
        yield path, {
            "color": COLOURS[n % len(COLOURS)],
            "marker": MARKERS[n % len(MARKERS)],
            "markersize": 2.6,
            "linewidth": 0.9,
            "label": label,
        }


# --- isotropic states ---

ISOTROPIC = {
    "5.2": ("packing_fraction", "packing fraction $\\Phi$", "Φ"),
    "5.3": ("void_ratio", "void ratio $e$", "e"),
    "5.4": ("coordination_of_bodies", "coordination number $Z$", "Z"),
}


def against_pressure(groups, number):
    column, text, symbol = ISOTROPIC[number]
    start, slope = (
        list(CONSTANTS.values())[2 * list(ISOTROPIC).index(number) + k][1] for k in (0, 1)
    )
    slope = -slope if number == "5.3" else slope
    figure, pairs = panels(f"Fig. {number}: isotropic states", groups)
    for axes, group in pairs:
        kappa = np.array([path.kappa for path in group])
        axes.semilogx(
            kappa,
            [path.isotropic[column] for path in group],
            "o",
            color=COLOURS[0],
            markersize=4,
            zorder=3,
        )
        ends = np.array([kappa.min() / 1.2, kappa.max() * 1.2])
        if found := isotropic_line(group, column):
            axes.semilogx(
                ends,
                found[0] + found[1] * np.log10(ends),
                color=COLOURS[0],
                linewidth=0.9,
                label=f"{symbol} = {found[0]:.3g} {found[1]:+.2g} log10(p/p_I)",
            )
        if group[0].model == "bpm":
            axes.semilogx(
                ends,
                start + slope * np.log10(ends),
                color=INK,
                linestyle=":",
                linewidth=1,
                label=f"thesis: {start:g} {slope:+g} log10(p/p_I)",
            )
        finish(axes, "$p_c$ over stiffness", text)
    return figure


def coordination_and_voids(groups):
    figure, pairs = panels("Fig. 5.5: isotropic states", groups)
    for axes, group in pairs:
        e, z = (
            [path.isotropic[name] for path in group]
            for name in ("void_ratio", "coordination_of_bodies")
        )
        axes.plot(e, z, "o", color=COLOURS[0], markersize=4, zorder=3)
        if found := void_line(group):
            ends = np.array([min(e), max(e)])
            axes.plot(
                ends,
                found[0] + found[1] * ends,
                color=COLOURS[0],
                linewidth=0.9,
                label=f"slope {found[1]:.2g} (thesis, BPM: -7.3)",
            )
        finish(axes, "void ratio $e$", "coordination number $Z$")
    return figure


# --- shear ---


def curves(groups, number, title, x, y, labels, scale=1.0):
    """One column of the shear stage against another, a curve for every run."""
    figure, pairs = panels(f"Fig. {number}: {title}", groups)
    drawn = False
    for axes, group in pairs:
        for path, style in styles(group):
            if x in path.shear and y in path.shear:
                axes.plot(
                    path.shear[x] * (scale if x.endswith("Pa") else 1),
                    path.shear[y] * scale,
                    **style,
                )
                drawn = True
        finish(axes, *labels)
    if not drawn:
        raise NotDrawn(f"no run has a shear stage with the column {y}")
    return figure


SHEAR = {
    "5.8": ("deviator over mean pressure", "wall_stress_ratio", "$q/p$", 1.0),
    "5.9": ("mean pressure", "wall_pressure_Pa", "$p$ [MPa]", 1e-6),
    "5.10": ("packing fraction", "packing_fraction", "packing fraction $\\Phi$", 1.0),
    "5.11": ("volume strain, contraction positive", "volume_strain", "$\\varepsilon_v$", 1.0),
    "5.16": ("coordination number", "coordination_of_bodies", "$Z$", 1.0),
    "5.17": ("specific contact surface", "specific_contact_surface", "$S$", 1.0),
    "5.18": ("shape of the grains", "shape_strain", "$\\eta$", 1.0),
    "5.19": ("anisotropy of shapes", "shape_anisotropy", "$A_\\eta$", 1.0),
    "5.20": ("anisotropy of contacts", "contact_anisotropy", "$a_c$", 1.0),
    "5.21": ("anisotropy of normal forces", "normal_force_anisotropy", "$a_f$", 1.0),
}


def against_strain(groups, number):
    title, column, text, scale = SHEAR[number]
    return curves(groups, number, title, "shear_strain", column, (EPS_Q, text), scale)


def stress_path(groups):
    figure = curves(
        groups,
        "5.7",
        "stress path",
        "wall_pressure_Pa",
        "wall_deviator_Pa",
        ("$p$ [MPa]", "$q$ [MPa]"),
        1e-6,
    )
    for axes, group in zip(figure.axes, groups):
        for path, style in styles(group):
            if path.shear:
                end = np.nanmax(path.shear["wall_pressure_Pa"]) / 1e6
                axes.plot(
                    [path.pressure / 1e6, end],
                    [0, end - path.pressure / 1e6],
                    color=style["color"],
                    linestyle=":",
                    linewidth=0.8,
                )
    return figure


def void_ratios(groups):
    figure, pairs = panels("Fig. 5.12: void ratio, isotropic (filled) and steady (open)", groups)
    for axes, group in pairs:
        axes.semilogx(
            [path.kappa for path in group],
            [path.isotropic["void_ratio"] for path in group],
            "o",
            color=COLOURS[0],
            markersize=4,
            label="isotropic",
        )
        steady = [
            (path.kappa, *found)
            for path in group
            if path.shear and (found := path.steady("void_ratio"))
        ]
        if steady:
            axes.errorbar(
                *zip(*((k, e) for k, e, _ in steady)),
                yerr=[s for _, _, s in steady],
                fmt="s",
                color=COLOURS[4],
                markerfacecolor="white",
                markersize=4,
                linewidth=0.8,
                label="steady",
            )
        finish(axes, "$p_c$ over stiffness", "void ratio $e$")
    return figure


def prediction(groups):
    figure, pairs = panels("Fig. 5.22: anisotropies against q/p (5.16)", groups)
    drawn = False
    for axes, group in pairs:
        for path, style in styles(group):
            if path.shear and path.anisotropies() is not None:
                # Anisotropies have no sign: that of q is lost, too.
                axes.plot(
                    np.abs(path.shear["wall_stress_ratio"]),
                    path.anisotropies(),
                    **{**style, "linestyle": "none"},
                )
                drawn = True
        ends = axes.get_xlim()
        axes.plot(ends, ends, color=INK, linewidth=0.8, linestyle=":")
        with_friction = group[0].friction > 0
        finish(axes, "$|q/p|$", "$(a_c + a_f + a_t)/2$" if with_friction else "$(a_c + a_f)/2$")
    if not drawn:
        raise NotDrawn("no run has a shear stage with the measure 'fabric'")
    return figure


def unloading(groups):
    chosen = [[path for path in group if path.unloading] for group in groups]
    chosen = [group for group in chosen if group]
    if not chosen:
        raise NotDrawn("no run has a stage in which the upper wall is driven a second time")
    figure, pairs = panels("Fig. 5.23: loading and unloading", chosen)
    for axes, group in pairs:
        for path, style in styles(group):
            for part in (path.shear, path.unloading):
                axes.plot(
                    part["shear_strain"], part["wall_stress_ratio"], **{**style, "label": None}
                )
            axes.plot([], [], **style)
        axes.axhline(0, color=INK, linewidth=0.6)
        finish(axes, EPS_Q, "$q/p$")
    return figure


# --- pictures ---


def pictured(groups):
    """Runs with snapshots in their shear stage, and which."""
    found = [
        (path, states) for group in groups for path in group if (states := states_at(path, STRAINS))
    ]
    if not found:
        raise NotDrawn("no run has snapshots.h5 in its shear stage")
    return found


def rows_of_pictures(found, title, draw):
    n = max(len(states) for _, states in found)
    figure, axes = plt.subplots(
        len(found),
        n,
        squeeze=False,
        constrained_layout=True,
        figsize=(0.4 + 2.7 * n, 0.5 + 2.6 * len(found)),
    )
    for (path, states), row in zip(found, axes):
        for one in row:
            one.axis("off")
        for k, (one, (_, strain)) in enumerate(zip(row, states)):
            draw(one, path, states, k)
            one.set_title(
                f"{path.group}, {pressure_of(path)}, $\\varepsilon_q$ = {strain:.2f}", fontsize=7
            )
    figure.suptitle(title, fontsize=11)
    return figure


def snapshots_of_shear(groups):
    def draw(axes, path, states, k):
        draw_grains(
            axes, read_frame(path.output.snapshots[states[k][0]]), path.model != "mpm", False
        )

    return rows_of_pictures(
        pictured(groups), "Figs. 5.13-5.15: states of biaxial compression", draw
    )


def local_shear(before, after):
    """
    Triangles between the centres before, and the shear strain of each until after: e1 - e2 of its
    small strain.
    """
    mesh = Triangulation(*before.T)
    corner, moved = before[mesh.triangles], after[mesh.triangles]
    old = np.stack([corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]], axis=2)
    new = np.stack([moved[:, 1] - moved[:, 0], moved[:, 2] - moved[:, 0]], axis=2)
    # Slivers between bodies at the rim have no strain to speak of.
    sides = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2)
    slim = np.abs(np.linalg.det(old)) < 0.15 * sides.max(axis=1) ** 2
    mesh.set_mask(slim)
    gradient = np.zeros_like(old)
    gradient[~slim] = new[~slim] @ np.linalg.inv(old[~slim])
    stretch = np.linalg.svd(gradient[~slim], compute_uv=False)
    shear = np.full(len(slim), np.nan)
    shear[~slim] = np.log(np.maximum(stretch[:, 0], 1e-12) / np.maximum(stretch[:, 1], 1e-12))
    return mesh, shear


def shear_bands(groups):
    """
    Logarithmic shear strain between the centres of neighbouring grains since the picture before.
    """
    found = [(path, states) for path, states in pictured(groups) if len(states) > 1]
    if not found:
        raise NotDrawn("no run has two snapshots in its shear stage")

    def draw(axes, path, states, k):
        if k == 0:
            return
        before, after = (path.output.snapshots[states[j][0]] for j in (k - 1, k))
        mesh, shear = local_shear(before.bodies["center_m"], after.bodies["center_m"])
        mean = states[k][1] - states[k - 1][1]
        moved = Triangulation(*after.bodies["center_m"].T, mesh.triangles, mesh.mask)
        axes.tripcolor(
            moved,
            facecolors=np.clip(np.nan_to_num(shear) / mean, 0, 4),
            cmap="magma_r",
            vmin=0,
            vmax=4,
        )
        axes.set_aspect("equal")

    return rows_of_pictures(
        found,
        "Local shear strain since the picture before, over its mean (white 0, black 4 and more)",
        draw,
    )


FIGURES = {
    **{number: partial(against_pressure, number=number) for number in ISOTROPIC},
    "5.5": coordination_and_voids,
    "5.7": stress_path,
    **{number: partial(against_strain, number=number) for number in SHEAR},
    "5.12": void_ratios,
    "5.13": snapshots_of_shear,
    "5.22": prediction,
    "5.23": unloading,
    "bands": shear_bands,
}


def table_of(groups):
    """Constants as Markdown, those of the thesis beside ours, and the steady state of every run."""
    lines = [
        "| | thesis, BPM | "
        + " | ".join(f"{group[0].group} ({len(group)} runs)" for group in groups)
        + " |",
        "|---" * (2 + len(groups)) + "|",
    ]
    numbers = [constants_of(group) for group in groups]
    for name, (text, thesis) in CONSTANTS.items():
        lines.append(
            f"| {text} | {thesis:.3g} | "
            + " | ".join("-" if n[name] is None else f"{n[name]:.3g}" for n in numbers)
            + " |"
        )
    lines += [
        "",
        (
            "| run | p_c [MPa] | p_c/p_I | Φ | Z | ε_q reached | q/p, steady | largest over steady"
            " | Φ, steady | Z, steady | r.m.s. of (5.16) |"
        ),
        "|---" * 11 + "|",
    ]
    for path in (path for group in groups for path in group):

        def steady(name, path=path):
            found = path.steady(name) if path.shear else None
            return "-" if found is None else f"{found[0]:.3f} ± {found[1]:.3f}"

        peak = path.peak() if path.shear else None
        predicted = path.anisotropies() if path.shear else None
        off = "-"
        if predicted is not None:
            missed = predicted - np.abs(path.shear["wall_stress_ratio"])
            off = f"{np.sqrt(np.nanmean(missed**2)):.3f}"
        reached = f"{path.shear['shear_strain'][-1]:.2f}" if path.shear else "-"
        lines.append(
            f"| {path.group} | {path.pressure / 1e6:.3g} | {path.kappa:.3g} |"
            f" {path.isotropic['packing_fraction']:.3f} |"
            f" {path.isotropic['coordination_of_bodies']:.2f} | {reached} |"
            f" {steady('wall_stress_ratio')} | {'-' if peak is None else f'{peak:.2f}'} |"
            f" {steady('packing_fraction')} | {steady('coordination_of_bodies')} | {off} |"
        )
    return "\n".join(lines) + "\n"


def numbers_of(groups):
    """The same for programs."""
    return {
        "thesis": {name: value for name, (_, value) in CONSTANTS.items()},
        "groups": [
            {
                "model": group[0].model,
                "friction": group[0].friction,
                "grains": group[0].grains,
                "constants": constants_of(group),
                "runs": [
                    {
                        "directory": path.output.directory,
                        "pressure_Pa": path.pressure,
                        "kappa": path.kappa,
                        "isotropic": path.isotropic,
                        "steady_stress_ratio": (
                            path.steady("wall_stress_ratio") if path.shear else None
                        ),
                    }
                    for path in group
                ],
            }
            for group in groups
        ],
    }


def main(words):
    options = parser_of("thesis-5", __doc__, EPILOG, 150, FIGURES).parse_args(words)
    groups = groups_of([read_path(directory) for directory in options.directories])
    draw_all(FIGURES, groups, options)
    for group in groups:
        if reason := not_fitted(group):
            print(f"{group[0].group}: (5.2)-(5.5) are not fitted, {reason}")
    write_constants(table_of(groups), numbers_of(groups), options)
    return 0
