# SPDX-License-Identifier: LGPL-2.1-or-later
"""
How deep outlines lie in each other. Nothing here comes from softgrain: it is what the program is judged by.

A body is a list of rings, each an array of corners (n x 2); a second ring inside the first is a hole. What lies in a hole is
outside. Depth is the distance of the deepest place of one body within the other to the outline of that.
"""
import math

import numpy


def dense(ring, spacing):
    """Corners of a ring and places between them, at most `spacing` apart."""
    way = numpy.roll(ring, -1, axis=0) - ring
    n = max(1, math.ceil(numpy.hypot(way[:, 0], way[:, 1]).max() / spacing))
    return (ring[:, None] + way[:, None] * (numpy.arange(n) / n)[:, None]).reshape(-1, 2)


def edges(rings):
    return (numpy.concatenate(rings), numpy.concatenate([numpy.roll(ring, -1, axis=0) for ring in rings]))


def inside(places, rings):
    """Which places are in the body: a ray from each crosses its outlines an odd number of times."""
    a, b = edges(rings)
    x, y = places[:, 0, None], places[:, 1, None]
    crosses = (a[:, 1] > y) != (b[:, 1] > y)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        where = a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return (crosses & (x < where)).sum(axis=1) % 2 == 1


def distance(places, a, b):
    """Of each place to the nearest of the segments from a to b."""
    way = b - a
    square = numpy.maximum((way**2).sum(axis=1), 1e-300)
    share = numpy.clip(((places[:, None] - a) * way).sum(axis=2) / square, 0, 1)
    return numpy.sqrt(((places[:, None] - a - share[..., None] * way)**2).sum(axis=2)).min(axis=1)


def depth_of_places(places, rings):
    """The deepest of the places within the body; 0 when all are outside."""
    within = places[inside(places, rings)]
    return float(distance(within, *edges(rings)).max()) if len(within) else 0.0


def box(rings):
    corners = numpy.concatenate(rings)
    return corners.min(axis=0), corners.max(axis=0)


def apart(first, second, by=0.0):
    """Whether the boxes around two bodies are farther apart than `by`."""
    (low, high), (other_low, other_high) = box(first), box(second)
    return bool((low - by > other_high).any() or (other_low - by > high).any())


def depth(first, second, spacing):
    """How deep two bodies lie in each other."""
    if apart(first, second):
        return 0.0
    return max(depth_of_places(numpy.concatenate([dense(ring, spacing) for ring in a]), b)
               for a, b in ((first, second), (second, first)))


def gap(first, second, spacing):
    """How far apart two bodies are; less than 0 where they lie in each other."""
    lying = depth(first, second, spacing)
    if lying > 0:
        return -lying
    return min(float(distance(numpy.concatenate([dense(ring, spacing) for ring in a]), *edges(b)).min())
               for a, b in ((first, second), (second, first)))


def line_places(line, spacing):
    """Places along an open line."""
    pieces = [line[-1:]]
    for a, b in zip(line[:-1], line[1:]):
        n = max(1, math.ceil(math.hypot(*(b - a)) / spacing))
        pieces.append(a + (b - a) * (numpy.arange(n) / n)[:, None])
    return numpy.concatenate(pieces)


def ellipse(center, a, b, angle=0.0, n=96):
    """An outline with n corners on an ellipse; the angle is in radians."""
    turns = 2 * math.pi * numpy.arange(n) / n
    x, y = a * numpy.cos(turns), b * numpy.sin(turns)
    return numpy.column_stack([center[0] + x * math.cos(angle) - y * math.sin(angle),
                               center[1] + x * math.sin(angle) + y * math.cos(angle)])
