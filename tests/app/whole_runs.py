# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of whole runs share. Arguments: program, folder of parameter files, folder to work in, names of tests."""
import contextlib
import json
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

PROGRAM, PARAMETERS, WORK = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
# Small scenes of both models; each takes a second.
SCENES = {"mpm": ["gallery/two_disks.prm", "Mesh/Cell size=1.2e-3"],
          "bpm": ["gallery/one_grain_bpm.prm", "Primaries/Number per body=40", "Stop/End time=2e-3",
                  "Stop/Axial strain=0"],
          "held": ["gallery/thirty_grains_quasi_static_mpm.prm", "Packing/Number=6", "Packing/Packing fraction=0.6",
                   "Mesh/Cell size=6.4e-4", "Walls/top/Velocity=5", "Output/Fields every=0", "Output/Snapshots every=0",
                   "Stop/End time=6.4e-4"]}
# Steps that take seconds, by their mesh, or minutes, by sweeps towards a tolerance that rounding forbids.
LONG_STEPS = {"mpm": ["Mesh/Cell size=1.3e-4", "Time/CFL multiple=1000", "Output/Number of field outputs=0"],
              "bpm": ["Walls/Names=bottom, top, left, right", "Walls/left/Point=-2.1e-3, 0",
                      "Walls/right/Point=2.1e-3, 0", "Walls/top/Velocity=20", "Contact/Algorithm=gauss_seidel",
                      "Contact/Tolerance=1e-14", "Contact/Wall tolerance=1e-14", "Contact/Maximum sweeps=2000000000"],
              "held": ["Mesh/Cell size=1.3e-4", "Quasi-static/Unbalanced force=1e-12", "Quasi-static/Held steps=100000"]}
MANY_STEPS = ["Time/CFL multiple=1e-4", "Output/Number of field outputs=0"]


def command(model, folder, *words, settings=()):
    scene, *own = SCENES[model]
    sets = [word for setting in [*own, *settings] for word in ("--set", setting)]
    return [PROGRAM, "run", PARAMETERS / scene, "--threads", "1", "--output", folder, *sets, *words]


def status(folder):
    return json.loads((folder / "summary.json").read_text())["status"]


def states(folder):
    return sorted(folder.glob("state-*.h5"))


def wait_for_rows(folder, number, process=None):
    """
    Waits until the history has so many lines, or the process has ended: no machine is too fast or too slow for that. False after
    a minute.
    """
    path, deadline = folder / "history.csv", time.monotonic() + 60
    while not path.exists() or path.read_bytes().count(b"\n") < number:
        if process is not None and process.poll() is not None:
            return True
        if time.monotonic() > deadline:
            return False
        time.sleep(0.005)
    return True


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = WORK / self.id().split(".", 1)[1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.parent.mkdir(parents=True, exist_ok=True)

    def run_scene(self, model, *words, settings=(), expect=0, **options):
        """Runs to the end; (stdout, stderr), after the exit code and, for errors, the one line have been looked at."""
        done = subprocess.run(command(model, self.folder, *words, settings=settings), capture_output=True, text=True,
                              check=False, **options)
        self.assertEqual(done.returncode, expect, done)
        self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]+\n\Z" if expect in (1, 2) else r"\A\Z")
        return done.stdout, done.stderr

    def wait_for_rows(self, number):
        self.assertTrue(wait_for_rows(self.folder, number))

    @contextlib.contextmanager
    def running(self, model, *words, settings=(), seconds=0.7):
        """A run that has begun to compute; killed at the end of the block if it is still there."""
        process = subprocess.Popen(command(model, self.folder, *words, settings=settings), stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        try:
            wait_for_rows(self.folder, 1, process)
            time.sleep(seconds)
            self.assertIsNone(process.poll())
            yield process
        finally:
            if process.poll() is None:
                process.kill()
            process.communicate()


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
