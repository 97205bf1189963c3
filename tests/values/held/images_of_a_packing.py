# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Ten disks with friction are compacted by the upper wall of their box, with inertia and without. Mirrored at x = 0, turned by 90
degrees and moved by whole cells, with walls and mesh, each disk does the same to 1e-8 of a cell while they touch each other and
no bifurcation has come yet (with ten times the wall's way they still do: doc/results/extremes.md).
"""
import math

from images import CELL, Image, pair

CENTERS = ((6.53145e-04, 1.48569e-03), (1.56652e-03, 1.89216e-03), (1.02096e-03, 1.88798e-03), (9.29533e-04, 1.10695e-03),
           (2.83559e-04, 1.86437e-03), (3.63870e-04, 9.49062e-04), (1.38145e-03, 1.37571e-03), (1.57850e-03, 2.34000e-04),
           (7.14077e-04, 3.64734e-04), (1.34092e-03, 7.41989e-04))
WALLS = {"bottom": ((0., 0.), (0., 1.)), "top": ((0., 2.1875e-3), (0., -1.)), "left": ((0., 0.), (1., 0.)),
         "right": ((1.8125e-3, 0.), (-1., 0.))}
MESH = ((-3e-4, -3e-4), (24e-4, 24e-4))
SCHEMES = {"moreau_jean": (5., "Time/CFL multiple=4", 5e-5), "quasi_static": (1., "Time/Wall way=0.1", 2.5e-4)}
IMAGES = {"mirrored": Image(((-1, 0), (0, 1))), "turned": Image(((0, -1), (1, 0))), "moved": Image(cells=(7, -3))}


def settings(scheme, image):
    speed, step, end = SCHEMES[scheme]
    corners = [image.place(corner) for corner in MESH]
    yield from (f"Time/Scheme={scheme}", step, f"Walls/top/Velocity={speed}", f"Stop/End time={end}",
                f"Output/Snapshots every={end}", f"Mesh/Lower={pair(map(min, *corners))}", f"Mesh/Upper={pair(map(max, *corners))}")
    for k, center in enumerate(CENTERS):
        yield f"Bodies/g{k}/Center={pair(image.place(center))}"
    for name, (point, normal) in WALLS.items():
        yield f"Walls/{name}/Point={pair(image.place(point))}"
        yield f"Walls/{name}/Normal={pair(image.way(normal))}"


def measure(start):
    """Of each scheme its coordination number at the end, and of each image the largest distance of a disk from where it should be [cells]."""
    found = {}
    for scheme in SCHEMES:
        before = start("ten_grains.prm", *settings(scheme, Image()))
        found[scheme] = before.history["coordination"][-1]
        for name, image in IMAGES.items():
            after = start("ten_grains.prm", *settings(scheme, image))
            found[f"{scheme}, {name}"] = max(
                math.dist(image.place(a), b) / CELL
                for a, b in zip(*(run.states[-1].bodies.center_m for run in (before, after))))
    return found


def is_right(found):
    return all(value > 2. if name in SCHEMES else value < 1e-8 for name, value in found.items())
