# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of material points: laws, numerical parameters, and the lengths and times that fit them."""
import math
import random

GRAIN = 2.0**-30  # places are multiples of this [m]

# What a law may say beside Young's modulus and Poisson's ratio; numbers with "E" are shares of Young's modulus.
LAWS = {
    "neo_hookean": ("Neo-Hookean", {}), "hencky": ("Hencky", {}), "linear_elastic": ("Linear elastic", {}),
    "mooney_rivlin": ("Mooney-Rivlin", {"Share of the second invariant": [0.0, 0.2, 1.0]}),
    "gent": ("Gent", {"Locking": [10.0, 100.0]}), "yeoh": ("Yeoh", {"Second coefficient": [0.0, -0.01]}),
    "ogden": ("Ogden", {"Exponents": ["2.0", "1.3, 5.0"]}),
    "maxwell": ("Maxwell", {"Shares": ["0.5", "0.3, 0.4"], "Relaxation times": ["T"]}),
    "growth": ("Growth", {"Rate": ["rate"], "Along": ["plane", "30.0"]}),
    "j2_plastic": ("J2 plastic", {"Yield stress": ["E0.02", "E0.1"], "Hardening modulus": ["E0.0", "E0.1"], "Saturation rate": [0.0, 5.0],
                                  "Kinematic modulus": ["E0.0", "E0.05"]}),
    "viscoplastic": ("Viscoplastic", {"Yield stress": ["E0.02"], "Drag stress": ["E0.05"], "Reference rate": ["1/T"],
                                      "Exponent": [1.0, 3.0], "Hardening modulus": ["E0.0", "E0.1"],
                                      "Kinematic modulus": ["E0.0", "E0.05"], "Saturation rate": [0.0, 5.0]}),
    "drucker_prager": ("Drucker-Prager", {"Cohesion": ["E0.02"], "Cap start": ["E0.05"], "Cap pressure": ["E0.1"],
                                          "Cap hardening": ["E0.0", "E0.1"], "Friction": [0.2, 0.5]}),
}
DISSIPATIVE = ("maxwell", "j2_plastic", "viscoplastic", "drucker_prager")


class Sizes:
    """What the numbers of a scene are measured by."""

    def __init__(self, dice, scheme):
        self.cell = dice.randrange(8, 25) * 2.0**-14
        self.stiffness = 2.0**dice.uniform(math.log2(1e5), math.log2(1e7))
        self.density = dice.choice([1000.0, dice.uniform(500, 3000)])
        self.poisson = dice.choice([0.0, 0.3, 0.3, 0.45, dice.uniform(0.1, 0.4)])
        speed = math.sqrt(self.stiffness * (1 - self.poisson) / (1 + self.poisson) / (1 - 2 * self.poisson) / self.density)
        crossing = self.cell / speed
        if scheme == "quasi_static":
            self.step, self.steps = dice.choice([1.0, 0.1, 1e-3]), dice.randrange(4, 10)
        elif scheme == "explicit":
            self.step, self.steps = dice.uniform(0.1, 0.4) * crossing, dice.randrange(40, 100)
        else:
            self.step, self.steps = dice.uniform(1, 20) * crossing, dice.randrange(10, 40)
        self.time = self.step * self.steps
        self.way = dice.uniform(0.3, 2) * self.cell  # how far things go in the run
        self.speed = self.way / self.time


def add_gel(dice, scene, where, sizes):
    """A gel that is about as stiff as the other bodies, in a solvent that stays or changes its volume by some per cent."""
    nu = sizes.poisson
    along = sizes.stiffness * (1 - nu) / (1 + nu) / (1 - 2 * nu)
    mixing = 5 * along  # with this network a gel that swells freely has a modulus along of 0.18 to 0.24 of it
    drift = f"-0.01*max(0, 1+{dice.uniform(-0.5, 1)!r}*(t*{1 / sizes.time!r}))"
    scene.set(f"{where}/Shear modulus", 0.1 * mixing)
    scene.set(f"{where}/Mixing pressure", mixing)
    scene.set(f"{where}/Interaction", dice.choice([0.1, 0.4]))
    scene.set(f"{where}/Chemical potential", dice.choice(["0.0", "-0.01", drift, drift]))
    if dice.random() < 0.5:
        scene.set(f"{where}/Largest swelling", dice.choice([0.0, 0.01]))


def add_materials(dice, scene, sizes, scheme):
    names = ["gel", "stone"][:dice.choice([1, 1, 1, 2])]
    scene.set("Materials/Names", ", ".join(names))
    for name in names:
        law = dice.choice(["neo_hookean"] * 8 + list(LAWS))
        if law == "drucker_prager" and scheme != "explicit":
            law = "hencky"
        # Gels came later: a dice of their own leaves all other scenes their seeds.
        gels = random.Random(f"swells {name} {sizes.time!r}")
        gel = gels.random() < 0.05
        title, choices = LAWS[law]
        scene.set(f"Materials/{name}/Law", "flory_rehner" if gel else law)
        scene.set(f"Materials/{name}/Density", sizes.density * dice.choice([1.0, 1.0, dice.uniform(0.5, 4)]))
        if gel:
            add_gel(gels, scene, f"Materials/{name}/Flory-Rehner", sizes)
            continue
        where = f"Materials/{name}/{title}"
        stiffness = sizes.stiffness * dice.choice([1.0, 1.0, dice.uniform(0.3, 1)])
        scene.set(f"{where}/Young's modulus", stiffness)
        scene.set(f"{where}/Poisson's ratio", sizes.poisson)
        for key, options in choices.items():
            value = dice.choice(options)
            if isinstance(value, str) and value.startswith("E"):
                value = stiffness * float(value[1:])
            elif value == "T":
                value = [dice.uniform(0.1, 2) * sizes.time for _ in scene.get(f"{where}/Shares").split(",")]
            elif value == "1/T":
                value = 1 / sizes.time
            elif value == "rate":
                value = repr(dice.uniform(-0.02, 0.05) / sizes.time)
            scene.set(f"{where}/{key}", value)
        if law == "ogden":
            n = len(scene.get(f"{where}/Exponents").split(","))
            scene.set(f"{where}/Weights", ["1.0", "0.99, 0.01"][n - 1])
        if law in ("j2_plastic", "viscoplastic"):  # the default has a unit: it would not be scaled
            scene.set(f"{where}/Saturation stress", scene.get(f"{where}/Yield stress"))
    return names


def add_numerics(dice, scene, sizes, scheme, rigid_friction):
    """Time scheme, mesh functions and solvers; `rigid_friction` says that there is friction."""
    scene.set("Time/Scheme", scheme)
    scene.set("Time/Time step", sizes.step)
    if scheme == "moreau_jean" and dice.random() < 0.3:
        scene.set("Time/Theta", dice.choice([0.5, 0.55, 0.7, 1.0]))
    if scheme == "quasi_static":
        if dice.random() < 0.3:
            scene.set("Quasi-static/Regularisation", dice.choice([1e-4, 1e-2]))
        if dice.random() < 0.2:
            scene.set("Quasi-static/Wall motion", dice.choice([0.1, 0.5]))
    shape = dice.choice(["bspline"] * 5 + ["linear", "gimp"])
    if scheme == "quasi_static" and dice.random() < 0.1:
        shape = "quadratic"
    if shape != "bspline":
        scene.set("Material points/Shape function", shape)
    if shape == "quadratic":
        scene.set("Material points/Points per direction", 3)
    elif dice.random() < 0.15:
        scene.set("Material points/Points per direction", dice.choice([2, 3]))
    if scheme != "quasi_static" and shape != "quadratic" and dice.random() < 0.2:
        scene.set("Material points/Grid update", dice.choice(["every step", "distortion"]))
        if dice.random() < 0.5:
            if shape == "bspline":
                scene.set("Material points/Transfer", "apic")
        elif dice.random() < 0.5:
            scene.set("Material points/PIC fraction", dice.choice([0.05, 1.0]))
    if dice.random() < 0.1:
        scene.set("Material points/F-bar", dice.choice(["on", "off"]))
    if dice.random() < 0.1:
        scene.set("Material points/Fill limit", dice.choice([0.3, 0.9]))
    if scheme not in ("explicit",) and dice.random() < 0.2:
        kind = dice.choice(["banded_cholesky", "cholesky", "cholesky", "cg_amg"])
        scene.set("Linear solver/Type", kind)
        if kind == "cg_amg":
            scene.set("Linear solver/Tolerance", 1e-13)
    if dice.random() < 0.15:
        scene.set("Contact/Algorithm", dice.choice(["accelerated", "gauss_seidel", "active_set"]))
        if scene.get("Contact/Algorithm") == "gauss_seidel" and dice.random() < 0.5:
            scene.set("Contact/Relaxation", 1.3)
    if dice.random() < 0.1:
        scene.set("Contact/Marker spacing", dice.choice([0.25, 0.4, 1.0]))
    # One draw that nothing depends on any more: scenes keep their seeds.
    if scheme in ("moreau_jean", "newmark", "explicit"):
        dice.random()
    if dice.random() < 0.1:
        scene.set("Fidelity", dice.choice(["draft", "reference"]))


def tighten(scene, scheme):
    """Tolerances so small that two runs of one scene in two frames may be compared."""
    scene.set("Contact/Tolerance", 1e-10)
    if scheme == "explicit":
        return
    scene.set("Newton/Maximum iterations", 60)
    if scheme == "quasi_static":
        scene.set("Newton/Residual tolerance", 1e-7)
        scene.set("Quasi-static/Unbalanced force", 1e-6)
        return
    scene.set("Newton/Displacement tolerance", 1e-9)
    scene.set("Newton/Residual tolerance", 1e-9)
    scene.set("Newton/Energy tolerance", 1e-16)
