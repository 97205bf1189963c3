# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What is wrong is seen to be wrong, made small, and kept.

    test_faults.py PROGRAM FOLDER [NAME...]

Faults are put in on purpose: a program that turns gravity when a scene is mirrored, a snapshot with a body moved into another, a
bit that differs. Each must be found.
"""
import pathlib
import shutil
import sys
import unittest

import h5py
import numpy

import checks
import compare
import runs
import scene
import shrink
import table
import trial

PROGRAM, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

TWO_DISKS = {"Model": "mpm", "Materials/Names": "gel", "Materials/gel/Density": "1000.0",
             "Materials/gel/Neo-Hookean/Young's modulus": "1000000.0", "Materials/gel/Neo-Hookean/Poisson's ratio": "0.3",
             "Bodies/Names": "b1, b2", "Bodies/b1/Center": "-0.00390625, 0.0", "Bodies/b1/Radius": "0.00375",
             "Bodies/b2/Center": "0.00390625, 0.001", "Bodies/b2/Radius": "0.00375", "Bodies/b1/Velocity": "1.0; 0.0",
             "Loads/Gravity": "100.0, 0.0", "Mesh/Lower": "-0.015625, -0.015625", "Mesh/Upper": "0.015625, 0.015625",
             "Mesh/Cell size": "0.0009765625", "Time/Time step": "5e-05", "Stop/End time": "0.0005",
             "Output/Snapshots every": "0.00025", "Output/Checkpoint every": "0"}


def two_disks():
    return scene.Scene(TWO_DISKS, notes=["seed: 0", "tight: yes"])


def fake(name, text):
    """A program that is a script; "$PROGRAM" in it is the real one."""
    path = FOLDER / name
    path.write_text("#!/bin/sh\n" + text.replace("$PROGRAM", str(PROGRAM)) + "\n")
    path.chmod(0o755)
    return runs.Program(path)


class Faults(unittest.TestCase):
    """What is wrong is seen."""

    @classmethod
    def setUpClass(cls):
        cls.program = runs.Program(PROGRAM)
        cls.base = cls.program.run(two_disks(), FOLDER / "base")

    def test_a_good_run_is_good(self):
        self.assertEqual(checks.judge(two_disks(), self.base), [])
        found = trial.try_scene(two_disks(), self.program, FOLDER / "good", ["mirror", "units", "restart"])
        self.assertEqual([(v["relation"], v["verdict"]) for v in found],
                         [("mirror", "holds"), ("units", "holds"), ("restart", "holds")])

    def test_a_wrong_mirror_image(self):
        """A program that lets gravity be a little larger in the mirrored run."""
        wrong = fake("wrong_mirror", 'case "$PWD" in *mirror) set -- "$@" --set "Loads/Gravity=-100.01, 0";; esac\n'
                     'exec $PROGRAM "$@"')
        found = trial.try_scene(two_disks(), wrong, FOLDER / "wrong", ["mirror", "turn"])
        self.assertEqual([(v["verdict"], v["kind"]) for v in found], [("fails", "differs"), ("holds", "")])

    def test_a_bit(self):
        other = self.copy("bit")
        with h5py.File(next((other.out / "snapshots").glob("*1.h5")), "r+") as file:
            array = file["bodies/center_m"][()]
            array[0, 0] = numpy.nextafter(array[0, 0], 1)
            file["bodies/center_m"][...] = array
        self.assertIn("bodies/center_m", compare.same_bits(self.base, other))
        self.assertIsNone(compare.same_bits(self.base, self.copy("no bit")))

    def test_a_number_that_is_none(self):
        other = self.copy("none")
        with h5py.File(next((other.out / "snapshots").glob("*1.h5")), "r+") as file:
            file["bodies/velocity_m_per_s"][0, 0] = numpy.nan
        self.assertEqual([kind for kind, _ in checks.judge(two_disks(), other)], ["not finite"])

    def test_bodies_in_each_other(self):
        other = self.copy("overlap")
        with h5py.File(next((other.out / "snapshots").glob("*1.h5")), "r+") as file:
            places, rings = file["outlines/points_m"][()], file["outlines/ring_offsets"][()]
            places[rings[1]:rings[2]] -= (0.001, 0)
            file["outlines/points_m"][...] = places
        self.assertEqual([kind for kind, _ in checks.judge(two_disks(), other)], ["overlap"])

    def test_energy_and_momentum_from_nothing(self):
        other = self.copy("energy")
        with h5py.File(next((other.out / "snapshots").glob("*2.h5")), "r+") as file:
            file["energies/kinetic_energy_J_per_m"][...] = 1.5 * file["energies/kinetic_energy_J_per_m"][()]
            file["bodies/velocity_m_per_s"][...] = 1.001 * file["bodies/velocity_m_per_s"][()]
        self.assertEqual([kind for kind, _ in checks.judge(two_disks(), other)], ["energy", "momentum"])

    def copy(self, name):
        shutil.rmtree(FOLDER / name, ignore_errors=True)
        shutil.copytree(self.base.folder, FOLDER / name)
        return runs.Run(FOLDER / name, 0, "", 0.0)

    def test_ends(self):
        ends = {"kill -SEGV $$": "crash", "exit 134": "crash", "exit 1": "message",
                'echo "softgrain: error: scene.prm: it does not please me" >&2; exit 2': "refused",
                'echo "softgrain: error: something went wrong somewhere" >&2; exit 1': "unclear end",
                "while :; do :; done": "hang"}
        for index, (text, kind) in enumerate(ends.items()):
            program = fake(f"ends{index}", text)
            program.limit = 1
            self.assertEqual(checks.end(program.run(two_disks(), FOLDER / "ends"))[0], kind, text)


class Small(unittest.TestCase):
    def test_a_failure_is_made_small_and_kept(self):
        """A program that crashes where there is a body b2: one body is left, and nothing that is optional."""
        program = fake("crashes", "grep -q 'subsection b2' scene.prm && kill -SEGV $$\n"
                       "echo 'softgrain: error: fine otherwise' >&2; exit 2")
        small, seen = shrink.shrink(two_disks(), program, FOLDER / "small", "run", "crash", 60)
        self.assertEqual(small.names("Bodies"), ["b2"])
        self.assertNotIn("Loads/Gravity", small.values)
        path = shrink.keep(small, FOLDER / "kept", "run", "crash", seen)
        self.assertEqual(scene.read(path), small)
        self.assertEqual(scene.read(path).note("relation"), "run")

    def test_what_is_owed(self):
        (FOLDER / "owed.txt").write_text("# known\n7 run / energy: a kick\n8 mirror / differs: markers\n")
        known = table.owed(FOLDER / "owed.txt")
        verdicts = {7: ("run", "fails", "energy"), 8: ("mirror", "holds", ""), 9: ("run", "fails", "hang")}
        records = [{"seed": seed, "model": "mpm", "scheme": "explicit", "family": "box", "seconds": 1,
                    "verdicts": [dict(zip(("relation", "verdict", "kind", "seen"), (*verdict, "so")))]}
                   for seed, verdict in verdicts.items()]
        lines, new = table.report(records, known)
        self.assertTrue(new)
        self.assertEqual(len(lines), 2)
        self.assertIn("seed 9", lines[0])
        self.assertIn("no longer owed", lines[1])
        self.assertFalse(table.report(records[:2], known)[1])

if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
