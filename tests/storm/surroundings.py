# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls and their drives, cells that repeat, stages, obstacles, contact laws and loads of random scenes."""
import math

import numpy

from bodies import around, snapped
from scene import number

NORMALS = {"bottom": (0.0, 1.0), "top": (0.0, -1.0), "left": (1.0, 0.0), "right": (-1.0, 0.0)}


def at_side(name, low, high, gap, grain):
    """A place of a wall that is `gap` away from the box around the bodies."""
    corner = {"bottom": (0.0, low[1] - gap), "top": (0.0, high[1] + gap), "left": (low[0] - gap, 0.0),
              "right": (high[0] + gap, 0.0)}[name]
    return tuple(snapped(value, grain) for value in corner)


def add_walls(dice, scene, bodies, sizes, names, grain):
    low, high = around(bodies)
    scene.set("Walls/Names", ", ".join(names))
    for name in names:
        gap = dice.choice([0.005, 0.02, 0.3]) * sizes.cell
        scene.set(f"Walls/{name}/Point", at_side(name, low, high, gap + grain, grain))


def add_incline(dice, scene, bodies, sizes, grain):
    """One wall of any direction below the bodies."""
    turn = math.radians(dice.uniform(-35, 35))
    normal = numpy.array([math.sin(turn), math.cos(turn)])
    deepest = min(float((ring @ normal).min()) for body in bodies for ring in body.outline())
    # The outline of a disk has its corners on the circle: between them the disk reaches beyond it, by less than 0.005 cells.
    point = normal * (deepest - dice.choice([0.005, 0.2]) * sizes.cell)
    scene.set("Walls/Names", "slope")
    scene.set("Walls/slope/Point", tuple(point))
    scene.set("Walls/slope/Normal", tuple(normal))


def add_drive(dice, scene, name, sizes, where, kinds):
    """Lets a wall move in one of several ways."""
    kind = dice.choice(kinds)
    if kind == "velocity":
        scene.set(f"{where}/Drive", "velocity")
        scene.set(f"{where}/Velocity", dice.choice([
            number(sizes.speed), number(sizes.speed), f"{number(2 * sizes.speed / sizes.time)}*t",
            f"t < {number(sizes.time / 2)} ? {number(sizes.speed)} : {number(-sizes.speed)}",
            f"{number(sizes.speed * math.pi / 2)}*sin({number(math.pi / sizes.time)}*t)"]))
    elif kind == "position":
        scene.set(f"{where}/Drive", "position")
        scene.set(f"{where}/Position", dice.choice([
            f"{number(sizes.speed)}*t", f"{number(sizes.speed / sizes.time)}*t^2",
            f"{number(sizes.way)}*(1 - cos({number(math.pi / sizes.time)}*t))/2"]))
    elif kind == "pressure":
        pressure = sizes.stiffness * 10**dice.uniform(-3, -1.7)
        scene.set(f"{where}/Drive", "pressure")
        scene.set(f"{where}/Pressure", dice.choice([
            number(pressure), f"{number(pressure / sizes.time)}*t", f"{number(pressure)}*min(1, {number(3 / sizes.time)}*t)"]))
    elif kind == "mean_pressure":
        scene.set(f"{where}/Drive", "mean_pressure")
        scene.set(f"{where}/Mean pressure", number(sizes.stiffness * 10**dice.uniform(-3, -2)))
    elif kind == "stress_ratio":
        scene.set(f"{where}/Drive", "stress_ratio")
        scene.set(f"{where}/Stress ratio", number(dice.uniform(0.3, 1)))


def add_box(dice, scene, bodies, sizes, grain, scheme):
    """Four walls, of which one or two are driven."""
    add_walls(dice, scene, bodies, sizes, ["bottom", "top", "left", "right"], grain)
    add_drive(dice, scene, "top", sizes, "Walls/top", ["velocity"] * 3 + ["position", "pressure", "pressure"])
    if dice.random() < 0.4:
        kinds = ["velocity", "position", "pressure", "mean_pressure"]
        if scene.get("Walls/top/Drive") in ("velocity", "position"):
            kinds.append("stress_ratio")
        add_drive(dice, scene, "right", sizes, "Walls/right", kinds)
    if dice.random() < 0.4:
        for name in scene.names("Walls"):
            scene.set(f"Walls/{name}/Friction", dice.choice([0.1, 0.5]))
        if scheme in ("moreau_jean", "quasi_static", "bpm") and dice.random() < 0.4:
            scene.set("Walls/bottom/Tangential velocity", number(dice.choice([-1, 1]) * sizes.speed))
    if dice.random() < 0.15 and scheme != "quasi_static" and scene.get("Walls/top/Drive") == "pressure":
        scene.set("Walls/top/Mass", 0.3 * sizes.density * (6 * sizes.cell)**2)


def add_cell(dice, scene, bodies, sizes, grain):
    """A cell that repeats along x, y or both, compacted or sheared."""
    low, high = around(bodies)
    directions = dice.choice(["x", "y", "xy", "xy"])
    names = ["bottom", "top", "left", "right"]
    scene.set("Walls/Names", ", ".join(names))
    room = dice.choice([0.2, 0.5]) * sizes.cell
    # No body may take more than nine tenths of a cell.
    for axis in range(2):
        if "xy"[axis] in directions:
            widest = max(float((upper - lower)[axis]) for lower, upper in (around([body]) for body in bodies))
            if widest > 0.899 * float((high - low)[axis] + 2 * room):
                room = (widest / 0.89 - float((high - low)[axis])) / 2
    for name in names:
        scene.set(f"Walls/{name}/Point", at_side(name, low, high, room, grain))
        if ("x" if name in ("left", "right") else "y") in directions:
            scene.set(f"Walls/{name}/Type", "periodic")
    way = dice.choice(["compact", "compact", "press", "shear"])
    if way == "shear" and directions == "xy":
        scene.set("Walls/top/Tangential velocity", number(dice.choice([-1, 1]) * sizes.speed))
    elif way == "press":
        add_drive(dice, scene, "top", sizes, "Walls/top", ["pressure"])
    else:
        for name in dice.choice([("top",), ("right",), ("top", "right")]):
            add_drive(dice, scene, name, sizes, f"Walls/{name}", ["velocity", "position"])


def add_stages(dice, scene, sizes):
    """Two parts: the wall on top goes on, turns, or is pressed."""
    scene.set("Stages/Names", "first, second")
    scene.set("Stages/first/Stop/End time", sizes.time * dice.uniform(0.3, 0.6))
    scene.set("Stages/second/Stop/End time", sizes.time * 0.4)
    add_drive(dice, scene, "top", sizes, "Stages/second/top", ["velocity", "position", "pressure"])
    if dice.random() < 0.4 and scene.get("Stages/second/top/Drive") == "velocity":
        scene.set("Stages/second/top/Velocity", number(-sizes.speed))


def add_obstacles(dice, scene, bodies, sizes, grain):
    """A plate below the bodies, an arc around them, or a pin; at rest or in motion."""
    low, high = around(bodies)
    middle, half = (low + high) / 2, (high - low) / 2
    gap = dice.choice([0.05, 0.3]) * sizes.cell
    kind = dice.choice(["plate", "plate", "bowl", "drum", "pin", "notch"])
    where = f"Obstacles/{kind}"
    scene.set("Obstacles/Names", kind)

    def exact(*places):
        return [tuple(snapped(float(value), grain) for value in place) for place in places]

    floor = low[1] - gap
    if kind == "plate":
        reach = dice.uniform(0.2, 1.5) * half[0]
        scene.set(f"{where}/Points", exact((middle[0] - reach, floor), (middle[0] + reach, floor)))
    elif kind == "notch":
        reach = half[0] + sizes.cell
        scene.set(f"{where}/Points", exact((low[0] - gap, high[1]), (low[0] - gap, floor), (high[0] + gap, floor),
                                           (high[0] + gap, high[1])))
    elif kind == "pin":
        scene.set(f"{where}/Points", exact((middle[0], floor), (middle[0], floor - 4 * sizes.cell)))
    else:
        radius = max(float(numpy.hypot(*(ring - middle).T).max()) for body in bodies for ring in body.outline())
        scene.set(f"{where}/Shape", "arc")
        scene.set(f"{where}/Center", exact(middle)[0])
        scene.set(f"{where}/Radius", snapped(radius + gap, grain))
        scene.set(f"{where}/From", 0.0 if kind == "drum" else 180.0)
        scene.set(f"{where}/To", 360.0)
    scene.set(f"{where}/Pivot", exact(middle)[0])
    if dice.random() < 0.4:
        scene.set(f"{where}/Friction", dice.choice([0.2, 0.5]))
    if dice.random() < 0.5:
        scene.set(f"{where}/Displacement", dice.choice([
            f"0; {number(sizes.speed)}*t", f"{number(sizes.speed)}*t; 0",
            f"0; {number(sizes.way)}*sin({number(math.pi / sizes.time)}*t)"]))
    if dice.random() < 0.3:
        scene.set(f"{where}/Angle", f"{number(dice.choice([-1, 1]) * math.degrees(sizes.speed / half.max()))}*t")


def add_contact(dice, scene, sizes, scheme, materials):
    """Friction, its table, adhesion. @return whether there is friction."""
    friction = dice.choice([0.0, 0.0, 0.0, 0.1, 0.5, 1.0])
    if friction:
        scene.set("Contact/Friction", friction)
    if dice.random() < 0.15:
        other = dice.choice(materials + [name for name in scene.names("Walls")
                                         if scene.get(f"Walls/{name}/Type") != "periodic"])
        scene.set("Contact/Friction of pairs", f"{materials[0]} / {other}: {number(dice.choice([0.2, 0.8]))}")
        friction = 1.0
    if dice.random() < 0.15 and scheme in ("moreau_jean", "quasi_static", "bpm"):
        scene.set("Contact/Law", dice.choice(["cohesive", "bond"]))
        strength = sizes.force * 0.1 if scheme == "bpm" else sizes.stiffness * 10**dice.uniform(-4, -2.5)
        scene.set("Contact/Adhesion", strength)
        scene.set("Contact/Adhesion range", dice.choice([0.05, 0.2]) * sizes.cell)
        if dice.random() < 0.3:
            scene.set("Contact/Adhesion of pairs", f"{materials[0]} / {materials[0]}: {number(2 * strength)}")
        if scene.get("Contact/Law") == "bond":
            scene.set("Contact/Healing time", dice.choice(["never", number(sizes.time / 4)]))
    return bool(friction) or any(path.endswith("/Friction") for path in scene.values)


def add_loads(dice, scene, sizes, bodies, static):
    """Gravity and body forces, which move things by about `way`, or press them together as softly."""
    size = sum(body.radius() for body in bodies)
    strength = 2 * sizes.way / sizes.time**2 if not static else \
        sizes.stiffness * 10**dice.uniform(-3, -2) / (sizes.density * size)
    if dice.random() < 0.7:
        scene.set("Loads/Gravity", dice.choice([(0.0, -strength), (0.0, -strength), (0.3 * strength, -strength)]))
    else:
        for name in scene.names("Bodies"):
            scene.set(f"Bodies/{name}/Body force", dice.choice([
                f"0; {number(-strength)}", f"0; {number(-strength / sizes.time)}*t",
                f"{number(-strength / size)}*x; {number(-strength)}"]))
