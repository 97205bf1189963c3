# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Relations between runs: what must come out the same, or nearly so, when a scene is asked in another way.

Each relation is a class with `applies(scene)` and `ask(case)`, which runs what it needs and answers with a Verdict. Differences
that are larger than tolerated are compared with those of a control, the same scene with a body moved by 1e-9 cells: where
the control parts as far, the scene has come to a bifurcation, and the relation has nothing to say.
"""
import dataclasses
import re
import shutil

import changes
from cases import STEPS, Verdict, disks_only, has_disks, near, tolerances, with_library, with_step
from changes import Change
from checks import spacing_of
from compare import difference, same_bits


class Relation:
    name = ""
    exact = False  # asked also of runs that end early, and of scenes with loose tolerances

    def applies(self, scene):
        return True

    def ask(self, case):
        raise NotImplementedError


class InFrame(Relation):
    """The scene in another frame."""

    def __init__(self, name, change):
        self.name, self.change = name, change

    def applies(self, scene):
        if "Packing/Number" in scene.values and self.name != "shift":
            return False  # a random packing has no mirror image
        if scene.get("Model") == "bpm" and not disks_only(scene):
            return False  # aggregates of other shapes are made in the frame, and rounding there makes other ones
        sheared = any(path.endswith("Tangential velocity") for path in scene.values) and "periodic" in scene.values.values()
        return not (self.name == "turn" and (sheared or any(path.endswith("Stop/Axial strain") for path in scene.values)))

    def ask(self, case):
        cell = spacing_of(case.scene)
        change = dataclasses.replace(self.change, shift=tuple(cell * n for n in self.change.shift))
        scene = case.scene
        if case.aggregates() is not None:
            scene = with_library(scene).copy()
            scene.files["library.csv"] = case.aggregates()
        return near(case, self.name, case.run(changes.change_scene(scene, change), self.name), change)


class Units(Relation):
    name, exact = "units", True
    change = Change(scale=(3, -4, 1))  # odd powers in stiffness, mass and their roots

    def ask(self, case):
        differs = same_bits(case.base, case.run(changes.change_scene(case.scene, self.change), self.name), self.change)
        return Verdict(self.name, "fails", "other bits", differs) if differs else Verdict(self.name, "holds")


class Threads(Relation):
    name, exact = "threads", True

    def ask(self, case):
        differs = same_bits(case.base, case.run(case.scene, self.name, threads=2))
        return Verdict(self.name, "fails", "other bits", differs) if differs else Verdict(self.name, "holds")


class Restart(Relation):
    """Goes on from the checkpoint in the middle, in a copy of the folder."""
    name = "restart"

    def ask(self, case):
        states = sorted((case.base.out).glob("state-*.h5"))
        folder = case.folder / self.name
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(case.base.folder, folder)
        middle = states[len(states) // 2].name
        # what comes behind it must not be found
        for state in states[len(states) // 2 + 1:]:
            (folder / "out" / state.name).unlink()
        done = case.run(case.scene, self.name, more=["--restart", f"out/{middle}"], keep=True)
        differs = same_bits(case.base, done)
        return Verdict(self.name, "fails", "other bits", f"from {middle}: {differs}") if differs else \
            Verdict(self.name, "holds")


class Order(Relation):
    """Bodies are named in the reverse order."""
    name = "order"

    def applies(self, scene):
        bonded = scene.get("Model") == "bpm"
        return "Packing/Number" not in scene.values and not (bonded and (
            scene.get("Primaries/Variants") != "1" or "Primaries/Strength spread" in scene.values))

    def ask(self, case):
        scene, renamed = with_library(case.scene).copy(), {}
        if case.aggregates() is not None:
            scene.files["library.csv"] = case.aggregates()
        if scene.names("Bodies"):
            scene.set("Bodies/Names", ", ".join(reversed(scene.names("Bodies"))))
        else:
            head, *rows = scene.files["grains.csv"].splitlines()
            scene.files["grains.csv"] = "\n".join([head, *reversed(rows)]) + "\n"
            renamed = {f"grain_{i + 1}": f"grain_{len(rows) - i}" for i in range(len(rows))}
        return near(case, self.name, case.run(scene, self.name), renamed=renamed)


class LargerMesh(Relation):
    name = "larger mesh"

    def applies(self, scene):
        return scene.get("Model") == "mpm" and "material points" not in scene.values.values()

    def ask(self, case):
        scene, cell = case.scene.copy(), spacing_of(case.scene)
        for key, by in (("Mesh/Lower", (-3 * cell, -2 * cell)), ("Mesh/Upper", (2 * cell, 5 * cell))):
            scene.set(key, Change(shift=by).point(scene.point(key)))
        return near(case, self.name, case.run(scene, "larger"))


class LittleFriction(Relation):
    """
    Friction of 1e-9 does what none does. Without any, round bodies are held from turning in steps with inertia that resolve no hit,
    so both are asked again with shorter ones.
    """
    name = "little friction"
    halvings = 5

    def applies(self, scene):
        return not any(path.endswith(("/Friction", "Friction of pairs", "olling resistance")) for path in scene.values) and \
            scene.get("Contact/Law", "coulomb") == "coulomb"

    def ask(self, case):
        scene = case.scene.copy()
        scene.set("Contact/Friction", 1e-9)
        for section in ("Walls", "Obstacles"):
            for name in scene.names(section):
                if scene.get(f"{section}/{name}/Type") != "periodic":
                    scene.set(f"{section}/{name}/Friction", 1e-9)
        limits = [max(pair) for pair in zip((1e-4, 1e-3, 1e-2), tolerances(scene))]
        found = near(case, self.name, case.run(scene, "friction"), limits=limits)
        held = has_disks(scene) and scene.get("Time/Scheme") in ("moreau_jean", "newmark")
        if found.verdict == "fails" and held:
            return self.with_shorter_steps(case, scene, limits) or found
        return found

    def with_shorter_steps(self, case, scene, limits):
        for n in range(1, self.halvings + 1):
            smooth, rough = (case.run(with_step(each, 0.5**n), name, limit=2 * 2**n)
                             for each, name in ((case.scene, f"smooth{n}"), (scene, f"friction{n}")))
            if smooth.code != 0 or rough.code != 0:
                return None
            seen = difference(case.scene, smooth, rough)
            if seen.over(limits) <= 1:
                return Verdict(self.name, "holds", "", f"with a step of 1/{2**n}: {seen}")
        return None


class Drive(Relation):
    """A wall that is told its velocity goes as one that is told its place."""
    name = "drive"
    plain = re.compile(r"[-+.0-9e]+")
    way = re.compile(r"([-+.0-9e]+)\*t")

    def walls(self, scene):
        for name in scene.names("Walls"):
            where = f"Walls/{name}"
            if scene.get(f"{where}/Drive") == "velocity" and self.plain.fullmatch(scene.get(f"{where}/Velocity", "")):
                yield where, "position", "Velocity", "Position", f"{scene.get(where + '/Velocity')}*t"
            elif scene.get(f"{where}/Drive") == "position" and self.way.fullmatch(scene.get(f"{where}/Position", "")):
                yield where, "velocity", "Position", "Velocity", self.way.fullmatch(scene.get(where + "/Position"))[1]

    def applies(self, scene):
        return any(True for _ in self.walls(scene))

    def ask(self, case):
        scene = case.scene.copy()
        for where, drive, old, new, value in self.walls(case.scene):
            scene.set(f"{where}/Drive", drive)
            del scene.values[f"{where}/{old}"]
            scene.set(f"{where}/{new}", value)
        return near(case, self.name, case.run(scene, self.name))


class Pieces(Relation):
    """A straight obstacle of one piece and of many."""
    name = "pieces"

    def lines(self, scene):
        return [f"Obstacles/{name}/Points" for name in scene.names("Obstacles") if f"Obstacles/{name}/Points" in scene.values]

    def applies(self, scene):
        return bool(self.lines(scene))

    def ask(self, case):
        scene = case.scene.copy()
        for path in self.lines(scene):
            corners = [tuple(map(float, pair.split(","))) for pair in scene.get(path).split(";")]
            places = [corners[0]]
            for a, b in zip(corners[:-1], corners[1:]):
                places += [tuple(a[i] + (b[i] - a[i]) * k / 8 for i in range(2)) for k in range(1, 8)] + [b]
            scene.set(path, places)
        return near(case, self.name, case.run(scene, self.name))


class HalfStep(Relation):
    """
    With half the step little changes, or less with every halving.

    Steps with inertia are up to twenty CFL steps, which resolve no impact: there the differences need not fall yet. They are
    halved on until a step is short against an impact; then they must fall.
    """
    name = "half step"
    small, shrinks = 0.02, 0.8  # cells; a difference over the one before
    lost = 0.25  # cells; runs that are further apart are others altogether, and come nearer by chance

    def applies(self, scene):
        return any(path in scene.values for path in STEPS)

    def ask(self, case):
        runs, places = [case.base], []
        for name, share in (("half", 0.5), ("quarter", 0.25)):
            runs.append(case.run(with_step(case.scene, share), name, limit=int(case.program.limit / share)))
            if runs[-1].code != case.base.code:
                return Verdict(self.name, "fails", "ends differently", f"{name}: {runs[-1].message[-200:]}")
            found = difference(case.scene, runs[-2], runs[-1])
            places.append(found.place)
            if name == "half" and found.place <= self.small:
                return Verdict(self.name, "holds", "", str(found))
        if not self.falls(places) and case.scene.get("Time/Scheme") != "quasi_static":
            self.halve_on(case, runs[-1], places)
        seen = f"by {places[0]:.2g} cells, with half of that by " + ", ".join(f"{place:.2g}" for place in places[1:])
        if self.falls(places):
            return Verdict(self.name, "holds", "", seen)
        for which in (0, 1):
            control = case.control(which)
            if control.code != case.base.code or difference(case.scene, case.base, control).place >= 0.1 * places[1]:
                return Verdict(self.name, "bifurcation", "", seen)
        return Verdict(self.name, "fails", "does not converge", f"{seen} ({found.where})")

    def falls(self, places):
        """Below the first and the last but one; or three times in a row, where the first was small by chance."""
        shrinks = [after <= self.shrinks * before for before, after in zip(places, places[1:])]
        return (places[-1] <= self.shrinks * min(places[0], places[-2]) or (len(places) > 3 and all(shrinks[-3:]))) and \
            (len(places) == 2 or places[-1] < self.lost)

    def halve_on(self, case, run, places):
        """Adds differences with still shorter steps, up to the first that falls; a run that does not end ends this."""
        for n, name in enumerate(("eighth", "sixteenth", "thirty-second"), 3):
            shorter = case.run(with_step(case.scene, 0.5**n), name, limit=int(case.program.limit * 2**n))
            if shorter.code != case.base.code:
                return
            places.append(difference(case.scene, run, shorter).place)
            if self.falls(places):
                return
            run = shorter


RELATIONS = [InFrame("mirror", changes.MIRROR), InFrame("turn", changes.TURN), InFrame("shift", Change(shift=(7, -4))),
             Units(), Order(), Threads(), Restart(), HalfStep(), LittleFriction(), Drive(), Pieces(), LargerMesh()]
BY_NAME = {relation.name: relation for relation in RELATIONS}


def that_apply(scene):
    """Relations that a scene is asked for. Those between frames need small tolerances."""
    exact = ("units", "threads", "restart")
    return [relation for relation in RELATIONS
            if relation.applies(scene) and (scene.note("tight") == "yes" or relation.name in exact)]
