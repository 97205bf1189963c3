# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Closed formulas to lay beside computed curves: a disk between two rigid walls, plane strain, no
friction.
"""

import numpy as np


def hertz(strain, young, poisson, radius):
    """
    Force per length [N/m] at the strain ln(h0/h) by Nguyen (2016), eq. (3.31): F = (π/4) E/(1-ν²) R
    ε.

    Meant for small strain; the thesis sees the computed curve leave it for ε > 0.05.
    """
    return np.pi / 4 * young / (1 - poisson**2) * radius * strain


def johnson(strain, young, poisson, radius):
    """
    Force per length [N/m] at the strain ln(h0/h) for line contact, K. L. Johnson, Contact Mechanics
    (1985), §5.6: each side approaches the centre by δ = F (1-ν²)/(π E) (2 ln(4R/a) - 1), with a² =
    4 F R (1-ν²)/(π E).

    Small strain as well; NaN where the half width a of the contact would be above R.
    """
    reduced = np.concatenate(
        [[0.0], np.geomspace(1e-12, 0.25, 4000)]
    )  # F (1-ν²)/(π E R); 1/4 is a = R
    approach = np.zeros_like(reduced)
    f = reduced[1:]
    approach[1:] = f * (2 * np.log(4 / (2 * np.sqrt(f))) - 1)
    strains = -np.log(1 - approach)
    return (
        np.interp(strain, strains, reduced, right=np.nan)
        * np.pi
        * young
        * radius
        / (1 - poisson**2)
    )


THEORIES = {
    "hertz": (hertz, r"$F = \frac{\pi}{4}\,\frac{E}{1-\nu^2}\,R\,\varepsilon$, thesis (3.31)"),
    "johnson": (johnson, "line contact, Johnson (1985)"),
}
