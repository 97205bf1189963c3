# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What every parameter of softgrain is, so that a scene can be mirrored, turned, moved and written in other units.

A rule is a pattern of paths, how the value behaves, and its unit. The test `knows every parameter` compares the rules with
`softgrain parameters --format json`: a new parameter needs a rule, or the storm would not keep it right.
"""
import fnmatch

# Powers of metre, kilogram and second.
UNITS = {"": (0, 0, 0), "m": (1, 0, 0), "s": (0, 0, 1), "m/s": (1, 0, -1), "rad/s": (0, 0, -1), "1/s": (0, 0, -1),
         "N/kg": (1, 0, -2), "m/s^2": (1, 0, -2), "Pa": (-1, 1, -2), "kg/m": (-1, 1, 0), "kg/(m s)": (-1, 1, -1),
         "kg/m^3": (-3, 1, 0), "N/m": (0, 1, -2), "N/m^2": (-1, 1, -2), "J/m": (1, 1, -2), "N": (1, 1, -2),
         "m^2": (2, 0, 0), "kg m/s": (1, 1, -1), "1": (0, 0, 0), "rad": (0, 0, 0)}

# How a value behaves:
#   plain      it stays as it is, whatever is done to the scene
#   numbers    one number or several, in the unit
#   formula    of t; swinging: of t, its sign changes in a mirror; field: two formulas of place and time
#   point, points, box corner, normal, vector (numbers with a direction)
#   line angle (degrees, of a line), arc start, arc end (degrees), spin (a number, its sign changes in a mirror)
RULES = [
    ("Bodies/*/Center", "point", "m"), ("Bodies/*/Vertices", "points", "m"), ("Bodies/*/Radius", "numbers", "m"),
    ("Bodies/*/Inner radius", "numbers", "m"), ("Bodies/*/Semi-axes", "numbers", "m"), ("Bodies/*/Size", "numbers", "m"),
    ("Bodies/*/Angle", "line angle", ""), ("Bodies/*/Velocity", "field", "m/s"),
    ("Bodies/*/Angular velocity", "spin", "rad/s"), ("Bodies/*/Body force", "field", "N/kg"),
    ("Walls/*/Point", "point", "m"), ("Walls/*/Normal", "normal", ""),
    ("Obstacles/*/Points", "points", "m"), ("Obstacles/*/Center", "point", "m"), ("Obstacles/*/Pivot", "point", "m"),
    ("Obstacles/*/Radius", "numbers", "m"), ("Obstacles/*/From", "arc start", ""), ("Obstacles/*/To", "arc end", ""),
    ("Obstacles/*/Displacement", "field", "m"), ("Obstacles/*/Angle", "swinging", ""),
    ("Loads/Gravity", "vector", "m/s^2"),
    ("Loads/Drag/Rate", "numbers", "1/s"), ("Loads/Drag/Velocity", "field", "m/s"),
    ("Loads/Rotating frame/Angular velocity", "spin", "rad/s"), ("Loads/Rotating frame/Center", "point", "m"),
    ("Mesh/Lower", "box corner", "m"), ("Mesh/Upper", "box corner", "m"), ("Mesh/Cell size", "numbers", "m"),
    ("Packing/Lower", "box corner", "m"), ("Packing/Upper", "box corner", "m"),
    ("Packing/Smallest diameter", "numbers", "m"), ("Packing/Largest diameter", "numbers", "m"),
    ("Primaries/Smallest diameter", "numbers", "m"), ("Primaries/Largest diameter", "numbers", "m"),
    ("Packing/Mean diameter", "numbers", "m"), ("Packing/Standard deviation", "numbers", "m"), ("Packing/Classes", "classes", "m"),
    ("Primaries/Mean diameter", "numbers", "m"), ("Primaries/Standard deviation", "numbers", "m"),
    ("Materials/*/Density", "numbers", "kg/m^3"), ("Materials/*/Growth/Rate", "formula", "1/s"),
    ("Materials/*/Growth/Along", "line angle", ""), ("Materials/*/Flory-Rehner/Chemical potential", "formula", ""),
    ("Materials/*/Power law/Force at contact", "numbers", "N/m"),
    ("Materials/*/Power potential/Characteristic force", "numbers", "N/m"),
    ("Materials/*/Maxwell/Relaxation times", "numbers", "s"),
    ("Materials/*/Viscoplastic/Reference rate", "numbers", "1/s"),
    ("Contact/Adhesion", "numbers", "adhesion"), ("Contact/Adhesion of pairs", "pairs", "adhesion"),
    ("Contact/Friction of pairs", "pairs", ""), ("Contact/Adhesion range", "numbers", "m"),
    ("Contact/Healing time", "numbers", "s"),
    ("Stop/End time", "numbers", "s"), ("Stages/*/Stop/End time", "numbers", "s"),
    ("Time/Time step", "numbers", "s"), ("Output/Fields every", "numbers", "s"),
    ("Output/Snapshots every", "numbers", "s"),
]
for key in ("Young's modulus", "Yield stress", "Hardening modulus", "Saturation stress", "Kinematic modulus", "Drag stress",
            "Cohesion", "Cap start", "Cap pressure", "Cap hardening", "Shear modulus", "Mixing pressure"):
    RULES.append((f"Materials/*/*/{key}", "numbers", "Pa"))
for place in ("Walls/*", "Stages/*/*"):
    for key, kind, unit in (("Velocity", "formula", "m/s"), ("Position", "formula", "m"), ("Pressure", "formula", "Pa"),
                            ("Mean pressure", "formula", "Pa"), ("Stress ratio", "formula", ""),
                            ("Tangential velocity", "swinging", "m/s"), ("Shear stress", "swinging", "Pa"),
                            ("Mass", "numbers", "kg/m"), ("Damping", "numbers", "kg/(m s)")):
        RULES.append((f"{place}/{key}", kind, unit))


def kind_of(path, model="mpm"):
    """(behaviour, (metres, kilograms, seconds)) of a parameter."""
    for pattern, kind, unit in RULES:
        if pattern.count("/") == path.count("/") and fnmatch.fnmatchcase(path, pattern):
            if unit == "adhesion":
                unit = "N/m" if model == "bpm" else "N/m^2"
            return kind, UNITS[unit]
    return "plain", (0, 0, 0)


def parameters(tree, path=()):
    """(path, default, what is allowed, meaning) of all that `softgrain parameters --format json` prints."""
    if "meaning" in tree and "value" in tree:
        # The listing has one placeholder for obstacles, another for all other names.
        yield "/".join("NAME" if name == "OBSTACLE" else name for name in path), tree["default"], tree["allowed"], tree["meaning"]
        return
    for name, branch in tree.items():
        yield from parameters(branch, (*path, name))


def unit_in(meaning):
    """The unit that a meaning names, or nothing."""
    return meaning.rsplit("Units: ", 1)[1].rstrip(".") if "Units: " in meaning else ""
