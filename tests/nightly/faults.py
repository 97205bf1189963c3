# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are killed again and again end as the undisturbed one; damaged checkpoints are refused with one line."""
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time
import unittest

PROGRAM, PARAMETERS, WORK = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
# Small scenes that write a checkpoint after every step, so that many kills fall into a write.
SCENES = {"mpm": ["gallery/two_disks.prm", "Mesh/Cell size=1.2e-3", "Time/CFL multiple=0.05"],
          "bpm": ["gallery/one_grain_bpm.prm", "Primaries/Number per body=40", "Stop/End time=1e-3",
                  "Stop/Axial strain=0"]}
EVERY_STEP = ["Output/Checkpoint every=1e-9"]
N_KILLS = 50  # of each model


def command(model, folder, *words, settings=()):
    scene, *own = SCENES[model]
    sets = [word for setting in [*own, *EVERY_STEP, *settings] for word in ("--set", setting)]
    return [PROGRAM, "run", PARAMETERS / scene, "--threads", "1", "--output", folder, *sets, *words]


def run(*arguments, **options):
    return subprocess.run(command(*arguments, **options), capture_output=True, text=True, check=False)


def newest_state(folder):
    return max(folder.glob("state-*.h5"), default=None)


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = WORK / self.id().split(".", 1)[1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def check_kills(self, model):
        whole, killed = self.folder / "whole", self.folder / "killed"
        self.assertEqual(run(model, whole).returncode, 0)
        # Seconds of computing alone, without the start of the program.
        duration = json.loads((whole / "summary.json").read_text())["wall_seconds"]
        chance = random.Random(model)
        n_parts = n_restarts = 0
        for kill in range(N_KILLS):
            going_on = newest_state(killed) is not None
            n_restarts += going_on
            process = subprocess.Popen(command(model, killed, "--restart" if going_on else "--overwrite"),
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            # Some while the program starts, the others when it computes; together they do not reach the end of the run.
            before = newest_state(killed)
            while kill % 5 != 0 and newest_state(killed) == before and process.poll() is None:
                time.sleep(0.002)
            time.sleep(chance.uniform(0, duration / N_KILLS))
            process.kill()
            error = process.communicate()[1]
            self.assertEqual(error, "")
            n_parts += any(killed.glob("**/*.part"))
        print(f"{model}: {n_restarts} of {N_KILLS} kills after a checkpoint, {n_parts} left an unfinished file")
        self.assertGreater(n_restarts, 0)
        done = run(model, killed, "--restart")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name in ("history.csv", "fields.pvd"):
            self.assertEqual((whole / name).read_bytes(), (killed / name).read_bytes(), name)
        for path in (whole / "fields").iterdir():
            self.assertEqual(path.read_bytes(), (killed / "fields" / path.name).read_bytes(), path)

    def test_kills_mpm(self):
        self.check_kills("mpm")

    def test_kills_bpm(self):
        self.check_kills("bpm")

    def check_damage(self, model):
        good = self.folder / "good"
        end = ["Stop/End time=3e-4"]
        self.assertEqual(run(model, good, settings=end).returncode, 0)
        content = newest_state(good).read_bytes()
        damaged = self.folder / "state-000000001.h5"
        chance = random.Random(model)
        sizes = [0, 1, 7, 100, *(chance.randrange(len(content)) for _ in range(15))]
        cases = {f"cut to {size} bytes": content[:size] for size in sizes}
        for _ in range(30):
            at, bit = chance.randrange(len(content)), 1 << chance.randrange(8)
            cases[f"bit {bit} of byte {at}"] = content[:at] + bytes([content[at] ^ bit]) + content[at + 1:]
        cases["foreign"] = b"a letter"
        for what, text in cases.items():
            with self.subTest(what):
                damaged.write_bytes(text)
                out = self.folder / "out"
                done = run(model, out, "--restart", damaged, settings=end)
                self.assertEqual(done.returncode, 2, done)
                self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]*state-000000001.h5[^\n]*\n\Z")
                shutil.rmtree(out, ignore_errors=True)
        print(f"{model}: {len(cases)} damaged checkpoints refused")
        # Without a name the newest whole one is taken.
        newest_state(good).write_bytes(content[:-100])
        done = run(model, good, "--restart", settings=end)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def check_version(self, model):
        """A checkpoint of another version is refused with a line that names both."""
        good = self.folder / "good"
        end = ["Stop/End time=3e-4"]
        self.assertEqual(run(model, good, settings=end).returncode, 0)
        content = newest_state(good).read_bytes()
        mine = re.search(rb"softgrain checkpoint (\d+)", content)
        other = self.folder / "state-000000001.h5"
        other.write_bytes(content.replace(mine[0], b"softgrain checkpoint " + b"0" * len(mine[1])))
        done = run(model, self.folder / "out", "--restart", other, settings=end)
        self.assertEqual(done.returncode, 2, done)
        self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]*softgrain checkpoint 0+[^\n]*\n\Z")
        self.assertIn(mine[0].decode(), done.stderr)

    def test_other_model(self):
        """A whole checkpoint of another model is refused."""
        for mine, other in (("mpm", "bpm"), ("bpm", "mpm")):
            end = ["Stop/End time=3e-4"]
            self.assertEqual(run(other, self.folder / other, settings=end).returncode, 0)
            state = newest_state(self.folder / other)
            done = run(mine, self.folder / f"{mine} out", "--restart", state, settings=end)
            self.assertEqual(done.returncode, 2, done)
            self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]*" + state.name + r"[^\n]*\n\Z")

    def test_version_mpm(self):
        self.check_version("mpm")

    def test_version_bpm(self):
        self.check_version("bpm")

    def test_read_only(self):
        """A folder that cannot be written is refused before anything is computed."""
        if not pathlib.Path("/proc/self").exists():
            self.skipTest("no /proc")
        done = run("bpm", pathlib.Path("/proc/softgrain"))
        self.assertEqual(done.returncode, 2, done)
        self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]*/proc/softgrain[^\n]*\n\Z")

    def test_damage_mpm(self):
        self.check_damage("mpm")

    def test_damage_bpm(self):
        self.check_damage("bpm")


unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
