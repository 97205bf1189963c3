# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene with its runs, controls that are moved by 1e-9 cells, and the verdict on a run that must be near to another."""
import dataclasses

import changes
from changes import Change
from checks import spacing_of
from compare import difference
from scene import number


@dataclasses.dataclass
class Verdict:
    relation: str
    verdict: str  # "holds", "fails" or "bifurcation"
    kind: str = ""
    seen: str = ""


class Case:
    """A scene, its run, and runs of it in other ways, each in a folder of its own."""

    def __init__(self, scene, program, folder):
        self.scene, self.program, self.folder = scene, program, folder
        self.controls = {}
        # Checkpoints of all steps, for the restart: they change nothing.
        self.base = program.run(with_library(scene), folder / "base", more=[
            "--set", "Output/Checkpoint every=1e-9", "--set", "Output/Checkpoints kept=100000"])

    def run(self, scene, name, **options):
        return self.program.run(scene, self.folder / name, **options)

    def control(self, which):
        """The base with a body moved by 1e-9 cells; number 2 with contacts that are solved a hundred times closer."""
        if which not in self.controls:
            scene = with_library(self.scene)
            self.controls[which] = self.run(solved_closer(scene) if which == 2 else nudged(scene, which), f"control{which}")
        return self.controls[which]

    def all_controls(self):
        """Numbers of the controls that there are; rigid primaries are as near to each other as their contacts are solved."""
        return (0, 1, 2) if self.scene.get("Model") == "bpm" and "Contact/Tolerance" in self.scene.values else (0, 1)

    def aggregates(self):
        """The aggregates that the base has made."""
        path = self.base.folder / "library.csv"
        return path.read_text() if path.exists() else None


def with_library(scene):
    if scene.get("Model") != "bpm":
        return scene
    result = scene.copy()
    result.set("Primaries/Library", "library.csv")
    return result


def nudged(scene, which):
    """The scene with its first or its last body moved by 1e-9 cells, another way for each."""
    result, by = scene.copy(), 1e-9 * spacing_of(scene)
    way = ((by, 0.6 * by), (-0.7 * by, by))[which]
    names = scene.names("Bodies")
    if names:
        name = names[-which]
        for key in ("Center", "Vertices"):
            path = f"Bodies/{name}/{key}"
            if path in result.values:
                result.values[path] = changes.value_of(path, result.values[path], Change(shift=way), "mpm")
        if f"Bodies/{name}/Vertices" not in result.values:
            result.set(f"Bodies/{name}/Center", Change(shift=way).point(scene.point(f"Bodies/{name}/Center")))
    elif scene.files.get("grains.csv"):
        lines = scene.files["grains.csv"].splitlines()
        x, y, *rest = lines[1 if which == 0 else -1].split(",")
        lines[1 if which == 0 else -1] = ",".join([number(float(x) + way[0]), number(float(y) + way[1]), *rest])
        result.files["grains.csv"] = "\n".join(lines) + "\n"
    else:
        for key in ("Packing/Lower", "Packing/Upper"):
            result.set(key, Change(shift=way).point(scene.point(key)))
    return result


def solved_closer(scene):
    result = scene.copy()
    result.set("Contact/Tolerance", 0.01 * scene.number("Contact/Tolerance"))
    return result


def tolerances(scene):
    """What is tolerated between two frames: cells, share of the largest speed, share of the largest force."""
    if scene.get("Model") == "bpm":
        return 1e-5, 1e-3, float("inf")  # the forces of rigid primaries are not unique
    if scene.get("Time/Scheme") == "quasi_static":
        return 1e-3, float("inf"), 1e-2
    return 1e-6, 1e-4, 1e-3


STEPS = ("Time/Time step", "Time/CFL multiple", "Time/Step fraction")


def with_step(scene, share):
    """The scene with a part of its step."""
    result = scene.copy()
    for path in STEPS:
        if path in scene.values:
            result.set(path, share * scene.number(path))
    return result


def shapes_of(scene):
    """Shapes of the bodies that a scene or its table names."""
    rows = [line.split(",") for line in scene.files.get("grains.csv", "").splitlines()]
    shapes = [row[rows[0].index("shape")] for row in rows[1:]] if rows and "shape" in rows[0] else []
    return shapes + [scene.get(f"Bodies/{name}/Shape", "disk") for name in scene.names("Bodies")]


def disks_only(scene):
    return all(shape == "disk" for shape in shapes_of(scene))


def has_disks(scene):
    return "disk" in shapes_of(scene) or ("Packing/Number" in scene.values and "disk" in scene.get("Packing/Shapes", "disk"))


def near(case, name, other, change=Change(), renamed=None, limits=None):
    """The verdict on a run that must be near to the base."""
    limits = limits or tolerances(case.scene)
    if other.code != case.base.code:
        if any(case.control(which).code != case.base.code for which in case.all_controls()):
            return Verdict(name, "bifurcation", "", f"exit code {other.code}")
        return Verdict(name, "fails", "ends differently", f"exit code {other.code}: {other.message[-200:]}")
    found = difference(case.scene, case.base, other, change, renamed)
    if found.over(limits) <= 1:
        return Verdict(name, "holds", "", str(found))
    for which in case.all_controls():
        if case.control(which).code != case.base.code:
            return Verdict(name, "bifurcation", "", f"{found}; the control ends differently")
        control = difference(case.scene, case.base, case.control(which))
        if control.over(limits) >= 0.1 * found.over(limits):
            return Verdict(name, "bifurcation", "", f"{found}; control: {control}")
    return Verdict(name, "fails", "differs", str(found))
