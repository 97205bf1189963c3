# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of bonded primaries: laws of attraction, primaries, numerical parameters."""
import math


class Sizes:
    """What the numbers of a scene are measured by; a "cell" is the mean diameter of the primaries."""

    def __init__(self, dice):
        self.cell = dice.randrange(8, 25) * 2.0**-15
        self.force = 2.0**dice.uniform(3, 10)
        self.density = dice.choice([1000.0, dice.uniform(500, 3000)])
        mass = self.density * math.pi / 4 * self.cell**2
        self.step = dice.uniform(0.03, 0.1) * math.sqrt(mass * self.cell / self.force)
        self.steps = dice.randrange(40, 150)
        self.time = self.step * self.steps
        self.way = dice.uniform(0.3, 3) * self.cell
        self.speed = self.way / self.time
        self.stiffness = 10 * self.force / self.cell  # of the order of a stress of the aggregates


def add_materials(dice, scene, sizes):
    names = ["clay", "chalk"][:dice.choice([1, 1, 1, 2])]
    scene.set("Materials/Names", ", ".join(names))
    for name in names:
        law = dice.choice(["power_law", "power_potential"])
        scene.set(f"Materials/{name}/Law", law)
        scene.set(f"Materials/{name}/Density", sizes.density * dice.choice([1.0, dice.uniform(0.5, 2)]))
        force = sizes.force * dice.uniform(0.3, 1)
        if law == "power_law":
            scene.set(f"Materials/{name}/Power law/Force at contact", force)
        else:
            scene.set(f"Materials/{name}/Power potential/Characteristic force", force / 7)
        title = "Power law" if law == "power_law" else "Power potential"
        if dice.random() < 0.3:
            scene.set(f"Materials/{name}/{title}/Exponent", dice.choice([3.0, 7.0, 12.0]))
        if dice.random() < 0.3:
            scene.set(f"Materials/{name}/{title}/Cutoff", dice.choice([0.5, 1.0, 2.0]))
    return names


def add_numerics(dice, scene, sizes):
    scene.set("Primaries/Smallest diameter", sizes.cell * dice.choice([0.7, 0.8, 0.9]))
    scene.set("Primaries/Largest diameter", sizes.cell * dice.choice([1.1, 1.2, 1.3]))
    if dice.random() < 0.3:
        scene.set("Primaries/Size distribution", dice.choice(["uniform diameter", "equal areas"]))
    if dice.random() < 0.5:
        scene.set("Primaries/Variants", 1)
    if dice.random() < 0.25:
        scene.set("Primaries/Number per body", dice.choice([1, 1, 7]))
    scene.set("Primaries/Seed", dice.randrange(1, 100))
    if dice.random() < 0.15:
        scene.set("Primaries/Strength", dice.choice(["r < 0.6 ? 1 : 0.5", "1 - 0.3*r"]))
    if dice.random() < 0.1:
        scene.set("Primaries/Strength spread", 0.2)
    scene.set("Time/Time step", sizes.step)
    if dice.random() < 0.3:
        scene.set("Contact/Restitution", dice.choice([0.5, 0.9]))
    if dice.random() < 0.1:
        scene.set("Contact/Gap correction", dice.choice([0.3, 0.0]))
    if dice.random() < 0.15:
        scene.set("Contact/Algorithm", "gauss_seidel")
    if dice.random() < 0.2:
        scene.set("Contact/Rolling resistance", dice.choice([0.05, 0.2]))
    if dice.random() < 0.2:
        scene.set("Contact/Inner rolling resistance", dice.choice([0.05, 0.2]))


def tighten(scene):
    scene.set("Contact/Tolerance", 1e-10)
    scene.set("Contact/Wall tolerance", 1e-9)
    scene.set("Contact/Penetration tolerance", 1e-9)
