# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two runs beside each other: the same bits, perhaps in other units, or places that are near."""
import dataclasses
import re

import numpy

from changes import Change
from checks import spacing_of
from runs import by_name

BASE = {"m": (1, 0, 0), "kg": (0, 1, 0), "s": (0, 0, 1), "N": (1, 1, -2), "Pa": (-1, 1, -2), "J": (2, 1, -2), "rad": (0, 0, 0),
        "1": (0, 0, 0)}


def powers(unit):
    """Powers of metre, kilogram and second of a unit as "kg m^2/s"."""
    total, sign = [0, 0, 0], 1
    for word in re.findall(r"/|[A-Za-z1]+(?:\^?-?[0-9]+)?", unit):
        if word == "/":
            sign = -1
            continue
        name, power = re.fullmatch(r"([A-Za-z]+|1)\^?(-?[0-9]*)", word).groups()
        for i, of in enumerate(BASE[name]):
            total[i] += sign * int(power or 1) * of
    return tuple(total)


def same_bits(first, second, change=Change(), history=True):
    """Where two runs differ in a bit, or nothing. With units in the change the second is in these."""
    if first.code != second.code:
        return f"exit code {second.code} instead of {first.code}: {second.message[-200:]}"
    one, other = first.snapshots(), second.snapshots()
    if len(one) != len(other):
        return f"{len(other)} snapshots instead of {len(one)}"
    for index, (a, b) in enumerate(zip(one, other)):
        if b["time_s"] != a["time_s"] * change.factor((0, 0, 1)):
            return f"snapshot {index} is at {b['time_s']!r} s"
        if a.keys() != b.keys():
            return f"snapshot {index} has other arrays: {sorted(a.keys() ^ b.keys())}"
        for name, array in a.items():
            if isinstance(array, numpy.ndarray):
                factor = change.factor(powers(a.get("unit of " + name, "1")))
                scaled = array * factor if array.dtype.kind == "f" else array
                if not equal(scaled, b[name]):
                    return f"snapshot {index}: {name} {largest_difference(scaled, b[name])}"
    if history and change.scale == (0, 0, 0) and \
            (first.out / "history.csv").read_bytes() != (second.out / "history.csv").read_bytes():
        return "history.csv"
    return None


def equal(a, b):
    """Whether two arrays are the same; what is no number counts elsewhere."""
    if a.shape != b.shape:
        return False
    return bool(((a == b) | ((a != a) & (b != b))).all())


def largest_difference(a, b):
    if a.shape != b.shape or a.dtype.kind != "f":
        return "is another"
    return f"differs by {numpy.abs(a - b).max() / max(numpy.abs(a).max(), 1e-300):.1e} of the largest"


@dataclasses.dataclass
class Difference:
    """How far two runs are apart: places in cells, speeds and forces over the largest of the run."""
    place: float = 0.0
    speed: float = 0.0
    force: float = 0.0
    where: str = ""

    def over(self, tolerances):
        """The largest of the three over what is tolerated."""
        return max(value / limit for value, limit in zip((self.place, self.speed, self.force), tolerances))

    def __str__(self):
        return f"places by {self.place:.1e} cells, speeds by {self.speed:.1e}, forces by {self.force:.1e}, {self.where}"


def force_that_counts(scene):
    """
    What a run at rest takes for no force, 1e-6 of the softest body over a cell [N/m]: where there is nothing else, all forces are
    rounding.
    """
    moduli = [float(text) for path, text in scene.values.items() if path.endswith(("/Young's modulus", "/Shear modulus"))]
    at_rest = scene.get("Time/Scheme") == "quasi_static"
    return 1e-6 * min(moduli) * spacing_of(scene) if at_rest and moduli else 0.0


def difference(scene, first, second, change=Change(), renamed=None):
    """How far the second run is from the first in the changed frame; `renamed` gives bodies of the first other names."""
    cell, worst = spacing_of(scene), Difference()
    one, other = first.snapshots(), second.snapshots()
    names = renamed or {}
    speeds = [max((float(numpy.hypot(*v)) for v in by_name(a, "bodies", "velocity_m_per_s").values()), default=0) for a in one]
    end = one[-1]["time_s"] if one else 0
    fastest = max([*speeds, cell / end if end > 0 else 0, 1e-300])
    forces = [abs(f) for a in one for f in by_name(a, "walls", "normal_force_N_per_m").values()]
    largest = max([*forces, force_that_counts(scene), 1e-300])
    for index, (a, b) in enumerate(zip(one, other)):
        if abs(a["time_s"] - b["time_s"]) > 1e-9 * end:
            return Difference(float("inf"), where=f"snapshot {index} at another time")
        for group, array, turn in (("bodies", "center_m", change.point),
                                   ("bodies", "velocity_m_per_s", lambda v: change.vector(v, (0, 0, 0)))):
            there = by_name(b, group, array)
            for name, value in by_name(a, group, array).items():
                apart = float(numpy.hypot(*(there[names.get(name, name)] - turn(tuple(value)))))
                if array == "center_m" and apart / cell > worst.place:
                    worst.place, worst.where = apart / cell, f"body {name}, snapshot {index}"
                elif array != "center_m":
                    worst.speed = max(worst.speed, apart / fastest)
        there = by_name(b, "walls", "normal_force_N_per_m")
        for name, value in by_name(a, "walls", "normal_force_N_per_m").items():
            if change.wall(name) in there:
                worst.force = max(worst.force, abs(there[change.wall(name)] - value) / largest)
    return worst
