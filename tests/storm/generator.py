# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Random valid scenes, of both models, over all that parameter files offer. The same seed gives the same scene.

A scene belongs to a family, by what happens in it: bodies meet in flight, fall, slide on a slope, are pressed between walls,
live in a cell that repeats, meet obstacles, or lie in a ring. It is small: one to eight bodies, three to five cells across
their radius, some tens of steps.
"""
import math
import random

import bodies as shapes
import bonded
import extras
import soft
import surroundings
import tables
from scene import Scene, number

VERSION = 1  # another generator gives other scenes for the same seeds
SCHEMES = ["moreau_jean"] * 9 + ["quasi_static"] * 5 + ["newmark"] * 3 + ["explicit"] * 3


def generate(seed):
    dice = random.Random(f"storm {VERSION} {seed}")
    scene = Scene(notes=[f"seed: {seed}"])
    if dice.random() < 0.35:
        scene.set("Model", "bpm")
        sizes, scheme = bonded.Sizes(dice), "bpm"
        materials = bonded.add_materials(dice, scene, sizes)
    else:
        scene.set("Model", "mpm")
        scheme = dice.choice(SCHEMES)
        sizes = soft.Sizes(dice, scheme)
        materials = soft.add_materials(dice, scene, sizes, scheme)
    family = dice.choice(families(scheme))
    scene.notes.append(f"family: {family}")
    grains = add_bodies(dice, scene, sizes, scheme, family, materials)
    add_surroundings(dice, scene, grains, sizes, scheme, family)
    friction = surroundings.add_contact(dice, scene, sizes, scheme, materials)
    if scheme == "bpm":
        bonded.add_numerics(dice, scene, sizes)
        if family == "nest":  # a ring of one primary is a disk
            scene.values.pop("Primaries/Number per body", None)
    else:
        soft.add_numerics(dice, scene, sizes, scheme, friction)
        add_mesh(dice, scene, grains, sizes)
    if family == "box" and dice.random() < 0.3:
        extras.add_shear_stress(dice, scene, sizes, scheme)
    if dice.random() < 0.3:
        extras.add_to_bonded(dice, scene) if scheme == "bpm" else extras.add_to_soft(dice, scene, sizes, scheme, family)
    # Newton's method on a grid that is new in every step does not reach small tolerances.
    tight = dice.random() < 0.7 and "Material points/Grid update" not in scene.values
    if tight:
        bonded.tighten(scene) if scheme == "bpm" else soft.tighten(scene, scheme)
    scene.notes.append(f"tight: {'yes' if tight else 'no'}")
    add_ends(dice, scene, sizes)
    return scene


def families(scheme):
    if scheme == "quasi_static":
        return ["box"] * 5 + ["cell"] * 2 + ["obstacle", "floor"]
    if scheme == "newmark":
        return ["flight", "floor", "box", "box"]
    if scheme == "explicit":
        return ["flight", "floor", "box", "slope", "obstacle"]
    return ["flight"] * 2 + ["floor"] * 2 + ["box"] * 4 + ["cell"] * 2 + ["obstacle"] * 3 + ["slope", "nest"]


def add_bodies(dice, scene, sizes, scheme, family, materials):
    grain = soft.GRAIN
    gap = dice.choice([0.02, 0.1, 0.4]) * sizes.cell
    if family == "nest":
        # A ring of a few primaries would shrink to nothing when they attract each other.
        grains = shapes.nest(dice, sizes.cell * (1.5 if scheme == "bpm" else 1), gap, grain)
    else:
        n = dice.choice([1, 1, 2, 2, 2, 3, 3, 4, 5, 6, 8]) if family != "flight" else dice.choice([2, 2, 3, 4])
        disks_only = dice.random() < (0.6 if scheme == "bpm" else 0.2)
        grains = shapes.cluster(dice, n, sizes.cell, dice.uniform(2.5, 5), gap, grain, disks_only)
    plain = ({"Shape", "Radius"}, {"Shape", "Semi-axes", "Angle"})
    if family in ("floor", "box", "cell") and all(set(g.values) in plain for g in grains) and dice.random() < 0.5:
        tables.add_table(dice, scene, grains, materials)
        return grains
    names = [f"b{i + 1}" for i in range(len(grains))]
    scene.set("Bodies/Names", ", ".join(names))
    for name, body in zip(names, grains):
        if len(materials) > 1:
            scene.set(f"Bodies/{name}/Material", dice.choice(materials))
        body.write(scene, name)
        if scheme != "quasi_static":
            add_motion(dice, scene, name, body, sizes, family)
    return grains


def add_motion(dice, scene, name, body, sizes, family):
    """Velocities with which bodies come together."""
    if family in ("flight", "nest"):
        x, y = body.place
        size = math.hypot(x, y) or 1.0
        at = (-x / size, -y / size) if family == "flight" else (0.8, 0.6)
        if family == "flight" or "Inner radius" not in body.values:
            speed = sizes.speed * dice.uniform(0.5, 1.5)
            scene.set(f"Bodies/{name}/Velocity", f"{number(speed * at[0])}; {number(speed * at[1])}")
    elif dice.random() < 0.15:
        scene.set(f"Bodies/{name}/Velocity", dice.choice([
            f"{number(sizes.speed)}; 0", f"{number(sizes.speed / body.radius())}*y; 0"]))
    if dice.random() < 0.15:
        scene.set(f"Bodies/{name}/Angular velocity", dice.choice([-1, 1]) * sizes.speed / body.radius())
    elif family in ("flight", "floor") and name == "b2" and dice.random() < 0.15:
        scene.set(f"Bodies/{name}/Driven", True)
        if "y" in scene.get(f"Bodies/{name}/Velocity", ""):  # it moves as one
            scene.set(f"Bodies/{name}/Velocity", f"{number(sizes.speed)}; 0")


def add_surroundings(dice, scene, grains, sizes, scheme, family):
    grain = soft.GRAIN
    static = scheme == "quasi_static"
    if family == "floor":
        surroundings.add_walls(dice, scene, grains, sizes,
                               ["bottom", "left", "right"] if static or dice.random() < 0.6 else ["bottom"], grain)
        if dice.random() < 0.4:
            scene.set("Walls/bottom/Friction", dice.choice([0.1, 0.5]))
        surroundings.add_loads(dice, scene, sizes, grains, static)
        if not static and dice.random() < 0.2:
            surroundings.add_drive(dice, scene, "bottom", sizes, "Walls/bottom", ["velocity", "position"])
    elif family == "slope":
        surroundings.add_incline(dice, scene, grains, sizes, grain)
        if dice.random() < 0.6:
            scene.set("Walls/slope/Friction", dice.choice([0.1, 0.5]))
        surroundings.add_loads(dice, scene, sizes, grains, static)
    elif family == "box":
        surroundings.add_box(dice, scene, grains, sizes, grain, scheme)
        if dice.random() < 0.2:
            surroundings.add_loads(dice, scene, sizes, grains, static)
        if dice.random() < 0.25:
            surroundings.add_stages(dice, scene, sizes)
    elif family == "cell":
        surroundings.add_cell(dice, scene, grains, sizes, grain)
    elif family == "obstacle":
        surroundings.add_obstacles(dice, scene, grains, sizes, grain)
        surroundings.add_loads(dice, scene, sizes, grains, static)
    elif family == "nest" and dice.random() < 0.5:
        surroundings.add_walls(dice, scene, grains, sizes, ["bottom"], grain)
        surroundings.add_loads(dice, scene, sizes, grains, static)


def add_mesh(dice, scene, grains, sizes):
    """A background mesh of whole cells, with room for what may move."""
    low, high = shapes.around(grains)
    cell, room = sizes.cell, dice.randrange(6, 9)
    corners = [(math.floor(low[i] / cell) - room, math.ceil(high[i] / cell) + room) for i in range(2)]
    scene.set("Mesh/Lower", tuple(corner[0] * cell for corner in corners))
    scene.set("Mesh/Upper", tuple(corner[1] * cell for corner in corners))
    scene.set("Mesh/Cell size", cell)


def add_ends(dice, scene, sizes):
    scene.set("Stop/End time", sizes.time)
    if "Stages/Names" in scene.values:
        del scene.values["Stop/End time"]
    scene.set("Output/Snapshots every", sizes.time / 8)
    scene.set("Output/Checkpoint every", 0)
    if dice.random() < 0.15:
        scene.set("Output/Measures", "all")
    if dice.random() < 0.1:
        scene.set("Output/Fields every", sizes.time / 2)
    if dice.random() < 0.15:
        extras.add_stop(dice, scene, sizes)
    if dice.random() < 0.2:
        extras.add_outputs(dice, scene)
