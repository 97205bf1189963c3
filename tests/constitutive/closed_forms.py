# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints closed_forms.output: closed forms of the stress in uniaxial strain, pure and simple shear (plane strain)."""
from math import asinh, log, sqrt

stretch, pure, gamma, young = 1.5, 1.25, 0.5, 1e6


def linear(lame, mu, xx, yy, xy):
    """Linear elasticity in the strain (xx, yy, xy): stresses xx, yy, xy, zz and energy."""
    volume = lame * (xx + yy)
    energy = mu * (xx**2 + yy**2 + 2 * xy**2) + lame / 2 * (xx + yy) ** 2
    return volume + 2 * mu * xx, volume + 2 * mu * yy, 2 * mu * xy, volume, energy


def hencky(lame, mu):
    # simple shear: stretches exp(+-asinh(gamma/2)), first direction at half of atan(2/gamma)
    size = asinh(gamma / 2) / sqrt(1 + gamma**2 / 4)
    yield linear(lame, mu, log(stretch), 0, 0)
    yield linear(lame, mu, log(pure), -log(pure), 0)
    yield linear(lame, mu, size * gamma / 2, -size * gamma / 2, size)


def linear_elastic(lame, mu):
    yield linear(lame, mu, stretch - 1, 0, 0)
    yield linear(lame, mu, pure - 1, 1 / pure - 1, 0)
    yield linear(lame, mu, 0, 0, gamma / 2)


def neo_hookean(lame, mu):
    volume = lame * log(stretch)
    energy = mu / 2 * (stretch**2 - 1 - 2 * log(stretch)) + lame / 2 * log(stretch) ** 2
    yield mu * (stretch**2 - 1) + volume, volume, 0, volume, energy
    yield mu * (pure**2 - 1), mu * (pure**-2 - 1), 0, 0, mu / 2 * (pure**2 + pure**-2 - 2)
    yield mu * gamma**2, 0, mu * gamma, 0, mu / 2 * gamma**2


print("# tolerance: 1e-6 1e-10")
for law in hencky, linear_elastic, neo_hookean:
    for nu in 0, 0.3, 0.4999:
        answers = law(young * nu / ((1 + nu) * (1 - 2 * nu)), young / 2 / (1 + nu))
        for case, values in zip(("uniaxial", "pure_shear", "simple_shear"), answers):
            print(law.__name__, nu, case, *(f"{value:.12g}" for value in values))
