# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps of every scheme, fast bodies and walls, many turns."""
import math

from .case import COLLISION, HARD, LONG_STEP, REFUSED, RIGHT, STOPPED, Case, cases_of, less, met
from .scenes import GRAINS, ONE, TWO


def speed_of_waves():
    return math.sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1000)


def cases():
    for scheme in ("moreau_jean", "newmark", "explicit"):
        for cfl in (0.01, 0.1, 1, 10, 100, 1000):
            short = ["Stop/End time=2e-5"] if cfl == 0.01 else []
            more = {} if cfl == 0.01 else COLLISION if cfl <= 1 else LONG_STEP
            if scheme == "newmark" and cfl > 1:
                more = {**LONG_STEP, "expected": (RIGHT, STOPPED)}
            yield from cases_of(TWO, 1e-3, f"{scheme}", [
                (f"step of {cfl:g} CFL", [f"Time/Scheme={scheme}", f"Time/CFL multiple={cfl}", *short],
                 {**more, "quick": cfl == 1000})])
    for step in (1e-4, 1e-3, 0.05, 0.1):
        yield Case(f"quasi_static: wall moves by {step / 0.1:g} of the way in a step", ONE,
                   (f"Time/Time step={step}", *(["Stop/End time=2e-3"] if step == 1e-4 else [])), length=1e-3,
                   limits={"energy": 0.2 if step == 0.1 else 0.05})
    yield from cases_of(TWO, 1e-3, "fast bodies", [
        ("60 m/s, steps of 10000 CFL",
         ["Bodies/left/Velocity=30; 0", "Bodies/right/Velocity=-30; 0", "Time/CFL multiple=10000", "Stop/End time=2e-4"],
         {"expected": (STOPPED, RIGHT), "checks": {"they meet": met}, "limits": {"energy": 1.5, "penetration": 1.},
          "quick": True, "warning": "what meets is crushed"}),
        ("2 m/s, steps of 10000 CFL", ["Time/CFL multiple=10000"], {**LONG_STEP, "quick": True}),
        ("2 m/s, contact at nodes, steps of 1000 CFL",
         ["Time/CFL multiple=1000", "Contact/Geometry=nodes", "Material points/Grid update=every step"],
         {"checks": {"they meet": met}, "limits": {"energy": 1.5, "penetration": 1.}, "expected": (RIGHT, STOPPED)}),
        ("at the speed of waves", [f"Bodies/left/Velocity={speed_of_waves()}; 0", "Stop/End time=3e-4"],
         {"expected": (RIGHT, STOPPED), "limits": HARD, "warning": "what meets is crushed"})])
    # No step is so long that one goes through the other, whatever finds the contact.
    wide = ["Mesh/Lower=-30e-3, -20e-3", "Mesh/Upper=30e-3, 20e-3"]
    for scheme in ("moreau_jean", "newmark", "explicit"):
        for geometry in ("rays", "nodes"):
            if (scheme, geometry) == ("moreau_jean", "rays"):
                continue
            yield from cases_of(TWO, 1e-3, f"fast bodies, {scheme}, contact by {geometry}", [
                ("60 m/s, steps of 10000 CFL",
                 [*wide, f"Time/Scheme={scheme}", f"Contact/Geometry={geometry}",
                  *(["Material points/Grid update=every step"] if geometry == "nodes" else []),
                  "Bodies/left/Velocity=30; 0", "Bodies/right/Velocity=-30; 0", "Time/CFL multiple=10000", "Stop/End time=4e-4"],
                 {"expected": (STOPPED, RIGHT), "checks": {"they meet": met}, "quick": (scheme, geometry) == ("newmark", "nodes"),
                  "limits": {"energy": 1.5, "penetration": 1.5 if geometry == "nodes" else 0.1}})])
    yield from cases_of(TWO, 1e-3, "bodies that fly, quasi_static", [
        ("60 m/s", ["Time/Scheme=quasi_static", "Time/Time step=1e-5", "Bodies/left/Velocity=30; 0"],
         {"expected": (REFUSED,), "quick": True})])
    yield Case("eight grains: wall at 0.5 of the wave speed, contact at nodes", GRAINS,
               (f"Walls/top/Velocity={0.5 * speed_of_waves()}", "Contact/Geometry=nodes", "Material points/Grid update=every step"),
               length=3.2e-4, limits={"energy": 0.3, "penetration": 1.5}, expected=(RIGHT, STOPPED),
               warning="bodies are crushed where they meet it")
    for speed in (0, 0.01, 0.1, 0.5, 1):
        yield Case(f"eight grains: wall at {speed:g} of the wave speed", GRAINS,
                   (f"Walls/top/Velocity={speed * speed_of_waves()}", *(["Stop/End time=2e-4"] if speed in (0, 0.01) else [])),
                   length=3.2e-4, limits={"energy": 0.3, "penetration": 0.1}, expected=(RIGHT, STOPPED) if speed >= 0.5 else (RIGHT,),
                   warning="bodies are crushed where they meet it" if speed >= 0.5 else "")
    yield Case("a disk that turns twenty times", less(TWO, ("set Names = left, right", "set Names = left"), "right"),
               ("Bodies/left/Velocity=0; 0", "Bodies/left/Center=0, 0", "Bodies/left/Angular velocity=300",
                "Time/Time step=1e-3", "Stop/End time=0.42"), length=1e-3, expected=(RIGHT, STOPPED), limits={"energy": 0.2})
