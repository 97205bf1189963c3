# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The scenes of the storm: the same seed is the same scene, changes of frame can be undone, no parameter is forgotten, and depths of
outlines in each other are right.

    test_scenes.py PROGRAM FOLDER [NAME...]
"""
import fnmatch
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy

import changes
import extras
import generator
import kinds
import polygons
import relations
import runs
import scene

PROGRAM, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


class Scenes(unittest.TestCase):
    def test_the_same_seed_is_the_same_scene(self):
        for seed in range(1, 21):
            first, second = generator.generate(seed), generator.generate(seed)
            self.assertEqual(first.write(), second.write())
            self.assertEqual(scene.read(first.save(FOLDER / "same")), first, seed)
            shutil.rmtree(FOLDER / "same")

    def test_programs_with_fewer_solvers(self):
        """A solver that a program was built without is left out, and the others stay."""
        program = runs.Program(PROGRAM)
        one = scene.Scene({"Linear solver/Type": "nobody_has_it", "Linear solver/Tolerance": 1e-13, "Time/Scheme": "newmark"})
        self.assertEqual(program.fitted(one).values, {"Time/Scheme": "newmark"})
        one = scene.Scene({"Linear solver/Type": "cholesky"})
        self.assertEqual(program.fitted(one).values, {"Linear solver/Type": "cholesky"})

    def test_other_seeds_are_other_scenes(self):
        self.assertEqual(len({generator.generate(seed).write() for seed in range(1, 21)}), 20)

    def test_changes_can_be_undone(self):
        """Twice mirrored, four times turned, moved and moved back, in other units and back: the same numbers."""
        there, back = changes.Change(scale=(3, -5, 2)), changes.Change(scale=(-3, 5, -2))
        for seed in range(1, 21):
            first = generator.generate(seed)
            for path in [path for path in first.values if kinds.kind_of(path)[0] in ("formula", "swinging", "field")]:
                del first.values[path]  # formulas become longer
            cell = 2.0**-14
            ways = {"mirror": [changes.MIRROR] * 2, "turn": [changes.TURN] * 4, "units": [there, back],
                    "shift": [changes.Change(shift=(7 * cell, -4 * cell)), changes.Change(shift=(-7 * cell, 4 * cell))]}
            for name, way in ways.items():
                last = first
                for change in way:
                    last = changes.change_scene(last, change)
                for path, value in first.values.items():
                    if path.endswith(("/Angle", "/Along", "/From", "/To", "Normal", "slope/Point")):
                        continue  # a line has the same direction after half a turn
                    if "deg" not in value:
                        self.assertEqual(numbers_of(last.values[path]), numbers_of(value), f"{seed} {name} {path}")

    def test_all_relations_are_asked(self):
        """Among some hundred scenes each relation applies to several."""
        asked = [relation.name for seed in range(1, 101) for relation in relations.that_apply(generator.generate(seed))]
        for name in relations.BY_NAME:
            self.assertGreater(asked.count(name), 1, name)

    def test_scenes_have_every_parameter(self):
        """What a parameter file offers is in some scene, but for what `extras.NOT_TRIED` names with a reason."""
        seen = set()
        for seed in range(1, 401):
            for path in generator.generate(seed).values:
                words = path.split("/")
                for i in range(1, len(words) - 1):
                    if words[0] in ("Materials", "Bodies", "Walls", "Obstacles") and i == 1 or words[0] == "Stages" and \
                            words[i] != "Stop":
                        words[i] = "NAME"
                seen.add("/".join(words))
        for model in ("mpm", "bpm"):
            printed = subprocess.run([PROGRAM, "parameters", "--format", "json", "--model", model], check=True,
                                     capture_output=True, text=True).stdout
            left = {path for path, *_ in kinds.parameters(json.loads(printed))} - seen - set(extras.NOT_TRIED)
            self.assertEqual(sorted(left), [])

    def test_rules_know_every_parameter(self):
        """Units of rules are those that the program prints; what has a unit has a rule."""
        for model in ("mpm", "bpm"):
            printed = subprocess.run([PROGRAM, "parameters", "--format", "json", "--model", model], check=True,
                                     capture_output=True, text=True).stdout
            for path, _, _, meaning in kinds.parameters(json.loads(printed)):
                unit = kinds.unit_in(meaning)
                unit = {"N/m^2 with Model = mpm, of the length along which bodies touch; N/m with Model = bpm, of every pair "
                        "of primaries": "N/m^2" if model == "mpm" else "N/m"}.get(unit, unit)
                _, powers = kinds.kind_of(path.replace("NAME", "n"), model)
                if unit in kinds.UNITS:
                    self.assertEqual(powers, kinds.UNITS[unit], path)
            known = {path for path, *_ in kinds.parameters(json.loads(printed))}
            for pattern, *_ in kinds.RULES if model == "mpm" else ():
                if not pattern.startswith("Primaries") and "Power" not in pattern:
                    self.assertTrue(any(fnmatch.fnmatch(path, pattern) for path in known), pattern)


def numbers_of(text):
    try:
        return [float(word) for word in text.replace(";", ",").split(",")]
    except ValueError:
        return text


class Polygons(unittest.TestCase):
    def test_depths(self):
        disk = [polygons.ellipse((0, 0), 1, 1, n=400)]
        ring = [polygons.ellipse((0, 0), 4, 4, n=400), polygons.ellipse((0, 0), 2, 2, n=400)]
        moved = [disk[0] + (1.7, 0)]
        self.assertAlmostEqual(polygons.depth(disk, moved, 0.01), 0.3, delta=2e-3)
        self.assertEqual(polygons.depth(disk, [disk[0] + (2.1, 0)], 0.01), 0.0)
        self.assertEqual(polygons.depth(disk, ring, 0.01), 0.0, "a disk in the hole of a ring is outside of it")
        self.assertAlmostEqual(polygons.depth([disk[0] + (1.5, 0)], ring, 0.01), 0.5, delta=2e-3)
        self.assertAlmostEqual(polygons.gap(disk, [disk[0] + (2.1, 0)], 0.01), 0.1, delta=2e-3)
        line = polygons.line_places(numpy.array([[-3.0, 0.5], [3.0, 0.5]]), 0.01)
        self.assertAlmostEqual(polygons.depth_of_places(line, disk), 0.5, delta=2e-3)

    def test_crossing_bars(self):
        """Corners of neither are within the other: edges see it."""
        bars = [[numpy.array([(-3, -1), (3, -1), (3, 1), (-3, 1)], float)],
                [numpy.array([(-1, -3), (1, -3), (1, 3), (-1, 3)], float)]]
        self.assertAlmostEqual(polygons.depth(*bars, 0.05), 1.0, delta=0.05)


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
