# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the system refuses, files, memory, long names, a full device, ends with one line and the code that is meant."""
import resource
import shutil
import subprocess
import unittest

import whole_runs
from whole_runs import PARAMETERS, PROGRAM, Runs, command, status

SCENE = PARAMETERS / "gallery/two_disks.prm"
LOADER = 127  # the program could not be loaded: not ours to say


def limit(what, number):
    return lambda: resource.setrlimit(what, (number, number))


class Limits(Runs):
    def check(self, done, codes, text=""):
        self.assertIn(done.returncode, codes, done)
        if done.returncode in (1, 2):
            self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]+\n\Z")
            self.assertLess(len(done.stderr), 1500)
            self.assertIn(text, done.stderr)

    def start(self, *words, **options):
        return subprocess.run([PROGRAM, *words], stderr=subprocess.PIPE, text=True, check=False, **options)

    def test_full_device(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            for words in (["check", SCENE], ["parameters"], ["measure", "--list"]):
                self.check(self.start(*words, stdout=full), [1], "cannot be written")
            # The run has its files; that nobody sees it go on is no fault of it.
            done = subprocess.run(command("mpm", self.folder), stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(status(self.folder), "completed")
        # A device is no place for a table: it would be replaced by a file.
        self.run_scene("mpm", "--overwrite", settings=["Output/Snapshots every=3e-4"])
        done = self.start("measure", self.folder, "--output", "/dev/full", stdout=subprocess.DEVNULL)
        self.check(done, [1], "/dev/full: what is there is no file")

    def test_open_files(self):
        codes = []
        for number in (4, 8, 20, 40):
            shutil.rmtree(self.folder, ignore_errors=True)
            done = subprocess.run(command("mpm", self.folder), capture_output=True, text=True, check=False,
                                  preexec_fn=limit(resource.RLIMIT_NOFILE, number))
            self.check(done, [0, 1, 2, LOADER])
            codes.append(done.returncode)
        self.assertEqual(codes[-1], 0)
        self.assertTrue({1, 2} & set(codes), codes)

    def test_address_space(self):
        codes = []
        for megabytes in (100, 200, 300, 400, 500, 600, 800, 1200, 4000):
            shutil.rmtree(self.folder, ignore_errors=True)
            done = subprocess.run(command("mpm", self.folder, settings=["Output/Number of field outputs=0"]),
                                  capture_output=True, text=True, check=False,
                                  preexec_fn=limit(resource.RLIMIT_AS, megabytes << 20))
            self.check(done, [0, 1, LOADER])
            codes.append(done.returncode)
        self.assertEqual(codes[-1], 0)

    def test_long_names(self):
        long = "x" * 300
        for words in (["check", SCENE, "--output", self.folder / long],
                      ["check", SCENE, "--output", self.folder.joinpath(*["y" * 200] * 20)],
                      ["check", long + ".prm"], ["run", "/".join(["z" * 200] * 30) + ".prm"],
                      ["check", SCENE, "--set", f"Stages/Names={long}"], ["check", SCENE, "--set", f"Bodies/Names={long}"]):
            self.check(self.start(*words, stdout=subprocess.DEVNULL), [2])
        done = self.start("check", SCENE, "--set", f"Stages/Names={long}", stdout=subprocess.DEVNULL)
        self.check(done, [2], "it has 300 letters, 100 are allowed")
        done = self.start("check", SCENE, "--output", self.folder / long, stdout=subprocess.DEVNULL)
        self.check(done, [2], "has 300 letters, a name has at most 255")
        done = self.start("check", long + ".prm", stdout=subprocess.DEVNULL)
        self.check(done, [2], "name too long")
        # The longest that is allowed runs to its end.
        stage, body = "s" * 100, "b" * 100
        self.run_scene("mpm", settings=[f"Stages/Names={stage}, last", f"Stages/{stage}/Stop/End time=2e-5",
                                        f"Bodies/Names=left, right, {body}", f"Bodies/{body}/Center=0, 8e-3",
                                        f"Bodies/{body}/Radius=1e-3", "Mesh/Upper=0.0105, 0.0105", "Stop/End time=4e-5",
                                        "Stages/last/Stop/End time=1"])
        self.assertTrue((self.folder / f"stage-{stage}.h5").exists())


whole_runs.main()
