# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A run that is killed in any of its writes, or to which the disk refuses one, goes on with --restart to the same files as an
undisturbed one, byte for byte but for times of the clock. Pictures and snapshots are on the disk before a checkpoint that says so has
its name. A library that is loaded before the C library stops the program.
Quick: the first call of every kind to some of the files; with SOFTGRAIN_ALL_WRITES every call.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

import h5py
import numpy as np

import whole_runs
from whole_runs import PARAMETERS, PROGRAM, WORK

LIBRARY = os.environ["SOFTGRAIN_TEST_PRELOAD"]
ALL = "SOFTGRAIN_ALL_WRITES" in os.environ
OUTPUT = ["Output/Number of field outputs=0", "Output/Measures=all", "Output/Checkpoints kept=1", "Stages/Names=first, second"]
# Two stages of a few steps; the first ends on a time of pictures and snapshots, the second does not.
SCENES = {"mpm": ("gallery/two_disks.prm",
                  ["Mesh/Cell size=2e-3", "Stop/End time=0", "Time/CFL multiple=4", "Bodies/left/Center=-4.99e-3, 0",
                   "Stages/first/Stop/End time=2e-4", "Stages/second/Stop/End time=1.7e-4", "Output/Fields every=1e-4",
                   "Output/Snapshots every=1e-4"]),
          "bpm": ("gallery/one_grain_bpm.prm",
                  ["Primaries/Number per body=30", "Stop/Axial strain=0", "Stages/first/Stop/End time=4e-5",
                   "Stages/second/Stop/End time=3e-5", "Output/Fields every=2e-5", "Output/Snapshots every=2e-5"]),
          "space": ("verification/sphere_between_plates.prm",
                    ["Mesh/Cell size=2.2e-3", "Stop/End time=0.1", "Output/Number of field outputs=2", "Output/Snapshots every=0.05"])}
CLOCK = {"wall_seconds", "processor_seconds", "microseconds_per_point_step", "phases", "peak_memory_bytes"}


def content_of_state(path):
    """All lists of a checkpoint but the seconds that it has taken."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    found["driver/statistics"] = found["driver/statistics"][1:]
    del found["driver/processor_seconds"]
    return {name: value.tobytes() if isinstance(value, np.ndarray) else value for name, value in found.items()}


def content_of(folder):
    found = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if name == "run.log" or path.is_dir():
            continue
        if name.startswith(("state-", "stage-")) and name.endswith(".h5"):
            found[name] = content_of_state(path)
        elif name == "summary.json":
            found[name] = {key: value for key, value in json.loads(path.read_text()).items() if key not in CLOCK}
        else:
            found[name] = path.read_bytes()
    return found


def not_on_the_disk(calls):
    """Pictures and snapshots that a checkpoint came before: they had their names, and nobody had waited for the disk."""
    late, found = set(), []
    for what, path in calls:
        path = pathlib.Path(path)
        if what == "rename" and path.parent.name in ("fields", "snapshots"):
            late.add((path.parent.name, path.name))
        elif what == "fsync":
            late.discard((path.parent.name, path.name))
        elif what == "rename" and path.name.startswith(("state-", "stage-")):
            found += sorted(late)
    return found


class Writes(unittest.TestCase):
    def calls_of_run(self, model, *output):
        """The calls for files of an undisturbed run, where no checkpoint comes before what it says is written."""
        self.folder = WORK / f"writes.{model}"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.scene, settings = SCENES[model]
        self.settings = [*settings, *output]
        calls = self.folder / "calls"
        done = self.run_it("whole", STOP_LIST=calls)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        calls = [line.split(" ", 1) for line in calls.read_text().splitlines()]
        self.assertGreater(sum(what == "rename" and "/fields/" in path for what, path in calls), 8)
        self.assertGreater(sum(what == "rename" and "/snapshots/" in path for what, path in calls), 2)
        self.assertEqual(not_on_the_disk(calls), [])
        return calls

    def prepare(self, model):
        calls = self.calls_of_run(model, *OUTPUT)
        self.whole = content_of(self.folder / "whole/out")
        self.assertIn("stage-first.h5", self.whole)
        self.assertEqual(len([name for name in self.whole if name.startswith("state-")]), 1)
        return calls

    def run_it(self, name, *words, **environment):
        place = self.folder / name
        place.mkdir(exist_ok=True)
        sets = [word for setting in self.settings for word in ("--set", setting)]
        added = {**environment, "LD_PRELOAD": LIBRARY, "STOP_FOLDER": place / "out", "STOP_NAME": "out"} if environment else {}
        return subprocess.run([PROGRAM, "run", PARAMETERS / self.scene, "--threads", "1", "--output", "out", *sets, *words], cwd=place,
                              env={**os.environ, **{key: str(value) for key, value in added.items()}}, capture_output=True,
                              text=True, check=False)

    def compare(self, name, what):
        found = content_of(self.folder / name / "out")
        self.assertEqual(sorted(found), sorted(self.whole), what)
        for file, content in self.whole.items():
            if isinstance(content, dict):
                self.assertEqual([key for key in {*content, *found[file]} if content.get(key) != found[file].get(key)], [],
                                 (what, file))
            else:
                self.assertEqual(found[file] == content, True, (what, file))

    def disturb(self, number, how, call):
        """One run that is stopped at a call, and goes on; returns whether it was stopped."""
        what = f"{how} at call {number}, {call[0]} {pathlib.Path(call[1]).name}"
        shutil.rmtree(self.folder / "stopped", ignore_errors=True)
        done = self.run_it("stopped", STOP_AT=number, STOP_HOW=how)
        if how == "kill":
            self.assertEqual(done.returncode, -9, what)
        elif done.returncode == 0:  # what was refused does no harm
            self.assertEqual(done.stderr, "", what)
            return False
        else:
            self.assertIn(done.returncode, (1, 2), what)
            self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]+\n\Z", what)
        out = self.folder / "stopped/out"
        goes_on = ["--restart"] if (out / "parameters.prm").exists() else []  # else nothing has begun
        done = self.run_it("stopped", *goes_on)
        self.assertEqual((done.returncode, done.stderr), (0, ""), what)
        self.compare("stopped", what)
        return True

    def check(self, model):
        calls = self.prepare(model)
        numbers = range(1, len(calls) + 1)
        if not ALL:
            # The first of each kind to every file that stays, as these differ; of those every few.
            seen = {}
            for number, (what, path) in enumerate(calls, 1):
                name = re.sub(r"\d{6,}", "N", str(pathlib.Path(path).name)).removesuffix(".part")
                seen.setdefault((what, name), []).append(number)
            chosen = sorted(numbers[len(numbers) // 2] for numbers in seen.values())
            numbers = [chosen[k] for k in range(3, len(chosen), len(chosen) // 4)]
        n_stopped = {"kill": 0, "refuse": 0}
        for number in numbers:
            for how in n_stopped:
                n_stopped[how] += self.disturb(number, how, calls[number - 1])
        print(f"{model}: {len(calls)} calls, {len(numbers)} of them tried, stopped and gone on {n_stopped}")
        self.assertEqual(n_stopped["kill"], len(numbers))
        self.assertGreater(n_stopped["refuse"], len(numbers) // 3)

    def test_mpm(self):
        self.check("mpm")

    def test_bpm(self):
        self.check("bpm")

    def test_space(self):
        self.calls_of_run("space")


whole_runs.main()
