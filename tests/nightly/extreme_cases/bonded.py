# SPDX-License-Identifier: LGPL-2.1-or-later
"""Attraction, numbers and sizes of primaries, steps and speeds of bonded grains."""
from .case import ANY, REFUSED, RIGHT, STOPPED, Case, carries, less
from .scenes import BONDED, BONDED_GRAINS


def cases():
    grain = "Materials/grain/Power law/"
    for exponent in (2, 7, 12):
        yield Case(f"bonded grain: exponent {exponent}", BONDED, (f"{grain}Exponent={exponent}",), length=2.5e-4,
                   limits={"energy": 0.2}, checks={"it carries": carries})
    for number in (1, 2):
        yield Case(f"bonded grain: primaries: {number}", BONDED, (f"Primaries/Number per body={number}", "Walls/top/Velocity=0.5"),
                   length=2.5e-4, limits={"energy": 0.3}, expected=(RIGHT, STOPPED), quick=True)
    yield Case("bonded grain: two walls in one place", BONDED, ("Walls/Names=bottom, top, again", "Walls/again/Point=0, -1.1e-3", "Walls/again/Normal=0, 1"),
               length=2.5e-4, limits={"energy": 0.2}, checks={"it carries": carries}, quick=True)
    one = {"length": 2.5e-4, "limits": {"energy": 0.2}}
    yield Case("bonded grain: no attraction, step not given", BONDED, (f"{grain}Force at contact=0",), expected=(REFUSED,), **one)
    yield Case("bonded grain: no attraction", BONDED, (f"{grain}Force at contact=0", "Time/Time step=1e-6"), expected=ANY, **one)
    yield Case("bonded grain: strong attraction", BONDED, (f"{grain}Force at contact=1e8", "Stop/End time=2e-6"), **one)
    sizes = ("Primaries/Number per body=0",)
    yield Case("bonded grain: sizes 1 to 10", BONDED, (*sizes, "Primaries/Smallest diameter=0.05e-3", "Primaries/Largest diameter=0.5e-3",
                                              "Stop/End time=5e-4"), expected=(RIGHT, REFUSED, STOPPED), **one)
    yield Case("bonded grain: smallest primary 1e-300", BONDED, (*sizes, "Primaries/Smallest diameter=1e-300"), expected=(REFUSED,),
               quick=True, **one)
    yield Case("bonded grain: both sizes 1e-300", BONDED, (*sizes, "Primaries/Smallest diameter=1e-300", "Primaries/Largest diameter=1e-300"),
               expected=(REFUSED,), quick=True, **one)
    yield Case("bonded grain: primaries larger than the body", BONDED, (*sizes, "Primaries/Largest diameter=1"), expected=(REFUSED,),
               quick=True, **one)
    for fraction in (0.01, 1, 5):
        yield Case(f"bonded grain: step of {fraction:g} sqrt(m a0/F0)", BONDED,
                   (f"Time/Step fraction={fraction}", *(["Stop/End time=2e-4"] if fraction < 0.1 else [])),
                   expected=(RIGHT,) if fraction <= 1 else (RIGHT, STOPPED), **{**one, "limits": {"energy": 0.5, "penetration": 0.1}})
    yield Case("bonded grain: crushed", BONDED, ("Walls/top/Velocity=20", "Stop/End time=1e-3"), expected=(STOPPED,),
               quick=True, **one)
    yield Case("bonded grains: wall at 1000 m/s", BONDED_GRAINS, ("Walls/top/Velocity=1000",), expected=(STOPPED, RIGHT), **one)
    fast = BONDED.replace("    set Center = 0, 0\n", "    set Center = 0, 0\n    set Velocity = 1000; 0\n")
    fast = less(fast, ("set Names = bottom, top\n", "set Names = right\n  subsection right\n    set Point = 3e-3, 0\n  end\n"), "bottom", "top")
    yield Case("bonded grain: flies at 1 km/s into a wall", fast, ("Stop/End time=1e-5",), expected=(RIGHT, STOPPED), **{**one, "limits": {"energy": 0.5, "penetration": 0.1}})
