# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints rubber.output: textbook forms of incompressible rubber in tension and simple shear."""
from math import sqrt

stretch, gamma, mu = 2.5, 1.5, 1e6 / 2.98


def by_invariants(name, slopes):
    """slopes(I1 - 3): derivatives of the energy by I1 and I2; Treloar, The Physics of Rubber Elasticity, chapter 10."""
    first, second = slopes(stretch**2 + 2 / stretch - 3)
    print(name, "uniaxial", f"{2 * (stretch**2 - 1 / stretch) * (first + second / stretch):.10g}")
    first, second = slopes(2 * stretch**2 + stretch**-4 - 3)
    print(name, "equibiaxial", f"{2 * (stretch**2 - stretch**-4) * (first + second * stretch**2):.10g}")
    first, second = slopes(gamma**2)
    print(name, "shear", f"{2 * (first + second) * gamma:.10g} {2 * (first + second) * gamma**2:.10g}")


def ogden(exponents, weights):
    """mu_p of the textbook = 2 mu weight / (sum of weights) / exponent."""
    terms = [(2 * mu * w / sum(weights) / a, a) for a, w in zip(exponents, weights)]
    print("ogden uniaxial", f"{sum(m * (stretch**a - stretch**(-a / 2)) for m, a in terms):.10g}")
    print("ogden equibiaxial", f"{sum(m * (stretch**a - stretch**(-2 * a)) for m, a in terms):.10g}")
    # simple shear: stretches l and 1/l with l - 1/l = gamma, first direction at tan = 1/l against x
    large = gamma / 2 + sqrt(1 + gamma**2 / 4)
    difference = sum(m * (large**a - large**-a) for m, a in terms)
    cosine2 = large**2 / (1 + large**2)
    sine_cosine = large / (1 + large**2)
    print("ogden shear", f"{difference * sine_cosine:.10g} {difference * (2 * cosine2 - 1):.10g}")


print("# tolerance: 1e-12 1e-8")
by_invariants("mooney_rivlin", lambda x: (mu / 2 * 0.7, mu / 2 * 0.3))
by_invariants("gent", lambda x: (mu / 2 * 30 / (30 - x), 0))
by_invariants("yeoh", lambda x: (mu / 2 * (1 - 0.04 * x + 0.0012 * x**2), 0))
ogden((1.3, 5, -2), (8.19, 0.06, 0.2))
for distance in "0.1", "0.001", "1e-06":
    print("gent at a distance of", distance, "from locking: 1")
for shear, good in (2, 0), (2.1, 0), (10, 0):
    print(f"gent, shear {shear}, good points: {good}")
print("mooney_rivlin, stress in the plane depends on the share: no")
print("mooney_rivlin, stress out of plane depends on the share: yes")
