# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Sweeps: runs are known by all that made them, one that fails is a row, Ctrl-C ends all and the same call goes on. Arguments: see
common.py.
"""

import glob
import os
import re
import signal
import stat
import subprocess
import sys
import time
import unittest

import common
import numpy as np
import softgrain
from softgrain.runner import Runner

SHORT = {"Stop/Axial strain": 0.01, "Output/Snapshots every": 0, "Output/Fields every": 0, "Output/Measures": ""}
# A program of another kind, which is quick: it only says when its runs begin and end.
STAND_IN = """#!/bin/sh
[ "$1" = run ] || exit 0
while [ "$1" != --output ]; do shift; done
mkdir -p "$2"
echo "t = 1 s  step 7  41.5 %  left 3 min 20 s"
date +"%s.%N begin" >> times; sleep {pause}; date +"%s.%N end" >> times
echo "set Model = mpm" > "$2/parameters.prm"
echo '{{"status": "completed"}}' > "$2/summary.json"
"""
INTERRUPTED = """
import sys
import softgrain.sweeps
softgrain.sweeps.MOST_CHECKS = 0.
softgrain.sweep(sys.argv[1], {"Contact/Friction": [0, 0.1, 0.2]}, "stopped", set={"Time/CFL multiple": 0.05, "Stop/Axial strain": 0.02}, jobs=2)
"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def stand_in(name, pause=0, comment=""):
    path = write(name, STAND_IN.format(pause=pause) + comment)
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    return os.path.abspath(path)


class Origins(unittest.TestCase):
    def asked(self, said, **changes):
        """Asks for a sweep of one run of scene.prm, which is made, or there from before."""
        lines = []
        found = softgrain.sweep("scene.prm", {"Walls/top/Velocity": [0.5]}, "known", set=changes, program="./program", say=lines.append)
        self.assertEqual(lines, ["1 of 1 runs are there"] if said == "there" else [lines[0]])
        self.assertRegex(lines[0], "are there$" if said == "there" else r"^\[1/1\] Walls/top/Velocity = 0.5: completed")
        return found[0].directory

    def test_all_that_made_a_run(self):
        """Another scene, another set, another file that is included or named, another program: other runs; the same again: none."""
        stand_in("program")
        write("grains.csv", "x_m,y_m,radius_m\n2e-3,2e-3,2e-3\n2e-3,6e-3,2e-3\n")
        write("common.prm", "subsection Packing\n  set File = grains.csv\nend\n")
        write("scene.prm", "include common.prm\n")
        first = self.asked("made")
        self.assertEqual(self.asked("there"), first)
        write("scene.prm", "include common.prm  # another text that says the same\n")
        self.assertEqual(self.asked("there"), first)
        folders = [first, self.asked("made", **{"Contact/Friction": 0.5})]
        for name, old, new in (("scene.prm", "#", "\nset Fidelity = draft #"), ("common.prm", "end", "  set Material = gel\nend"),
                               ("grains.csv", "6e-3,2e-3", "6e-3,1.9e-3"), ("program", "echo", "# another build\necho")):
            write(name, read(name).replace(old, new, 1))
            folders.append(self.asked("made"))
            self.assertEqual(self.asked("there"), folders[-1])
        self.assertEqual(len(set(folders)), 6)
        self.assertEqual(self.asked("there"), folders[-1])

    def test_scene_of_python(self):
        """A Scene is as good as a file, and another one is another run."""
        scene = softgrain.Scene()
        for friction in (0.1, 0.2, 0.1):
            scene.contact.friction = friction
            softgrain.sweep(scene, {"Packing/Seed": [1, 2]}, "seeds", program=stand_in("program"), say=lambda line: None)
        self.assertEqual(len(glob.glob("seeds/Seed=*-*/")), 4)

    def test_several_scenes(self):
        """Mixtures made in Python, at a time; those that differ in the places of their disks alone are different, too."""
        scenes = {}
        for seed in (1, 2):
            scenes[seed] = softgrain.Scene()
            scenes[seed].place([0, 1, 2], 0, np.random.default_rng(seed).uniform(0.3, 0.4, 3))
        found = softgrain.sweep(scenes, {"Contact/Friction": [0, 1]}, "mixtures", program=stand_in("program"), say=lambda line: None)
        self.assertEqual([run.changes for run in found], [{"scene": seed, "Contact/Friction": friction} for seed in (1, 2) for friction in (0, 1)])
        self.assertEqual(len(glob.glob("mixtures/scene-*_grains.csv")), 2)
        self.assertEqual(list(found.collect()["scene"]), [1, 1, 2, 2])
        with self.assertRaisesRegex(softgrain.InputError, "needs a folder"):
            softgrain.sweep(scenes)

    def test_another_run_in_a_folder(self):
        """A folder of the sweep in which something else was run since is none of its runs."""
        stand_in("program")
        write("scene.prm", "set Model = mpm\n")
        folder = self.asked("made")
        self.asked("there")
        write(os.path.join(folder, "parameters.prm"), "set Model = bpm\n")
        self.assertEqual(self.asked("made"), folder)
        self.assertEqual(read(os.path.join(folder, "parameters.prm")), "set Model = mpm\n")


class Rows(unittest.TestCase):
    def test_failures(self):
        """What is refused, fails or takes too long is a row with its message; the others are returned."""
        lines, bad = [], "Bodies/upper/Velocity"
        over = [{"Contact/Friction": 0.1}, {"Contact/Friction": -1}, {bad: "1e9*cos(x*1e9); 0"}]
        found = softgrain.sweep(common.SCENE, over, "failing", set=SHORT, say=lines.append)
        self.assertEqual([row.status for row in found.rows], ["completed", "failed", "failed"])
        self.assertEqual([run.changes for run in found], over[:1])
        self.assertRegex(found.failures[0].error, "'Contact/Friction' = '-1' is not allowed")
        self.assertRegex(found.failures[1].error, "time no longer moves")
        table = found.collect(lambda run: {"steps": run.summary["steps"]})
        self.assertEqual([str(status) for status in table["status"]], ["completed", "failed", "failed"])
        self.assertEqual(np.isfinite(np.asarray(table["steps"], dtype=float)).tolist(), [True, False, False])
        self.assertIn("'-1' is not allowed", table["error"][1])
        self.assertEqual(len([line for line in lines if "failed" in line]), 2, lines)
        # They are not tried again without being asked to.
        lines.clear()
        self.assertEqual(len(softgrain.sweep(common.SCENE, over, "failing", set=SHORT, say=lines.append).failures), 2)
        self.assertEqual(lines, ["3 of 3 runs are there, 2 of them failed (retry=True runs them again)"])
        with self.assertRaisesRegex(softgrain.InputError, "all 1 runs failed: 'Contact/Friction' = '-1' is not allowed"):
            softgrain.sweep(common.SCENE, over[1:2], "failing", set=SHORT, say=lines.append)
        with self.assertRaisesRegex(softgrain.InputError, "Friktion.*did you mean 'Friction'"):
            softgrain.sweep(common.SCENE, {"Contact/Friktion": [0, 1]}, "unknown", say=lines.append)
        self.assertEqual(os.listdir("unknown"), [".lock"])
        with self.assertRaisesRegex(softgrain.RunFailed, "all 1 runs failed: not finished after 0.1 s"):
            softgrain.sweep(common.SCENE, {"Contact/Friction": [0]}, "late", timeout=0.1, program=stand_in("slow", 1), say=lines.append)
        with self.assertRaisesRegex(softgrain.InputError, "the same run, Contact/Friction = 0: give every value once"):
            softgrain.sweep(common.SCENE, {"Contact/Friction": [0, 0]}, "twice")

    def test_some_at_a_time(self):
        program = stand_in("counting", 0.1)
        for jobs in (1, 3):
            write("times", "")
            lines = []
            softgrain.sweep(common.SCENE, {"Packing/Seed": range(5)}, f"jobs_{jobs}", jobs=jobs, program=program, say=lines.append)
            running, most = 0, 0
            for line in sorted(read("times").splitlines()):
                running += 1 if line.endswith("begin") else -1
                most = max(most, running)
            self.assertEqual(most, jobs)
            self.assertEqual(sorted(line.partition(" ")[0] for line in lines), [f"[{number}/5]" for number in range(1, 6)])

    def test_progress(self):
        """Of a run that takes long there is a line now and then, with what it says itself."""
        usual, Runner.every = Runner.every, 0.05
        lines = []
        try:
            softgrain.sweep(common.SCENE, {"Packing/Seed": [4]}, "slowly", program=stand_in("slowly_", 0.3), say=lines.append)
        finally:
            Runner.every = usual
        self.assertEqual(lines[0], "Packing/Seed = 4: 41.5 %, left 3 min 20 s")
        self.assertRegex(lines[-1], "^.1/1. Packing/Seed = 4: completed")


class Interrupted(unittest.TestCase):
    def test_it_goes_on(self):
        """Ctrl-C: both runs save their state. Then they go on from there, and end as if nothing had been."""
        words = [sys.executable, "-c", INTERRUPTED, common.SCENE]
        environment = {**os.environ, "PYTHONPATH": common.PYTHON}
        process = subprocess.Popen(words, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

        def rows():
            return [read(path).count("\n") for path in sorted(glob.glob("stopped/*/history.csv"))]

        while process.poll() is None and not (len(rows()) == 2 and min(rows()) > 3):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=100)
        self.assertNotEqual(process.returncode, 0)
        done = len(re.findall(": completed", errors))  # where the machine is slow one may have ended before
        self.assertLess(done, 2, errors)
        self.assertIn(f"KeyboardInterrupt: {done} of 3 runs are there; the same call goes on", errors)
        self.assertEqual(sorted(softgrain.open(folder).status for folder in glob.glob("stopped/*/")),
                         ["completed"] * done + ["interrupted"] * (2 - done))
        before = {path: read(path) for path in glob.glob("stopped/*/history.csv")}
        again = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(again.stderr.count(": completed"), 3 - done)
        for path, text in before.items():
            self.assertTrue(read(path).startswith(text[:text.rindex("\n", 0, -1)]))
        for folder in glob.glob("stopped/*/"):
            steps = list(softgrain.open(folder).history_table["step"])
            self.assertEqual(steps, list(range(len(steps))))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
