# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of extremes.py: small scenes, each with one thing at its limit."""
import dataclasses
import math
import re

RIGHT, REFUSED, STOPPED = "right", "refused", "stopped"


@dataclasses.dataclass
class Case:
    name: str
    scene: str
    settings: tuple = ()
    expected: tuple = (RIGHT,)
    length: float = 1.  # cell or mean diameter, in which penetration is told [m]
    limits: dict = dataclasses.field(default_factory=dict)  # of energy, momentum, penetration, residual
    checks: dict = dataclasses.field(default_factory=dict)  # what is known: name and test of the rows of history.csv
    files: dict = dataclasses.field(default_factory=dict)
    quick: bool = False


MATERIAL = """
subsection Materials
  set Names = gel
  subsection gel
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
    end
  end
end
"""

# A disk of radius 5 mm between two plates, squeezed by 10 %, 10 cells wide.
ONE = MATERIAL + """
subsection Mesh
  set Lower     = -10e-3, -7e-3
  set Upper     = 10e-3, 7e-3
  set Cell size = 1e-3
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 0.02
end
subsection Bodies
  set Names = disk
  subsection disk
    set Center = 0, 0
    set Radius = 5e-3
  end
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, -5e-3
  end
  subsection top
    set Point    = 0, 5e-3
    set Velocity = 10e-3
  end
end
subsection Stop
  set End time = 0.1
end
"""

# Two of them that meet at 2 m/s, bounce and part.
TWO = MATERIAL.replace("set Names = gel", "set Names = gel, other").replace("""  subsection gel
""", """  subsection other
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
    end
  end
  subsection gel
""") + """
subsection Mesh
  set Lower     = -15e-3, -8e-3
  set Upper     = 15e-3, 8e-3
  set Cell size = 1e-3
end
subsection Time
  set Theta        = 0.5
  set CFL multiple = 2
end
subsection Bodies
  set Names = left, right
  subsection left
    set Material = gel
    set Center   = -5.1e-3, 0
    set Radius   = 5e-3
    set Velocity = 1; 0
  end
  subsection right
    set Material = other
    set Center   = 5.1e-3, 0
    set Radius   = 5e-3
    set Velocity = -1; 0
  end
end
subsection Stop
  set End time = 1.5e-3
end
"""

# Eight grains in a box whose top comes down.
GRAINS = MATERIAL + """
subsection Mesh
  set Lower     = -1e-3, -1e-3
  set Upper     = 7e-3, 7e-3
  set Cell size = 3.2e-4
end
subsection Packing
  set Number            = 8
  set Smallest diameter = 1.4e-3
  set Largest diameter  = 2.4e-3
  set Upper             = 6e-3, 6e-3
end
subsection Time
  set CFL multiple = 4
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point    = 0, 6e-3
    set Velocity = 2
  end
  subsection right
    set Point = 6e-3, 0
  end
end
subsection Stop
  set End time         = 1.4e-3
  set Packing fraction = 0.9
end
"""

# A grain of forty bonded primaries between two walls.
BONDED = """
set Model = bpm
subsection Materials
  set Names = grain
  subsection grain
    set Law     = power_law
    set Density = 2000
    subsection Power law
      set Force at contact = 100
    end
  end
end
subsection Bodies
  set Names = disk
  subsection disk
    set Center = 0, 0
    set Radius = 1e-3
  end
end
subsection Primaries
  set Smallest diameter = 0.2e-3
  set Largest diameter  = 0.3e-3
  set Number per body   = 40
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, -1.1e-3
  end
  subsection top
    set Point    = 0, 1.1e-3
    set Velocity = 0.2
  end
end
subsection Stop
  set End time = 2e-3
end
"""

# Six such grains in a box whose top comes down.
BONDED_GRAINS = BONDED.split("subsection Bodies")[0] + """
subsection Packing
  set Number            = 6
  set Smallest diameter = 1.8e-3
  set Largest diameter  = 2.2e-3
  set Upper             = 6e-3, 6e-3
end
subsection Primaries
  set Smallest diameter = 0.2e-3
  set Largest diameter  = 0.3e-3
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point    = 0, 6e-3
    set Velocity = 2
  end
  subsection right
    set Point = 6e-3, 0
  end
end
subsection Stop
  set End time = 5e-4
end
"""

LAW, OTHER = "Materials/gel/Neo-Hookean/", "Materials/other/Neo-Hookean/"


def less(scene, names, *sections):
    """A scene without some of its bodies or walls; @p names is what is left of the list of names."""
    for section in sections:
        scene = re.sub(rf"\n  subsection {section}\n.*?\n  end", "", scene, flags=re.DOTALL)
    return scene.replace(*names)


def cases_of(scene, length, prefix, table):
    """Cases from lines (name, settings) or (name, settings, more of Case)."""
    for name, settings, *more in table:
        yield Case(f"{prefix}: {name}", scene, tuple(settings), **{"length": length, **(more[0] if more else {})})


def last(name):
    return lambda rows: rows[-1][name]


def bounced(rows):
    """Kinetic energy is back after the collision, most of it."""
    return 0.7 < rows[-1]["kinetic_energy_J_per_m"] / rows[0]["kinetic_energy_J_per_m"] <= 1.001


def met(rows):
    """The bodies have been in contact."""
    return max(row["elastic_energy_J_per_m"] for row in rows) > 0.05 * rows[0]["kinetic_energy_J_per_m"]


def force_about(value, share=0.1):
    return lambda rows: abs(rows[-1]["top_force_N_per_m"] - value) < share * value


def carries(rows):
    return max(row["top_force_N_per_m"] for row in rows) > 0


HARD = {"energy": 0.2, "penetration": 0.2}
COLLISION = {"checks": {"they bounce": bounced, "they meet": met}}
LONG_STEP = {"limits": {"energy": 1.5, "penetration": 0.2}, "checks": {"they meet": met}}
ANY = (RIGHT, STOPPED, REFUSED)


def scaled(factor):
    """Lengths and times of ONE and of TWO by a factor, so that speeds and stresses stay."""
    def of_one():
        return ["Mesh/Lower={0}, {1}".format(-10e-3 * factor, -7e-3 * factor),
                "Mesh/Upper={0}, {1}".format(10e-3 * factor, 7e-3 * factor), f"Mesh/Cell size={1e-3 * factor}",
                f"Bodies/disk/Radius={5e-3 * factor}", f"Walls/bottom/Point=0, {-5e-3 * factor}",
                f"Walls/top/Point=0, {5e-3 * factor}", f"Time/Time step={0.02 * factor}",
                f"Stop/End time={0.1 * factor}"]

    def of_two():
        return ["Mesh/Lower={0}, {1}".format(-15e-3 * factor, -8e-3 * factor),
                "Mesh/Upper={0}, {1}".format(15e-3 * factor, 8e-3 * factor), f"Mesh/Cell size={1e-3 * factor}",
                f"Bodies/left/Radius={5e-3 * factor}", f"Bodies/right/Radius={5e-3 * factor}",
                f"Bodies/left/Center={-5.1e-3 * factor}, 0", f"Bodies/right/Center={5.1e-3 * factor}, 0",
                f"Stop/End time={1.5e-3 * factor}"]
    return of_one(), of_two()


def lattice(n, spacing, radius):
    return "x_m,y_m,radius_m\n" + "".join(f"{(i + 0.5) * spacing},{(j + 0.5) * spacing},{radius}\n"
                                          for i in range(n) for j in range(n))


def speed_of_waves():
    return math.sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1000)


def all_cases():
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
          "quick": True}),
        ("2 m/s, steps of 10000 CFL", ["Time/CFL multiple=10000"], {**LONG_STEP, "quick": True}),
        ("2 m/s, contact at nodes, steps of 1000 CFL",
         ["Time/CFL multiple=1000", "Contact/Geometry=nodes", "Material points/Grid update=every step"],
         {"checks": {"they meet": met}, "limits": {"energy": 1.5, "penetration": 1.}, "expected": (RIGHT, STOPPED)}),
        ("at the speed of waves", [f"Bodies/left/Velocity={speed_of_waves()}; 0", "Stop/End time=3e-4"],
         {"expected": (RIGHT, STOPPED), "limits": HARD})])
    for friction in (0, 0.5, 10):
        yield Case(f"eight grains: friction {friction}", GRAINS, (f"Contact/Friction={friction}",), length=3.2e-4,
                   limits={"energy": 0.1})
        yield Case(f"bonded grains: friction {friction}", BONDED_GRAINS, (f"Contact/Friction={friction}",),
                   length=2.5e-4, limits={"energy": 0.2}, quick=friction == 10)
    coarse = ["Mesh/Lower=-60e-3, -45e-3", "Mesh/Upper=60e-3, 45e-3", "Mesh/Cell size=10e-3"]
    yield from cases_of(ONE, 10e-3, "one disk", [
        ("a body of one cell", [*coarse], {"expected": ANY, "limits": {"energy": 0.2, "penetration": 0.2}}),
        ("one point", ["Mesh/Lower=-75e-3, -75e-3", "Mesh/Upper=75e-3, 75e-3", "Mesh/Cell size=30e-3",
                       "Material points/Points per direction=1", "Material points/Fill limit=0.01"], {"expected": ANY})])
    yield from cases_of(ONE, 1e-3, "one disk", [
        ("markers on all the boundary, 20 a cell", ["Contact/Marker spacing=0.05"]),
        ("one marker in four cells", ["Contact/Marker spacing=4"], {"limits": {"penetration": 0.5}}),
        ("plates touch and move apart", ["Walls/top/Velocity=-10e-3"], {"expected": (RIGHT, STOPPED)}),
        ("plates at rest", ["Walls/top/Velocity=0"]),
        ("as flat as it goes", ["Walls/top/Velocity=100e-3", "Time/Time step=2e-3"],
         {"expected": (STOPPED,), "quick": True}),
        ("nm", scaled(1e-7)[0], {"length": 1e-10}), ("km", scaled(1e6)[0], {"length": 1e3})])
    yield Case("one disk: no plates", less(ONE, ("set Names = bottom, top", "set Names ="), "bottom", "top"), expected=ANY, length=1e-3)
    yield from cases_of(TWO, 1e-3, "two disks", [
        ("nm", scaled(1e-7)[1], {**COLLISION, "length": 1e-10}), ("km", scaled(1e6)[1], {**COLLISION, "length": 1e3}),
        ("exact touch", ["Bodies/left/Center=-5e-3, 0", "Bodies/right/Center=5e-3, 0"], {**COLLISION, "quick": True}),
        ("overlap", ["Bodies/left/Center=-4.5e-3, 0"], {"expected": (REFUSED,), "quick": True}),
        ("one through a wall", ["Walls/Names=left", "Walls/left/Point=-9e-3, 0"], {"expected": (REFUSED,)}),
        ("leaves the mesh", ["Stop/End time=0.1", "Time/CFL multiple=100", "Material points/Grid update=every step"],
         {"expected": (STOPPED,), "limits": HARD})])
    for size, wide in (("20e-3, 1e-3", 1e-3), ("2e-3, 12e-3", 2e-3)):
        yield Case(f"rectangle of {size} m", ONE,
                   ("Bodies/disk/Shape=rectangle", f"Bodies/disk/Size={size}", "Mesh/Cell size=5e-4", "Mesh/Lower=-12e-3, -8e-3",
                    "Mesh/Upper=12e-3, 8e-3", f"Walls/bottom/Point=0, {-0.5 * float(size.split(',')[1])}",
                    f"Walls/top/Point=0, {0.5 * float(size.split(',')[1])}", f"Walls/top/Velocity={float(size.split(',')[1])}"),
                   length=5e-4, checks={"it carries": carries}, expected=(RIGHT, STOPPED) if wide == 2e-3 else (RIGHT,))
    plates = ["Walls/Names=bottom, top, left, right", "Walls/left/Point=-5e-3, 0", "Walls/right/Point=5e-3, 0",
              "Walls/left/Velocity=10e-3", "Walls/right/Velocity=10e-3", "Walls/bottom/Velocity=10e-3", "Stop/End time=0.5",
              "Time/Time step=5e-3", f"{LAW}Poisson's ratio=0.45"]
    yield from cases_of(ONE, 1e-3, "four plates", [
        (f"to a packing fraction of {fraction}", [*plates, f"Stop/Packing fraction={fraction}"],
         {"expected": (RIGHT, STOPPED) if fraction > 0.99 else (RIGHT,)}) for fraction in (0.9, 0.999)])
    for speed in (0, 0.01, 0.1, 0.5, 1):
        yield Case(f"eight grains: wall at {speed:g} of the wave speed", GRAINS,
                   (f"Walls/top/Velocity={speed * speed_of_waves()}", *(["Stop/End time=2e-4"] if speed in (0, 0.01) else [])),
                   length=3.2e-4, limits={"energy": 0.3, "penetration": 0.1}, expected=(RIGHT, STOPPED) if speed >= 0.5 else (RIGHT,))
    yield Case("a disk that turns twenty times", less(TWO, ("set Names = left, right", "set Names = left"), "right"),
               ("Bodies/left/Velocity=0; 0", "Bodies/left/Center=0, 0", "Bodies/left/Angular velocity=300",
                "Time/Time step=1e-3", "Stop/End time=0.42"), length=1e-3, expected=(RIGHT, STOPPED), limits={"energy": 0.2})
    yield Case("a box smaller than its packing", GRAINS, ("Packing/Number=30",), expected=(REFUSED,), quick=True)
    yield Case("a mesh smaller than its bodies", ONE, ("Mesh/Upper=3e-3, 7e-3",), expected=(REFUSED,), quick=True)
    bodies = lattice(100, 1.02e-3, 0.5e-3)
    yield Case("10 000 bodies", GRAINS, ("Packing/Number=0", "Packing/File=disks.csv", "Mesh/Upper=103e-3, 103e-3",
                                         "Walls/top/Point=0, 102e-3", "Walls/right/Point=102e-3, 0", "Stop/Packing fraction=0",
                                         "Stop/End time=3e-5"), files={"disks.csv": bodies}, length=3.2e-4, limits={"energy": 0.2})
    yield Case("10 000 bonded bodies of one primary", BONDED_GRAINS,
               ("Packing/Number=0", "Packing/File=disks.csv", "Walls/top/Point=0, 104e-3", "Walls/right/Point=104e-3, 0",
                "Primaries/Number per body=1", "Primaries/Smallest diameter=0.9e-3", "Primaries/Largest diameter=0.9e-3",
                "Primaries/Variants=10", "Stop/End time=2e-4"), files={"disks.csv": bodies}, length=0.9e-3, limits={"energy": 0.3})
    yield from bonded_cases()


def bonded_cases():
    grain = "Materials/grain/Power law/"
    for exponent in (2, 7, 12):
        yield Case(f"bonded grain: exponent {exponent}", BONDED, (f"{grain}Exponent={exponent}",), length=2.5e-4,
                   limits={"energy": 0.2}, checks={"it carries": carries})
    for number in (1, 2):
        yield Case(f"bonded grain: primaries: {number}", BONDED, (f"Primaries/Number per body={number}", "Walls/top/Velocity=0.5",
                                                                        "Contact/Wall floor=0"),  # a light contact is all there is
                   length=2.5e-4, limits={"energy": 0.3, "residual": 1e-2}, expected=(RIGHT, STOPPED), quick=True)
    one = {"length": 2.5e-4, "limits": {"energy": 0.2, "residual": 1e-2}}
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
                   expected=(RIGHT,) if fraction <= 1 else (RIGHT, STOPPED), **{**one, "limits": {"energy": 0.5, "penetration": 0.1, "residual": 1e-2}})
    yield Case("bonded grain: crushed", BONDED, ("Walls/top/Velocity=20", "Stop/End time=1e-3"), expected=(STOPPED,),
               quick=True, **one)
    yield Case("bonded grains: wall at 1000 m/s", BONDED_GRAINS, ("Walls/top/Velocity=1000",), expected=(STOPPED, RIGHT), **one)
    fast = BONDED.replace("    set Center = 0, 0\n", "    set Center = 0, 0\n    set Velocity = 1000; 0\n")
    fast = less(fast, ("set Names = bottom, top\n", "set Names = right\n  subsection right\n    set Point = 3e-3, 0\n  end\n"), "bottom", "top")
    yield Case("bonded grain: flies at 1 km/s into a wall", fast, ("Stop/End time=1e-5",), expected=(RIGHT, STOPPED), **{**one, "limits": {"energy": 0.5, "penetration": 0.1, "residual": 1e-2}})


CASES = list(all_cases())
