# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The same scene in another frame or in other units: mirrored, turned by 90 degrees, moved, scaled.

A change takes a place x to scale * (turn x + shift). All numbers stay exact: turns are exchanges and signs, scales are powers
of two, and the generator makes places whose sums with shifts are exact.
"""
import csv
import dataclasses
import io
import re

from kinds import kind_of
from scene import number, numbers, points

WALLS_TURNED = {"bottom": "right", "right": "top", "top": "left", "left": "bottom"}
WALLS_MIRRORED = {"left": "right", "right": "left"}


@dataclasses.dataclass(frozen=True)
class Change:
    turn: tuple = ((1, 0), (0, 1))  # rows of a matrix of 0, 1 and -1
    shift: tuple = (0.0, 0.0)       # [m], before the scale
    scale: tuple = (0, 0, 0)        # powers of two of metre, kilogram and second
    walls: tuple = ()               # pairs of names of walls: old, new

    @property
    def mirrors(self):
        (a, b), (c, d) = self.turn
        return a * d - b * c < 0

    def factor(self, unit):
        return 2.0**sum(power * of for power, of in zip(self.scale, unit))

    def vector(self, v, unit):
        return tuple(self.factor(unit) * (row[0] * v[0] + row[1] * v[1] + 0.0) for row in self.turn)

    def point(self, p):
        turned = self.vector(p, (0, 0, 0))
        return tuple(self.factor((1, 0, 0)) * (turned[i] + self.shift[i]) for i in range(2))

    def wall(self, name):
        return dict(self.walls).get(name, name)


MIRROR = Change(turn=((-1, 0), (0, 1)), walls=tuple(WALLS_MIRRORED.items()))
TURN = Change(turn=((0, -1), (1, 0)), walls=tuple(WALLS_TURNED.items()))


def in_new_units(text, change, unit):
    """A formula whose t, x, y, X, Y are those of the changed scene."""
    words = {}
    if change.scale[2]:
        words["t"] = f"(t*{number(2.0**-change.scale[2])})"
    for x, y in (("x", "y"), ("X", "Y")):
        shrink = "" if not change.scale[0] else f"*{number(2.0**-change.scale[0])}"
        new = [f"({axis}{shrink}-({number(by)}))" if by or shrink else axis for axis, by in zip((x, y), change.shift)]
        for i, old in enumerate((x, y)):  # the inverse of the turn is its transpose
            column = [(change.turn[row][i], new[row]) for row in range(2) if change.turn[row][i]]
            sign, axis = column[0]
            if sign != 1 or axis != old:
                words[old] = f"(-{axis})" if sign < 0 else axis
    text = re.sub(r"\b[txyXY]\b", lambda found: words.get(found[0], found[0]), text)
    factor = change.factor(unit)
    return text if factor == 1 else f"{number(factor)}*({text})"


def negative(text):
    return text if text.strip() in ("0", "0.0") else f"-({text})"


def field(text, change, unit):
    parts = [in_new_units(part.strip(), change, unit) for part in text.split(";")]
    result = []
    for row in change.turn:
        sign, part = next((row[i], parts[i]) for i in range(2) if row[i])
        result.append(part if sign > 0 else negative(part))
    return "; ".join(result)


def line_angle(text, change):
    if not re.fullmatch(r"[-+.0-9e]+", text):
        return text
    angle = float(text)
    if change.mirrors:
        angle = -angle
    elif change.turn[0][0] == 0:
        angle += 90 if angle < 90 else -90
    return number(angle)


def value_of(path, text, change, model):
    kind, unit = kind_of(path, model)
    factor = change.factor(unit)
    if kind == "numbers" and re.match(r"[-+.0-9]", text):
        return text if factor == 1 else numbers([factor * float(word) for word in text.split(",")])
    if kind == "pairs" and factor != 1:
        entries = [entry.rsplit(":", 1) for entry in text.split(";")]
        return "; ".join(f"{pair}: {number(factor * float(value))}" for pair, value in entries)
    if kind in ("formula", "swinging"):
        text = in_new_units(text, change, unit)
        return negative(text) if kind == "swinging" and change.mirrors else text
    if kind == "field":
        return field(text, change, unit)
    if kind == "spin":
        return number(factor * float(text) * (-1 if change.mirrors else 1))
    if kind == "line angle":
        return line_angle(text, change)
    if kind in ("point", "box corner"):
        return numbers(change.point([float(word) for word in text.split(",")]))
    if kind == "points":
        return points([change.point([float(word) for word in pair.split(",")]) for pair in text.split(";")])
    if kind in ("normal", "vector"):
        return numbers(change.vector([float(word) for word in text.split(",")], unit))
    return text


def renamed(path, text, change):
    """Path and value with the new names of walls."""
    if not change.walls:
        return path, text
    words = path.split("/")
    if words[0] == "Walls" and len(words) == 3:
        words[1] = change.wall(words[1])
    if words[0] == "Stages" and len(words) == 4:
        words[2] = change.wall(words[2])
    if path == "Walls/Names":
        text = ", ".join(change.wall(name.strip()) for name in text.split(","))
    if path in ("Contact/Friction of pairs", "Contact/Adhesion of pairs"):
        text = re.sub(r"[\w-]+(?=\s*[/:])", lambda found: change.wall(found[0]), text)
    return "/".join(words), text


def changed_file(text, change):
    """A table of grains, or of primaries."""
    rows = list(csv.DictReader(io.StringIO(text)))
    for row in rows:
        place = change.point((float(row["x_m"]), float(row["y_m"])))
        if "key" in row:  # primaries: from the centre of their body
            place = change.vector((float(row["x_m"]), float(row["y_m"])), (1, 0, 0))
        row["x_m"], row["y_m"] = number(place[0]), number(place[1])
        for name in ("radius_m", "a_m", "b_m"):
            if name in row:
                row[name] = number(change.factor((1, 0, 0)) * float(row[name]))
        if "angle_deg" in row:
            angle = float(row["angle_deg"])
            turned = 180 - angle if change.mirrors else angle + (90 if change.turn[0][0] == 0 else 0)
            row["angle_deg"] = number(turned)
    out = io.StringIO()
    table = csv.DictWriter(out, rows[0].keys(), lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    return out.getvalue()


def change_scene(scene, change):
    result = scene.copy()
    result.values = {}
    model = scene.get("Model", "mpm")
    for path, text in scene.values.items():
        path, text = renamed(path, value_of(path, text, change, model), change)
        result.values[path] = text
    for prefix in ("Mesh", "Packing"):  # the corners of a box may have changed their roles
        if f"{prefix}/Lower" in result.values:
            low, high = result.point(f"{prefix}/Lower"), result.point(f"{prefix}/Upper")
            result.set(f"{prefix}/Lower", tuple(map(min, low, high)))
            result.set(f"{prefix}/Upper", tuple(map(max, low, high)))
    if change.mirrors:  # an arc goes counter-clockwise from its beginning to its end
        for name in result.names("Obstacles"):
            if f"Obstacles/{name}/From" in result.values or result.get(f"Obstacles/{name}/Shape") == "arc":
                start, end = (result.number(f"Obstacles/{name}/{key}", by) for key, by in (("From", 0.), ("To", 360.)))
                result.set(f"Obstacles/{name}/From", 180 - end)
                result.set(f"Obstacles/{name}/To", 180 - start)
    elif change.turn[0][0] == 0:
        for name in result.names("Obstacles"):
            if result.get(f"Obstacles/{name}/Shape") == "arc":
                start, end = (result.number(f"Obstacles/{name}/{key}", by) for key, by in (("From", 0.), ("To", 360.)))
                result.set(f"Obstacles/{name}/From", start + 90)
                result.set(f"Obstacles/{name}/To", end + 90)
    result.files = {name: changed_file(text, change) for name, text in scene.files.items()}
    return result
