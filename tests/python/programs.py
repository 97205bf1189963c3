# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs and sweeps started from Python, and the package installed by pip. Arguments: see common.py."""

import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

import common
import numpy as np
import softgrain

SHORT = {"Stop/Axial strain": 0.01, "Output/Snapshots every": 0, "Output/Fields every": 0, "Output/Measures": ""}


class Programs(unittest.TestCase):
    def test_run(self):
        run = softgrain.run(common.SCENE, set={**SHORT, "Contact/Friction": 0.25}, output="one", threads=1)
        self.assertTrue(run.finished)
        self.assertIn("completed at t =", run.log)
        self.assertEqual(run.parameters["Contact/Friction"], 0.25)
        self.assertGreaterEqual(max(run.history_table["axial_strain"]), 0.01)
        before = os.stat("one/history.csv").st_mtime_ns
        same = {**SHORT, "Contact/Friction": 0.25}
        self.assertTrue(softgrain.run(common.SCENE, same, "one", again=False).finished)
        with self.assertRaisesRegex(softgrain.InputError, r"one holds another run, with Contact/Friction = 0.25 \(asked for: 0.3\): "):
            softgrain.run(common.SCENE, {**same, "Contact/Friction": 0.3}, "one", again=False)
        self.assertEqual(os.stat("one/history.csv").st_mtime_ns, before)
        # What the command line has put there since, and what it made alone, is known by nobody.
        for folder, said in (("one", "other parameters, put there since"), ("alone", "not started from Python")):
            subprocess.run([common.PROGRAM, "run", common.SCENE, "--output", folder, "--overwrite", *(
                word for name, value in SHORT.items() for word in ("--set", f"{name}={value}"))], check=True, capture_output=True)
            with self.assertRaisesRegex(softgrain.InputError, f"{folder} holds .*{said}"):
                softgrain.run(common.SCENE, same, folder, again=False)

    def test_going_on_and_beginning_anew(self):
        def stopped():
            """A run that was told to stop before its end."""
            process = subprocess.Popen([common.PROGRAM, "run", common.SCENE, "--output", "stopped", "--threads", "1", "--set",
                                        "Output/Fields every=2e-5"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while process.poll() is None and not (os.path.exists("stopped/fields.pvd") and
                                                  len(softgrain.open("stopped").fields) > 3):
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            process.wait()
            self.assertEqual(softgrain.open("stopped").status, "interrupted")

        stopped()
        checkpoint = max(glob.glob("stopped/state-*.h5"))
        branch = softgrain.run(common.SCENE, output="branch", threads=1, restart=checkpoint, set={"Output/Fields every": 2e-5})
        done = softgrain.run(common.SCENE, output="stopped", threads=1, restart=True,
                             set={"Output/Fields every": 2e-5})
        self.assertTrue(done.finished)
        begin = int(branch.history_table["step"][0])  # its own folder begins with the checkpoint
        self.assertGreater(begin, 0)
        self.assertEqual(branch.history_table["top_force_N_per_m"][1:].tolist(),
                         done.history_table["top_force_N_per_m"][begin + 1:].tolist())
        self.assertEqual(list(done.history_table["step"]), list(range(len(done.history_table))))
        shutil.rmtree("stopped")
        stopped()
        self.assertTrue(softgrain.run(common.SCENE, output="stopped", threads=1, overwrite=True).finished)
        with self.assertRaisesRegex(softgrain.InputError, "exclude each other"):
            softgrain.run(common.SCENE, output="stopped", restart=True, overwrite=True)

    def test_while_it_runs(self):
        process = subprocess.Popen([common.PROGRAM, "run", common.SCENE, "--output", "live", "--threads", "1", "--set",
                                    "Output/Snapshots every=1e-5", "--set", "Output/Fields every=1e-5", "--set", "Stop/Axial strain=0.04"],
                                   stdout=subprocess.DEVNULL)
        while not os.path.exists("live/snapshots.h5") and process.poll() is None:
            time.sleep(0.01)
        run, states = softgrain.open("live"), set()
        while process.poll() is None:
            time.sleep(0.02)
            if len(run) == 0:
                continue
            state = run[-1]
            states.add(state.number)
            self.assertEqual(len(state.bodies["coordination"]), 2)
            self.assertGreaterEqual(len(run.history_table), 1)
            if len(run.fields):
                self.assertTrue(np.isfinite(run.fields[-1].points["von_mises_Pa"]).all())
        self.assertEqual(process.returncode, 0)
        self.assertTrue(run.finished)
        self.assertGreater(len(states), 1)
        self.assertGreater(len(run), max(states) - 1)

    def test_default_folder(self):
        shutil.copy(common.SCENE, "small.prm")
        self.assertEqual(softgrain.run("small.prm", set=SHORT, threads=1).directory, os.path.join("output", "small"))

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(softgrain.InputError, "Friktion.*Friction"):
            softgrain.run(common.SCENE, set={"Contact/Friktion": 1}, output="wrong")
        with self.assertRaisesRegex(softgrain.InputError, "nothing.prm: there is no such file"):
            softgrain.run("nothing.prm")
        with self.assertRaisesRegex(softgrain.InputError, "no-such-program"):
            softgrain.run(common.SCENE, program="no-such-program")
        with self.assertRaisesRegex(softgrain.RunFailed, "over 0.01 s"):
            softgrain.run(common.SCENE, output="late", timeout=0.01)

    def test_measure(self):
        table = softgrain.measure(common.EXAMPLE)
        written = softgrain.open(common.EXAMPLE).measures_table
        self.assertEqual(list(table), list(written))
        np.testing.assert_allclose(table["coordination"], written["coordination"])

    def wheel(self, *words):
        """Makes a wheel and installs it into a folder of its own; returns the folder and what a Python finds there."""
        found = subprocess.run([sys.executable, "-c", "import setuptools, wheel, pip"], capture_output=True, check=False)
        if found.returncode:
            self.skipTest("pip, setuptools and wheel are not all there")
        name = "wheel_with" if words else "wheel_alone"
        made = subprocess.run([sys.executable, os.path.join(common.PYTHON, os.pardir, "contrib/wheel.py"), *words, "--output", name],
                              check=True, capture_output=True, text=True).stdout.strip()
        site = os.path.abspath(f"site_{name}")
        subprocess.run([sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--no-index", "--no-compile", "--target", site, made], check=True,
                       capture_output=True)
        environment = {**os.environ, "PYTHONPATH": site, "PATH": "/usr/bin:/bin"}
        del environment["SOFTGRAIN"]
        return site, made, environment

    def test_installed_by_pip(self):
        site, made, environment = self.wheel()
        self.assertRegex(made, r"^wheel_alone/softgrain-[\d.]+-py3-none-any.whl$")
        done = subprocess.run([sys.executable, "-c", "import softgrain, sys; print(softgrain.__file__); "
                               "print(len(softgrain.open(sys.argv[1])))", common.EXAMPLE], check=True, text=True,
                              capture_output=True, env=environment)
        place, n = done.stdout.split()
        self.assertEqual(place, os.path.join(site, "softgrain/__init__.py"))
        self.assertEqual(int(n), len(softgrain.open(common.EXAMPLE)))
        done = subprocess.run([sys.executable, "-m", "softgrain", "run", common.SCENE], check=False, text=True, capture_output=True,
                              env=environment)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("softgrain: error: the program softgrain is not in PATH", done.stderr)

    def test_installed_with_the_program(self):
        build = os.path.dirname(os.path.dirname(common.PROGRAM))
        subprocess.run(["cmake", "--install", build, "--prefix", os.path.abspath("prefix")], check=True,
                       capture_output=True)
        program = os.path.abspath("prefix/bin/softgrain")
        done = subprocess.run([program, "render", common.EXAMPLE, "--dpi", "40", "--output", "installed.png"], text=True,
                              check=True, capture_output=True)
        self.assertEqual(done.stdout, "installed.png\n")
        packages = glob.glob(os.path.abspath("prefix/lib/python3*/dist-packages"))
        self.assertEqual(len(packages), 1)
        environment = {**os.environ, "PYTHONPATH": packages[0]}
        del environment["SOFTGRAIN"]
        done = subprocess.run([sys.executable, "-c", "import softgrain; print(softgrain.__file__, softgrain.find_program())"],
                              text=True, check=True, capture_output=True, env=environment)
        self.assertEqual(done.stdout.split(), [os.path.join(packages[0], "softgrain/__init__.py"), program])
        # The same as a wheel: the program is found in it, its tools are run by the Python that it was installed for.
        site, made, environment = self.wheel("prefix")
        self.assertRegex(made, r"^wheel_with/softgrain-[\d.]+-py3-none-linux_\w+.whl$")
        for words, said in ((["--version"], f"^softgrain {softgrain.__version__}\n"), (["render", common.EXAMPLE, "--list"], "fields: .*pressure_Pa")):
            done = subprocess.run([sys.executable, "-m", "softgrain", *words], check=True, text=True, capture_output=True, env=environment)
            self.assertRegex(done.stdout, said)
        self.assertTrue(os.access(os.path.join(site, "softgrain/program/bin/softgrain"), os.X_OK))

    def test_version(self):
        done = subprocess.run([common.PROGRAM, "--version"], check=True, text=True, capture_output=True)
        self.assertEqual(re.search(r"\d+\.\d+\.\d+", done.stdout)[0], softgrain.__version__)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
