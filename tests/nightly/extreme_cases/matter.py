# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compressibility, contrasts of stiffness and density, friction."""
from .case import HARD, LAW, OTHER, RIGHT, STOPPED, Case, cases_of, force_about, met
from .scenes import BONDED_GRAINS, GRAINS, ONE, TWO


def cases():
    for nu in (0, 0.3, 0.45, 0.49, 0.4999):
        yield Case(f"one disk: Poisson's ratio {nu}", ONE, (f"{LAW}Poisson's ratio={nu}",), length=1e-3,
                   checks={"Johnson's force": force_about(385 / (1 - nu * nu), 0.07)},
                   quick=nu in (0, 0.4999))
    yield from cases_of(TWO, 1e-3, "stiffness contrast", [
        (f"{contrast:g}", [f"{OTHER}Young's modulus={1e6 * contrast}", "Time/Time step=4e-5"],
         {"checks": {"they meet": met}, "limits": HARD, "expected": (RIGHT,) if contrast < 1e5 else (RIGHT, STOPPED)})
        for contrast in (1, 100, 1e4, 1e6, 1e8)])
    yield from cases_of(TWO, 1e-3, "density contrast", [
        (f"{contrast:g}", [f"Materials/other/Density={1000 * contrast}", "Time/Time step=4e-5"],
         {"limits": HARD, "expected": (RIGHT,) if contrast == 100 else (RIGHT, STOPPED)}) for contrast in (1e-6, 100, 1e6)])
    for friction in (0, 0.5, 10):
        yield Case(f"eight grains: friction {friction}", GRAINS, (f"Contact/Friction={friction}",), length=3.2e-4,
                   limits={"energy": 0.1})
        yield Case(f"bonded grains: friction {friction}", BONDED_GRAINS, (f"Contact/Friction={friction}",),
                   length=2.5e-4, limits={"energy": 0.2}, quick=friction == 10)
