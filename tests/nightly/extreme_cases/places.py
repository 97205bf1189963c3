# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small, thin, touching and overlapping bodies, all scales, full boxes, ten thousand bodies."""
from .case import ANY, COLLISION, HARD, LAW, REFUSED, RIGHT, STOPPED, Case, carries, cases_of, force_about, less
from .scenes import BONDED_GRAINS, GRAINS, ONE, TWO


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


def cases():
    coarse = ["Mesh/Lower=-60e-3, -45e-3", "Mesh/Upper=60e-3, 45e-3", "Mesh/Cell size=10e-3"]
    yield from cases_of(ONE, 10e-3, "one disk", [
        ("a body of one cell", [*coarse], {"expected": ANY, "limits": {"energy": 0.2, "penetration": 0.2}, "warning": "contact forces are 5 % off and more"}),
        ("one point", ["Mesh/Lower=-75e-3, -75e-3", "Mesh/Upper=75e-3, 75e-3", "Mesh/Cell size=30e-3",
                       "Material points/Points per direction=1", "Material points/Fill limit=0.01"], {"expected": ANY, "length": 30e-3})])
    yield from cases_of(ONE, 1e-3, "one disk", [
        ("markers on all the boundary, 20 a cell", ["Contact/Marker spacing=0.05"]),
        ("one marker in four cells", ["Contact/Marker spacing=4"], {"limits": {"penetration": 0.5}}),
        ("plates touch and move apart", ["Walls/top/Velocity=-10e-3"], {"expected": (RIGHT, STOPPED)}),
        ("plates at rest", ["Walls/top/Velocity=0"]),
        ("two plates in one place", ["Walls/Names=bottom, top, again", "Walls/again/Point=0, -5e-3", "Walls/again/Normal=0, 1"],
         {"checks": {"Johnson's force": force_about(385 / 0.91, 0.07)}, "quick": True}),
        ("as flat as it goes", ["Walls/top/Velocity=100e-3", "Time/Time step=2e-3"],
         {"expected": (STOPPED,)}),
        ("as flat as it goes, cells twice as large",
         ["Walls/top/Velocity=100e-3", "Time/Time step=2e-3", "Mesh/Cell size=2e-3"],
         {"length": 2e-3, "expected": (STOPPED,), "quick": True}),
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
                   ("Bodies/disk/Shape=rectangle", "Bodies/disk/Radius=0", f"Bodies/disk/Size={size}", "Mesh/Cell size=5e-4", "Mesh/Lower=-12e-3, -8e-3",
                    "Mesh/Upper=12e-3, 8e-3", f"Walls/bottom/Point=0, {-0.5 * float(size.split(',')[1])}",
                    f"Walls/top/Point=0, {0.5 * float(size.split(',')[1])}", f"Walls/top/Velocity={float(size.split(',')[1])}"),
                   length=5e-4, checks={"it carries": carries}, expected=(RIGHT, STOPPED) if wide == 2e-3 else (RIGHT,))
    plates = ["Walls/Names=bottom, top, left, right", "Walls/left/Point=-5e-3, 0", "Walls/right/Point=5e-3, 0",
              "Walls/left/Velocity=10e-3", "Walls/right/Velocity=10e-3", "Walls/bottom/Velocity=10e-3", "Stop/End time=0.5",
              "Time/Time step=5e-3", f"{LAW}Poisson's ratio=0.45"]
    yield from cases_of(ONE, 1e-3, "four plates", [
        (f"to a packing fraction of {fraction}", [*plates, f"Stop/Packing fraction={fraction}"],
         {"expected": (RIGHT, STOPPED) if fraction > 0.99 else (RIGHT,)}) for fraction in (0.9, 0.999)])
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
