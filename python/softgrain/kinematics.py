# SPDX-License-Identifier: LGPL-2.1-or-later
"""What follows from the arrays of a state: pressure, von Mises stress, strains, ends of walls."""

from functools import partial
from typing import Any, Callable, Dict

import numpy as np


def von_mises(stress, out_of_plane=None):
    """
    Von Mises stress of rows xx, yy, xy; without a stress out of the plane that is taken as zero.

    >>> von_mises(np.array([[3., 0., 0.], [0., 0., 1.]])).round(3)
    array([3.   , 1.732])
    """
    x, y, xy = stress.T
    z = 0.0 if out_of_plane is None else out_of_plane
    return np.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3 * xy**2)


def pressure(stress, out_of_plane=None):
    """
    Mean of the normal stresses, compression positive; without a stress out of the plane that of the
    plane.
    """
    total = stress[:, 0] + stress[:, 1]
    return -total / 2 if out_of_plane is None else -(total + out_of_plane) / 3


def component_of(table, number):
    return table["stress_Pa"][:, number]


def add_stresses(table):
    """Columns that a stress gives, where the file does not have them."""
    if "stress_Pa" not in table:
        return
    beyond = (
        (lambda: table["out_of_plane_stress_Pa"])
        if "out_of_plane_stress_Pa" in table
        else lambda: None
    )

    columns: Dict[str, Callable[[], Any]] = {
        "von_mises_Pa": lambda: von_mises(table["stress_Pa"], beyond()),
        "pressure_Pa": lambda: pressure(table["stress_Pa"], beyond()),
    }
    for i, name in enumerate(("xx", "yy", "xy")):
        columns[f"stress_{name}_Pa"] = partial(component_of, table, i)
    if beyond() is not None:
        columns["stress_zz_Pa"] = beyond
    for name, make in columns.items():
        if name not in table:
            table[name] = make


def logarithmic_strains(gradient):
    """
    Logarithms of the two principal stretches, the larger one first, of rows F_xx, F_xy, F_yx, F_yy.

    >>> logarithmic_strains(np.array([[2., 0., 0., 1.]]))[0].round(3)
    array([0.693, 0.   ])
    """
    a, b, c, d = gradient.T
    determinant = a * d - b * c
    # Singular values of F: half the sum and the difference of two lengths.
    sum_, difference = np.hypot(a + d, c - b), np.hypot(a - d, b + c)
    with np.errstate(divide="ignore", invalid="ignore"):
        large = np.log(0.5 * (sum_ + difference))
        return np.stack([large, np.log(determinant) - large], axis=1)


def equivalent_strain(logarithmic):
    """sqrt(2/3 e:e) of the deviator of the logarithmic strain, with no strain out of the plane."""
    full = np.column_stack([logarithmic, np.zeros(len(logarithmic))])
    deviator = full - full.mean(axis=1, keepdims=True)
    return np.sqrt(2 / 3 * (deviator**2).sum(axis=1))


def add_strains(table):
    """Strains of the deformation gradient, where there is one."""
    if "deformation_gradient" not in table:
        return

    def principal():
        return logarithmic_strains(table["deformation_gradient"])

    for name, make in {
        "equivalent_strain": lambda: equivalent_strain(principal()),
        "shear_strain": lambda: 0.5 * (principal()[:, 0] - principal()[:, 1]),
        "volume_strain": lambda: principal().sum(axis=1),
    }.items():
        if name not in table:
            table[name] = make


def wall_ends(walls, vertices):
    """
    The part of every wall that a picture shows: up to the walls it meets, or a little beyond the
    bodies. As wall_segment() of the program, which draws the walls of fields.pvd.
    """
    points, normals = walls["point_m"], walls["normal"]
    result = np.zeros((len(points), 2, 2))
    for w, (origin, normal) in enumerate(zip(points, normals)):
        along = np.array([normal[1], -normal[0]])
        reach = (vertices - origin) @ along if len(vertices) else np.array([-0.5, 0.5])
        begin, end = reach.min(), reach.max()
        extent = end - begin
        first, last = begin - 0.1 * extent, end + 0.1 * extent
        for other in range(len(points)):
            slope = normals[other] @ along
            if other == w or abs(slope) < 1e-10:
                continue
            meeting = (points[other] - origin) @ normals[other] / slope
            if slope > 0 and meeting > begin - 0.5 * extent:
                first = meeting
            elif slope < 0 and meeting < end + 0.5 * extent:
                last = meeting
        result[w] = origin + first * along, origin + last * along
    return result
