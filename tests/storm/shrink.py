# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a scene that fails as small as it goes while it still fails in the same way, and keeps it."""
from trial import fails_as

# Values that may be left out one by one, and sections that may be left out as wholes.
OPTIONAL = ("Loads", "Primaries/Strength", "Primaries/Strength spread", "Contact/Law", "Contact/Friction",
            "Contact/Friction of pairs", "Contact/Restitution", "Contact/Rolling resistance",
            "Contact/Inner rolling resistance", "Contact/Algorithm", "Contact/Solver", "Contact/Marker spacing",
            "Contact/Gap correction", "Material points/Grid update", "Material points", "Linear solver", "Fidelity",
            "Time/Theta", "Output/Measures", "Output/Fields every", "Quasi-static", "Primaries/Number per body",
            "Primaries/Size distribution")
OF_BODY = ("Velocity", "Angular velocity", "Body force", "Driven")
OF_WALL = ("Friction", "Tangential velocity", "Shear stress", "Mass", "Damping")
OF_OBSTACLE = ("Friction", "Displacement", "Angle")


def without(scene, path):
    """The scene without a value or a section, and what makes no sense without it."""
    result = scene.copy()
    result.values.pop(path, None)
    result.remove_section(path)
    if path == "Contact/Law":
        for key in ("Adhesion", "Adhesion range", "Healing time", "Adhesion of pairs"):
            result.values.pop(f"Contact/{key}", None)
    if path == "Material points/Grid update":
        for key in ("Transfer", "PIC fraction", "Distortion limit"):
            result.values.pop(f"Material points/{key}", None)
    return result


def with_law(scene, material):
    """The scene with the plainest law for a material."""
    result, where = scene.copy(), f"Materials/{material}"
    stiffness = next(value for path, value in scene.values.items()
                     if path.startswith(where) and path.endswith(("Young's modulus", "Shear modulus")))
    poisson = next((value for path, value in scene.values.items()
                    if path.startswith(where) and path.endswith("Poisson's ratio")), "0.3")
    density = scene.get(f"{where}/Density")
    result.remove_section(where)
    for key, value in (("Law", "neo_hookean"), ("Density", density), ("Neo-Hookean/Young's modulus", stiffness),
                       ("Neo-Hookean/Poisson's ratio", poisson)):
        result.set(f"{where}/{key}", value)
    return result


def grains_left_out(scene):
    head, *rows = scene.files["grains.csv"].splitlines()
    for i in range(len(rows)):
        if len(rows) > 1:
            result = scene.copy()
            result.files["grains.csv"] = "\n".join([head, *rows[:i], *rows[i + 1:]]) + "\n"
            yield result


def smaller(scene):
    """Scenes that are smaller by one thing."""
    for section in ("Bodies", "Obstacles", "Walls"):
        for name in scene.names(section):
            if section != "Bodies" or len(scene.names(section)) > 1:
                result = scene.copy()
                result.remove_name(section, name)
                yield result
    if "grains.csv" in scene.files:
        yield from grains_left_out(scene)
    if scene.names("Stages"):
        result = scene.copy()
        ends = sum(scene.number(f"Stages/{name}/Stop/End time") for name in scene.names("Stages"))
        result.remove_section("Stages")
        result.set("Stop/End time", ends)
        yield result
    for path in OPTIONAL:
        if path in scene.values or any(other.startswith(path + "/") for other in scene.values):
            yield without(scene, path)
    for section, keys in (("Bodies", OF_BODY), ("Walls", OF_WALL), ("Obstacles", OF_OBSTACLE)):
        for name in scene.names(section):
            for key in keys:
                if f"{section}/{name}/{key}" in scene.values:
                    yield without(scene, f"{section}/{name}/{key}")
    if scene.get("Model") == "mpm":
        for material in scene.names("Materials"):
            if scene.get(f"Materials/{material}/Law") != "neo_hookean":
                yield with_law(scene, material)
    if scene.number("Stop/End time") > 2 * scene.number("Time/Time step"):
        result = scene.copy()
        for path in ("Stop/End time", "Output/Snapshots every"):
            result.set(path, scene.number(path) / 2)
        yield result


def shrink(scene, program, folder, relation, kind, seconds):
    """(the smallest scene found, what is seen there); stops when so much processor time is spent."""
    end = program.seconds + seconds
    seen, found = "", True
    while found and program.seconds < end:
        found = False
        for candidate in smaller(scene):
            now = fails_as(candidate, program, folder, relation, kind)
            if now:
                scene, seen, found = candidate, now, True
                break
            if program.seconds >= end:
                break
    return scene, seen


def keep(scene, folder, relation, kind, seen):
    """Writes a scene that fails, with its relation at the head."""
    result = scene.copy()
    heads = ("relation", "kind", "seen")
    result.notes = [note for note in scene.notes if not note.startswith(tuple(f"{head}: " for head in heads))]
    result.notes = [f"relation: {relation}", f"kind: {kind}", f"seen: {' '.join(seen.split())[:300]}", *result.notes]
    name = f"{scene.note('seed')}-{relation}-{kind}".replace(" ", "_")
    return result.save(folder / name)
