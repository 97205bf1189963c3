# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of random shape, and places for them beside each other, within a ring, or in a table of grains."""
import dataclasses
import math

import numpy

import polygons


@dataclasses.dataclass
class Body:
    """A shape about the origin: what the scene says of it, without its place, and its outline."""
    values: dict
    rings: list
    place: tuple = (0.0, 0.0)

    def at(self, place):
        return Body(self.values, self.rings, place)

    def outline(self):
        return [ring + numpy.array(self.place) for ring in self.rings]

    def radius(self):
        return max(float(numpy.hypot(ring[:, 0], ring[:, 1]).max()) for ring in self.rings)

    def write(self, scene, name):
        for key, value in self.values.items():
            if key == "Vertices":
                value = [tuple(numpy.array(corner) + self.place) for corner in value]
            scene.set(f"Bodies/{name}/{key}", value)
        if "Vertices" not in self.values:
            scene.set(f"Bodies/{name}/Center", self.place)


def snapped(value, grain):
    """The nearest multiple of a power of two, so that sums with such numbers are exact."""
    return round(value / grain) * grain


def random_body(dice, cell, thick, grain, disks_only=False):
    """A body whose smallest width is about 2 * `thick` cells."""
    r = snapped(dice.uniform(0.8, 1.2) * thick * cell, grain)
    shape = "disk" if disks_only else dice.choice(["disk"] * 6 + ["ellipse"] * 4 + ["rectangle"] * 3 +
                                                  ["regular"] * 3 + ["ring"] * 2 + ["horseshoe"])
    if shape == "disk":
        return disk(r)
    if shape == "ellipse":
        return ellipse(r, snapped(r * dice.uniform(0.6, 1), grain), dice.choice([0.0, 90.0, dice.randrange(-89, 90) * 1.0]))
    if shape == "rectangle":
        return rectangle(2 * r, snapped(2 * r * dice.uniform(0.6, 1.2), grain),
                         dice.choice([0.0, 0.0, dice.randrange(-89, 90) * 1.0]))
    if shape == "ring":
        inner = snapped(1.2 * r * dice.uniform(0.3, 0.45), grain)
        return ring(snapped(1.2 * r, grain), inner)
    if shape == "horseshoe":
        return horseshoe(dice, 2 * r, grain)
    return regular(dice, 1.2 * r, grain)


def disk(r):
    return Body({"Shape": "disk", "Radius": r}, [polygons.ellipse((0, 0), r, r)])


def ring(r, inner):
    return Body({"Shape": "disk", "Radius": r, "Inner radius": inner},
                [polygons.ellipse((0, 0), r, r), polygons.ellipse((0, 0), inner, inner)])


def ellipse(a, b, angle):
    return Body({"Shape": "ellipse", "Semi-axes": (a, b), "Angle": angle},
                [polygons.ellipse((0, 0), a, b, math.radians(angle))])


def rectangle(width, height, angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    corners = [(x * width / 2, y * height / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return Body({"Shape": "rectangle", "Size": (width, height), "Angle": angle},
                [numpy.array([(c * x - s * y, s * x + c * y) for x, y in corners])])


def regular(dice, r, grain):
    """Three to eight corners on a circle, or three to eight places not quite on it."""
    n = dice.randrange(3, 9)
    r *= 1.35 if n == 3 else 1.0
    start, uneven = dice.uniform(0, 2 * math.pi), dice.choice([0, 0.08])
    corners = []
    for k in range(n):
        size, turn = r * (1 - uneven * dice.random()), start + 2 * math.pi * k / n
        corners.append((snapped(size * math.cos(turn), grain), snapped(size * math.sin(turn), grain)))
    return Body({"Shape": "polygon", "Vertices": corners}, [numpy.array(corners)])


def horseshoe(dice, r, grain):
    """A thick C of straight sides, open to one of four sides."""
    a, b = snapped(r, grain), snapped(r * 0.4, grain)
    corners = [(-a, -a), (a, -a), (a, a), (b, a), (b, -b), (-b, -b), (-b, a), (-a, a)]
    for _ in range(dice.randrange(4)):
        corners = [(-y, x) for x, y in corners]
    return Body({"Shape": "polygon", "Vertices": corners}, [numpy.array(corners)])


def beside(dice, body, others, cell, gap, grain):
    """A place for a body in a random direction of others, `gap` away from them; nothing when there is none."""
    spacing = cell / 4
    for _ in range(20):
        other, turn = dice.choice(others), dice.uniform(0, 2 * math.pi)
        way = numpy.array([math.cos(turn), math.sin(turn)])
        near, far = 0.0, other.radius() + body.radius() + gap
        if any(polygons.gap(body.at(tuple(other.place + far * way)).outline(), each.outline(), spacing) < gap
               for each in others):
            continue
        while far - near > gap / 4:
            middle = (near + far) / 2
            outline = body.at(tuple(other.place + middle * way)).outline()
            free = all(polygons.apart(outline, each.outline(), gap) or
                       polygons.gap(outline, each.outline(), spacing) >= gap for each in others)
            near, far = (near, middle) if free else (middle, far)
        place = tuple(snapped(value, grain) for value in other.place + far * way)
        placed = body.at(place)
        if all(polygons.gap(placed.outline(), each.outline(), spacing) > gap / 2 for each in others):
            return placed
    return None


def cluster(dice, n, cell, thick, gap, grain, disks_only=False):
    """Up to n bodies, each near another."""
    placed = [random_body(dice, cell, thick, grain, disks_only)]
    for _ in range(n - 1):
        body = beside(dice, random_body(dice, cell, thick, grain, disks_only), placed, cell, gap, grain)
        if body:
            placed.append(body)
    return placed


def nest(dice, cell, gap, grain):
    """A ring with a body in it."""
    outer = ring(snapped(dice.uniform(6, 7) * cell, grain), snapped(dice.uniform(3.6, 4) * cell, grain))
    inner = dice.choice([disk(snapped(2 * cell, grain)), ellipse(snapped(2.2 * cell, grain), snapped(1.6 * cell, grain), 30.0),
                         rectangle(3 * cell, 3 * cell, 10.0)])
    room = outer.values["Inner radius"] - inner.radius() - gap
    turn, share = dice.uniform(0, 2 * math.pi), dice.random()
    return [outer, inner.at((snapped(room * share * math.cos(turn), grain), snapped(room * share * math.sin(turn), grain)))]


def around(bodies):
    """Lower and upper corner of the box around bodies."""
    boxes = [polygons.box(body.outline()) for body in bodies]
    return (numpy.min([low for low, _ in boxes], axis=0), numpy.max([high for _, high in boxes], axis=0))
