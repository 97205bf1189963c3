# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outlines of the bodies of a state."""

import numpy as np

from .errors import InputError


class Outlines:
    """
    The outlines of the bodies: ``outlines[b]`` is a list of closed lines, arrays of x, y [m]; the
    first is the outer one, others are holes.
    """

    def __init__(self, rings):
        self.rings = rings

    def __getitem__(self, body):
        if body not in self.rings:
            raise InputError(
                f"there is no outline of a body {body}; there are {len(self.rings)} bodies"
            )
        return self.rings[body]

    def __iter__(self):
        return iter(self.rings.values())

    def __len__(self):
        return len(self.rings)

    def __repr__(self):
        return f"<outlines of {len(self)} bodies, {len(self.points_m)} vertices [m]>"

    def keys(self):
        """Numbers of the bodies."""
        return self.rings.keys()

    def items(self):
        return self.rings.items()

    @property
    def points_m(self):
        """All vertices, one after the other [m]."""
        lines = [ring for body in self.rings.values() for ring in body]
        return np.concatenate(lines) if lines else np.zeros((0, 2))
