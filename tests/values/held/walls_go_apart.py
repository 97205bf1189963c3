# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A run is to end at a packing fraction, and its walls move apart for ever: it ends and says so. With an end in time it ends there.
"""


def measure(start):
    apart, ends = start("wall_goes_away.prm"), start("wall_goes_away.prm", "Stop/End time=3")
    return {"codes": (apart.code, ends.code), "says": apart.error}


def is_right(found):
    return found["codes"] == (1, 0) and "the packing fraction is" in found["says"] and "moved apart" in found["says"]
