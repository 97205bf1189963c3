# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grains of a table of disks and ellipses, or packed by the program in the same room."""
import math

import bodies as shapes
import soft
from scene import number


def add_table(dice, scene, grains, materials):
    if dice.random() < 0.6:
        scene.set("Packing/File", "grains.csv")
        scene.files["grains.csv"] = table(dice, grains, materials)
    else:
        add_packing(dice, scene, grains, materials)


def table(dice, grains, materials):
    """The table in its short form, where all are disks, or in its long one."""
    disks = all("Radius" in g.values for g in grains)
    short = disks and dice.random() < 0.6
    rows = ["x_m,y_m,radius_m" if short else "x_m,y_m,shape,a_m,b_m,corners,angle_deg"]
    for grain in grains:
        place = f"{number(grain.place[0])},{number(grain.place[1])}"
        if short:
            rows.append(f"{place},{number(grain.values['Radius'])}")
        else:
            a, b = grain.values.get("Semi-axes", (grain.values.get("Radius"),) * 2)
            angle = grain.values.get("Angle", 0.0)
            rows.append(f"{place},{grain.values['Shape']},{number(a)},{number(b)},0,{number(angle)}")
    if len(materials) > 1:
        rows = [row + "," + (dice.choice(materials) if i else "material") for i, row in enumerate(rows)]
    return "\n".join(rows) + "\n"


def add_packing(dice, scene, grains, materials):
    """As many grains of such sizes, packed at random; `grains` becomes their box, around which walls are built."""
    radii = [g.radius() for g in grains]
    side = 2.2 * math.sqrt(sum((2 * r)**2 for r in radii))
    low, high = shapes.around(grains)
    center = [shapes.snapped(float(value), soft.GRAIN) for value in (low + high) / 2]
    half = shapes.snapped(side / 2, soft.GRAIN)
    for key, value in (("Number", len(grains)), ("Smallest diameter", 2 * min(radii)), ("Largest diameter", 2 * max(radii)),
                       ("Lower", (center[0] - half, center[1] - half)), ("Upper", (center[0] + half, center[1] + half)),
                       ("Seed", dice.randrange(1, 1000))):
        scene.set(f"Packing/{key}", value)
    if len(materials) > 1:
        scene.set("Packing/Material", materials[0])
    other = dice.randrange(5)
    if other == 0:
        scene.set("Packing/Shapes", dice.choice(["ellipse", "disk, polygon", "ellipse, polygon"]))
        scene.set("Packing/Aspect ratio", "0.6, 0.9")
        if "polygon" in scene.get("Packing/Shapes"):
            scene.set("Packing/Corners", "4, 7")
    elif other == 1:
        scene.set("Packing/Size distribution", dice.choice(["uniform diameter", "equal areas"]))
    elif other == 2:
        scene.set("Packing/Friction", 0.3)
    elif other == 3:
        scene.set("Packing/Packing fraction", 0.4)
    grains[:] = [shapes.rectangle(2 * half, 2 * half, 0.0).at(tuple(center))]
