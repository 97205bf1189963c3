# SPDX-License-Identifier: LGPL-2.1-or-later
"""What few scenes have: other stops, slabs, contact at nodes, refinement, steps by the way of walls, other outputs and searches."""
from scene import number

# Parameters that no scene sets, and why. The test of the scenes asks that all others are set by some.
NOT_TRIED = {
    "Output directory": "the command line says it", "Additional shared libraries": "loads code",
    "Output/Forces on": "columns that a test of values looks at", "Threads": "the relation `threads`", "Output/Checkpoint every": "time on the clock",
    "Output/Checkpoints kept": "the relation `restart`", "Packing/Save to": "writes a file",
    "Primaries/Library": "relations use it", "Contact/Keep failed problems in": "writes files",
    "Contact/Maximum sweeps": "a limit that is not reached", "Linear solver/Maximum iterations": "the same",
    "Linear solver/Automatic limit": "of large bodies", "Newton/Largest strain": "a limit that is rarely reached",
    "Time/Smallest step": "the same", "Quasi-static/Held steps": "the same", "Contact/Wall floor": "of the cost only",
    "Stop/Equilibrium energy": "beside Equilibrium", "Stop/Steady window": "beside Steady state",
    "Materials/NAME/Yeoh/Third coefficient": "keeps its default", "Materials/NAME/Growth/Largest growth": "a limit",
    "Materials/NAME/Viscoplastic/Largest increment": "a limit", "Packing/Until jammed": "takes seconds",
    "Packing/Classes": "classes of grains have tests of their own", "Packing/Class table": "the same", "Packing/Shares of": "the same",
    "Packing/Mean diameter": "of sizes that have tests of their own", "Packing/Standard deviation": "the same", "Packing/Exponent": "the same",
    "Primaries/Mean diameter": "as of packings", "Primaries/Standard deviation": "the same", "Primaries/Exponent": "the same",
    "Contact/Friction at walls": "every wall of a scene says its own", "Dimension": "scenes in space have tests of their own",
    "Packing/Method": "automatic is one of the others", "Packing/Periodic": "packings of cells have tests of their own",
    "Obstacles/NAME/Drive": "others come from libraries", "Loads/Drag/Rate": "loads that see the velocity have tests of their own", "Loads/Drag/Velocity": "the same",
    "Loads/Rotating frame/Angular velocity": "the same", "Loads/Rotating frame/Center": "the same",
    "Stages/NAME/Stop/Equilibrium energy": "as Stop", "Stages/NAME/Stop/Steady window": "as Stop",
}
for of_wall in ("Mean pressure", "Mass", "Damping", "Stress ratio", "Tangential velocity", "Shear stress"):
    NOT_TRIED[f"Stages/NAME/NAME/{of_wall}"] = "walls have it from the start"
for of_run in ("Equilibrium", "Packing fraction", "Shear strain", "Steady state"):
    NOT_TRIED[f"Stages/NAME/Stop/{of_run}"] = "runs have it as a whole"


def add_stop(dice, scene, sizes):
    """Another condition beside the time at the end."""
    walls = scene.names("Walls")
    kinds = ["Equilibrium"] if not any(path.endswith(("/Body force", "/Driven")) for path in scene.values) else []
    if "bottom" in walls and "top" in walls:
        kinds += ["Axial strain", "Axial strain"]
    if len(walls) == 4:
        kinds += ["Shear strain", "Packing fraction", "Steady state"]
    if kinds:
        kind = dice.choice(kinds)
        value = {"Equilibrium": 0.01, "Axial strain": 0.02, "Shear strain": 0.02, "Packing fraction": 0.97,
                 "Steady state": 0.01}[kind]
        scene.set(f"Stop/{kind}", value)
        # In a scene with stages the first one ends so.
        if scene.names("Stages"):
            scene.values[f"Stages/first/Stop/{kind}"] = scene.values.pop(f"Stop/{kind}")


def add_outputs(dice, scene):
    kind = dice.randrange(6)
    if kind == 0:
        scene.set("Output/Points in snapshots", False)
    elif kind == 1:
        scene.set("Output/Compression level", dice.choice([0, 9]))
    elif kind == 2:
        scene.set("Output/History every", 3)
    elif kind == 3 and "Stop/End time" in scene.values:
        scene.values.pop("Output/Fields every", None)
        scene.set("Output/Number of field outputs", 2)
        scene.set("Output/Field parts", dice.choice(["outlines, contacts", "points, extra fields", "walls"]))
    elif kind == 4 and scene.get("Model") == "bpm":
        scene.set("Output/Inner forces", False)


def add_to_soft(dice, scene, sizes, scheme, family):
    """One of the things that few scenes of material points have."""
    plain = not scene.names("Obstacles") and "periodic" not in scene.values.values() and \
        scene.get("Contact/Law", "coulomb") == "coulomb" and \
        not any(path.endswith(("Tangential velocity", "Shear stress", "Driven")) for path in scene.values)
    kind = dice.choice(["slab", "nodes", "refined", "way", "cfl", "sub-grid", "penetration", "distortion"])
    if kind == "slab" and plain and family in ("box", "floor") and scheme in ("moreau_jean", "newmark"):
        scene.set("Walls/bottom/Type", "material points")
    elif kind == "nodes" and plain and family in ("flight", "floor", "box") and scheme in ("moreau_jean", "newmark", "explicit") \
            and scene.get("Material points/Shape function") in (None, "linear", "gimp"):
        scene.set("Material points/Grid update", "every step")
        scene.set("Contact/Geometry", "nodes")
        scene.set("Contact/Nodal gap", dice.choice([True, False]))
        scene.set("Contact/Solver", "lumped" if scene.get("Contact/Nodal gap") == "true" else "condensed")
        for key in ("Marker spacing", "Algorithm"):
            scene.values.pop(f"Contact/{key}", None)
    elif kind == "refined" and plain and scheme in ("moreau_jean", "quasi_static") and len(scene.names("Bodies")) > 1 \
            and "Material points/Grid update" not in scene.values:
        scene.set("Material points/Shape function", "linear")
        scene.set("Mesh/Refine near contact", 1)
    elif kind == "way" and scheme in ("moreau_jean", "quasi_static") and scene.get("Walls/top/Drive") == "velocity":
        scene.set("Time/Wall way", dice.choice([0.1, 0.3]))
    elif kind == "cfl" and scheme in ("moreau_jean", "newmark"):
        scene.values.pop("Time/Time step", None)
        scene.set("Time/CFL multiple", dice.choice([2.0, 10.0, 20.0]))
    elif kind == "sub-grid" and scheme == "quasi_static" and "Material points/Shape function" not in scene.values:
        scene.set("Contact/Sub-grid compliance", False)
    elif kind == "penetration" and scheme in ("moreau_jean", "quasi_static") and "Contact/Solver" not in scene.values:
        scene.set("Contact/Largest penetration", dice.choice([0.02, 0.2]))
    elif kind == "distortion" and scene.get("Material points/Grid update") == "distortion":
        scene.set("Material points/Distortion limit", dice.choice([1.05, 1.5]))


def add_to_bonded(dice, scene):
    key, values = dice.choice([("Skin", [0.1, 0.6]), ("Range", [0.01, 0.1]), ("Largest penetration", [0.01, 0.05])])
    scene.set(f"Contact/{key}", dice.choice(values))
    if dice.random() < 0.2:
        scene.set("Time/Smallest step", 1e-4)
    if dice.random() < 0.3:
        scene.values.pop("Time/Time step")
        scene.set("Time/Step fraction", dice.choice([0.05, 0.1]))


def add_shear_stress(dice, scene, sizes, scheme):
    """A wall with friction that is free to slide under a stress."""
    if scene.number("Walls/top/Friction") > 0 and scheme in ("moreau_jean", "quasi_static", "bpm") and \
            "Walls/top/Tangential velocity" not in scene.values and scene.names("Walls")[-1] == "right":
        scene.set("Walls/top/Shear stress", number(sizes.stiffness * 10**dice.uniform(-4, -3)))
        if scheme != "quasi_static" and scene.get("Walls/top/Drive") == "pressure" and dice.random() < 0.5:
            scene.set("Walls/top/Damping", number(0.1 * (sizes.density * sizes.stiffness)**0.5 * sizes.cell))
