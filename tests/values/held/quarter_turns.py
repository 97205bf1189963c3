# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk, a ring and an ellipse are squeezed between two plates, with and without friction. Turned by 90 degrees, with plates and
mesh, each does the same: its centre to 1e-9 of a cell, the force on a plate to 1e-7.
"""
from images import Image, are_images, differences


def measure(start):
    return differences(start, Image(((0, -1), (1, 0))))


def is_right(found):
    return are_images(found)
