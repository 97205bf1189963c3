# SPDX-License-Identifier: LGPL-2.1-or-later
"""The insides of bodies in a picture: plain, in colours of their own, or by a field."""

import numpy as np
from matplotlib.collections import PathCollection

from . import drawing, primaries


def fill(picture, axes, state, rings, numbers, points_per_metre):
    """The insides of the bodies."""
    if picture.scale:
        fill_by_scale(picture, axes, state, rings)
    elif numbers is not None:
        style = picture.options.style or ("disks" if picture.primaries else "smooth")
        if style == "disks" and state.has("points") or not rings:
            primaries.draw_points_of_bodies(
                axes, state.points, numbers, picture.colours, points_per_metre
            )
        else:
            primaries.draw_bodies(axes, rings, numbers, picture.colours)
    elif rings:
        paths = [drawing.outline_path(body_rings) for body_rings in rings.values()]
        axes.add_collection(PathCollection(paths, facecolors="#dfe6ee", linewidths=0, zorder=2))


def fill_by_scale(picture, axes, state, rings):
    scale, values = picture.scale, picture.scale.values(state)
    if scale.field.part == "contact_pressures":
        axes.add_collection(
            PathCollection(
                [drawing.outline_path(rings[body]) for body in rings],
                facecolors="#dfe6ee",
                linewidths=0,
                zorder=2,
            )
        )
        drawing.draw_along_contacts(
            axes,
            state.contact_pressures,
            values,
            scale.norm,
            scale.map,
            float(np.clip(16 * min(picture.magnified, 4) / np.sqrt(max(1, len(rings))), 2.5, 6.0)),
        )
        return
    if scale.field.part == "bodies":
        value_of = {int(body): value for body, value in zip(state.bodies["body"], values)}
        coloured = [body for body in rings if body in value_of]
        axes.add_collection(
            PathCollection(
                [drawing.outline_path(rings[body]) for body in coloured],
                linewidths=0,
                zorder=2,
                facecolors=scale.map(scale.norm(np.array([value_of[body] for body in coloured]))),
            )
        )
        return
    points = state.points
    areas = points["area_m2"] if "area_m2" in points else np.ones(len(points))
    continuum = "deformation_gradient" in points or "stress_zz_Pa" in points
    style = picture.options.style or ("smooth" if continuum and not picture.primaries else "disks")
    if style == "smooth" and rings:
        shown = {body: r for body, r in rings.items() if picture.in_view(r[0])}
        drawing.draw_smooth(
            axes, shown, points["position_m"], points["body"], values, areas, scale.norm, scale.map
        )
    else:
        drawing.draw_disks(axes, points["position_m"], values, areas, scale.norm, scale.map)
    axes.set_xlim(picture.low[0], picture.high[0])
    axes.set_ylim(picture.low[1], picture.high[1])
