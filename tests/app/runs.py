# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run does on a full disk, under signals, beside another run, over old results: nothing is lost or silent."""
import json
import os
import pty
import re
import resource
import shutil
import signal
import subprocess
import time

import whole_runs
from whole_runs import LONG_STEPS, MANY_STEPS, PROGRAM, WORK, Runs, command, states, status


def limit_files(n_bytes):
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (n_bytes, n_bytes))


class FullDisk(Runs):
    """A disk that takes no more ends the run with one line; what it held before is whole."""

    def check(self, model, ends):
        self.run_scene(model, settings=[*ends[0], "Output/History every=1000"])
        old = states(self.folder)
        limit = max(path.stat().st_size for path in old) // 2
        for _ in range(2):
            _, error = self.run_scene(model, "--restart", settings=[*ends[1], "Output/History every=1000"], expect=1,
                                      preexec_fn=limit_files(limit))
            self.assertIn("File too large", error)
            self.assertIn(f"the newest checkpoint is {old[-1]}", error)
            self.assertEqual(status(self.folder), "failed")
            self.assertEqual(states(self.folder), old)
            self.assertEqual(list(self.folder.glob("**/*.part")), [])
        self.run_scene(model, "--restart", settings=ends[1])
        self.assertEqual(status(self.folder), "completed")

    def test_history(self):
        """The history, not a state, is what the disk refuses first."""
        with self.running("mpm", settings=[*MANY_STEPS, "Output/Checkpoint every=0"], seconds=0) as process:
            self.wait_for_rows(10)
            limit = (self.folder / "history.csv").stat().st_size
            resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (limit, limit))
            error = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 1, error)
        self.assertRegex(error, r"\Asoftgrain: error: [^\n]*history.csv: cannot be written: File too large[^\n]+\n\Z")
        self.assertEqual(status(self.folder), "failed")

    def test_mpm(self):
        self.check("mpm", (["Stop/End time=3e-4", "Output/Number of field outputs=0"],
                           ["Stop/End time=1.2e-3", "Output/Number of field outputs=0"]))

    def test_bpm(self):
        self.check("bpm", (["Stop/End time=1e-3", "Output/Fields every=0"],
                           ["Stop/End time=2e-3", "Output/Fields every=0"]))

    def test_small_disk(self):
        self.folder.mkdir()
        mount = ["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", self.folder]
        if os.geteuid() != 0 or subprocess.run(mount, check=False).returncode != 0:
            self.skipTest("cannot mount a small disk")
        try:
            small = ["Output/Checkpoint every=1e-9", "Output/Checkpoints kept=100"]
            _, error = self.run_scene("mpm", settings=small, expect=1)
            self.assertIn("No space left on device", error)
            self.assertEqual(status(self.folder), "failed")
            self.assertGreaterEqual(len(states(self.folder)), 1)
        finally:
            subprocess.run(["umount", self.folder], check=True)


class OldResults(Runs):
    """A new run replaces what another one has left when it is told so, and nothing else."""

    def test_unfinished(self):
        with self.running("mpm", settings=MANY_STEPS) as process:
            process.send_signal(signal.SIGINT)
            process.wait(60)
        self.assertEqual(status(self.folder), "interrupted")
        before = {path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
        _, error = self.run_scene("mpm", expect=2)
        self.assertRegex(error, r"holds a run that has not ended \('interrupted' at t = .*, step \d+\): "
                                r"add --restart .* or --overwrite")
        self.assertEqual(before, {path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()})
        self.run_scene("mpm", "--restart", settings=["Time/CFL multiple=2"])
        # The same command does not delete what has ended.
        ended = {path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
        _, error = self.run_scene("mpm", expect=2)
        self.assertIn("holds a finished run: add --overwrite to replace it, or name another folder", error)
        self.assertEqual(ended, {path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()})
        self.run_scene("mpm", "--overwrite")
        (self.folder / "summary.json").write_text("{")
        self.run_scene("mpm", expect=2)
        self.run_scene("mpm", "--overwrite")
        self.assertEqual(status(self.folder), "completed")

    def test_killed_before_a_checkpoint(self):
        with self.running("mpm", settings=MANY_STEPS) as process:
            process.kill()
            process.wait(60)
        _, error = self.run_scene("mpm", expect=2)
        self.assertIn("has no checkpoint: add --overwrite", error)
        self.run_scene("mpm", "--restart", expect=2)  # another run than that which was killed
        self.run_scene("mpm", "--overwrite")

    def test_foreign_files(self):
        self.run_scene("mpm")
        foreign = [self.folder / name for name in ("state-of-the-art.h5", "letter.part", "fields/mine.vtu", "notes.txt",
                                                   "history.csv.old")]
        for path in foreign:
            path.write_text("mine")
        (self.folder / "history.csv.part").write_text("ours")
        drawn = [self.folder / name for name in ("pictures/pressure-000007.png", "pictures/speed.mp4",
                                                 "pictures/force-against-time.png", "report.html")]
        foreign.append(self.folder / "pictures/cat.png")
        foreign[-1].parent.mkdir()
        for path in [*drawn, foreign[-1]]:
            path.write_text("mine")
        self.run_scene("mpm", "--overwrite", settings=["Output/Number of field outputs=0"])
        self.assertEqual([path for path in drawn if path.exists()], [])  # of the run that is gone
        self.assertEqual([path.read_text() for path in foreign], ["mine"] * len(foreign))
        self.assertEqual([path.name for path in (self.folder / "fields").iterdir()], ["mine.vtu"])
        self.assertFalse((self.folder / "history.csv.part").exists())
        # The name of a checkpoint, and none: a run would write over it.
        mine = self.folder / "state-000000003.h5"
        mine.write_text("mine")
        for words in ((), ("--overwrite",)):
            _, error = self.run_scene("mpm", *words, expect=2)
            self.assertIn("holds state-000000003.h5, which has the name of a checkpoint and is none", error)
        self.assertEqual(mine.read_text(), "mine")

    def test_earlier_checkpoint(self):
        """Going on from an older checkpoint gives up the later ones: they are not taken for newer ones afterwards."""
        base = ["Output/Checkpoint every=1e-9", "Output/Checkpoints kept=100"]
        self.run_scene("mpm", settings=base)
        self.run_scene("mpm", "--restart", states(self.folder)[2], settings=[*base, "Stop/End time=5e-4"])
        said, _ = self.run_scene("mpm", "--restart", settings=base)
        self.assertIn("'Stop/End time': 5e-4 -> 1.2e-3", said)
        # Into the results of another run it may not go.
        other, self.folder = self.folder, WORK / "OldResults.other"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.run_scene("mpm")
        _, error = self.run_scene("mpm", "--restart", states(other)[-1], expect=2)
        self.assertIn("holds the results of another run", error)


class OneFolder(Runs):
    """A folder belongs to one run at a time, and a run notices when it loses it."""

    def test_two_runs(self):
        with self.running("mpm", settings=MANY_STEPS) as first:
            for words in ((), ("--overwrite",), ("--restart",)):
                _, error = self.run_scene("mpm", *words, expect=2)
                self.assertIn(f"is in use by another run (process {first.pid} on ", error)
            first.kill()
            first.wait(60)
            # The file of the lock is still there; its owner is not.
            self.assertTrue((self.folder / "run.lock").exists())
            self.run_scene("mpm", "--overwrite")
        self.assertFalse((self.folder / "run.lock").exists())

    def test_no_folder_of_mpi(self):
        # Open MPI's folder is shared by all programs that no launcher has started: of two that start or end at the same
        # moment one may abort. A run needs none, so it does not mind that none can be made.
        self.run_scene("mpm", env={**os.environ, "OMPI_MCA_orte_tmpdir_base": "/proc/none"})

    def lost(self, lose):
        with self.running("mpm", settings=MANY_STEPS) as process:
            lose()
            error = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 1, error)
        self.assertRegex(error, r"\Asoftgrain: error: the output folder [^\n]+ is gone: it was removed, renamed or "
                                r"replaced[^\n]+\n\Z")

    def test_removed(self):
        def remove():
            # The lock first: a run that misses only its history saves its state, and the folder is not empty again.
            (self.folder / "run.lock").unlink()
            shutil.rmtree(self.folder, ignore_errors=True)  # the run removes it too once it is empty

        self.lost(remove)
        self.assertFalse(self.folder.exists())

    def test_renamed(self):
        moved = self.folder.with_suffix(".moved")
        shutil.rmtree(moved, ignore_errors=True)
        self.lost(lambda: self.folder.rename(moved))
        self.assertTrue((moved / "history.csv").exists())

    def test_history_removed(self):
        with self.running("mpm", settings=MANY_STEPS) as process:
            (self.folder / "history.csv").unlink()
            error = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 1, error)
        self.assertRegex(error, r"\Asoftgrain: error: [^\n]*history.csv was removed[^\n]*; the last good state is saved "
                                r"in [^\n]+\n\Z")


class Signals(Runs):
    """A signal stops a run within its step; the state before the step is saved and the run goes on from it."""

    def check(self, model, number, more=(), seconds=0.7):
        with self.running(model, settings=LONG_STEPS[model], seconds=seconds) as process:
            begin = time.monotonic()
            process.send_signal(number)
            for repeated in more:  # as `timeout` and schedulers do: to the process and to its group
                process.send_signal(repeated)
            said, error = process.communicate(timeout=60)
            waited = time.monotonic() - begin
        self.assertEqual((process.returncode, error), (3, ""), said)
        self.assertLess(waited, 5)  # one, on a machine that does nothing else
        self.assertEqual(status(self.folder), "interrupted")
        self.assertIn(f"the state is saved in {states(self.folder)[-1]}; the same command with --restart goes on", said)

    def test_terminate_mpm(self):
        self.check("mpm", signal.SIGTERM, [signal.SIGTERM])
        # As if never stopped.
        allowed = [*LONG_STEPS["mpm"], "Stop/End time=3e-4"]
        self.run_scene("mpm", "--restart", settings=allowed)
        resumed = (self.folder / "history.csv").read_text()
        self.run_scene("mpm", "--overwrite", settings=allowed)
        self.assertEqual(resumed, (self.folder / "history.csv").read_text())

    def test_terminate_bpm(self):
        self.check("bpm", signal.SIGTERM)

    def test_held(self):
        """Without inertia a step goes on with its walls at rest until the bodies are in balance."""
        self.check("held", signal.SIGTERM, seconds=2)

    def test_as_if_never_stopped_held(self):
        many = ["Time/Time step=3.2e-6"]
        for n_before in range(3):
            with self.running("held", *(["--restart"] if n_before else []), settings=many, seconds=0) as process:
                self.wait_for_rows(30 * (n_before + 1))
                process.send_signal(signal.SIGTERM)
                self.assertEqual(process.wait(60), 3)
        self.run_scene("held", "--restart", settings=many)
        resumed = (self.folder / "history.csv").read_text()
        self.run_scene("held", "--overwrite", settings=many)
        self.assertEqual(resumed, (self.folder / "history.csv").read_text())

    def test_as_if_never_stopped_bpm(self):
        many = ["Time/Step fraction=0.01", "Output/Fields every=0"]
        with self.running("bpm", settings=many, seconds=0) as process:
            self.wait_for_rows(30)
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(60), 3)
        self.run_scene("bpm", "--restart", settings=many)
        resumed = (self.folder / "history.csv").read_text()
        # The checkpoint has the primaries: no aggregate is prepared again.
        phases = json.loads((self.folder / "summary.json").read_text())["phases"]
        self.assertNotIn("preparation of aggregates", phases)
        self.run_scene("bpm", "--overwrite", settings=many)
        self.assertEqual(resumed, (self.folder / "history.csv").read_text())

    def test_hang_up(self):
        self.check("mpm", signal.SIGHUP)

    def test_processor_time(self):
        self.check("mpm", signal.SIGXCPU)

    def test_ignored(self):
        """Under nohup a closed terminal stops nothing."""
        old = signal.signal(signal.SIGHUP, signal.SIG_IGN)
        try:
            with self.running("mpm", settings=MANY_STEPS) as process:
                process.send_signal(signal.SIGHUP)
                time.sleep(1)
                self.assertIsNone(process.poll())
        finally:
            signal.signal(signal.SIGHUP, old)

    def test_help(self):
        said = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
        self.assertIn("3 interrupted by a signal", said)


class RunLog(Runs):
    """run.log has what the terminal shows, without its control characters, and grows when a run goes on."""

    def log(self):
        return (self.folder / "run.log").read_text()

    def test_of_a_file(self):
        for model in ("mpm", "bpm"):
            shutil.rmtree(self.folder, ignore_errors=True)
            said, _ = self.run_scene(model)
            self.assertEqual(self.log(), said)
            self.assertRegex(said, r"\nt = \S+ s  step \d+ .* 100\.0 %  left 0 s\ncompleted at ")

    def test_going_on(self):
        first, _ = self.run_scene("mpm", settings=["Stop/End time=3e-4"])
        with open(self.folder / "run.log", "a", encoding="utf-8") as file:
            file.write("t = 3.1e-04 s  st")  # as a kill leaves it
        second, _ = self.run_scene("mpm", "--restart", settings=["Stop/End time=4e-4", "Contact/Maximum sweeps=3000"])
        self.assertRegex(second, r"^softgrain .*\nmodel mpm, results in .*\nchanged since the checkpoint: 'Contact/Maximum sweeps'")
        self.assertEqual(self.log(), first + "t = 3.1e-04 s  st\n" + second)
        third, _ = self.run_scene("mpm", "--overwrite", settings=["Stop/End time=1e-4"])
        self.assertEqual(self.log(), third)

    def test_error(self):
        self.run_scene("mpm", settings=["Stop/End time=3e-4"])
        _, error = self.run_scene("mpm", "--restart", settings=["Stop/End time=1e-3", "Output/Number of field outputs=0"],
                                  expect=1, preexec_fn=limit_files(states(self.folder)[0].stat().st_size // 2))
        self.assertTrue(self.log().endswith(error.removeprefix("softgrain: ")), self.log())

    def test_of_a_terminal(self):
        own, other = pty.openpty()
        process = subprocess.Popen(command("mpm", self.folder, settings=["Stop/End time=2e-3"]), stdout=other, stderr=other)
        os.close(other)
        shown = b""
        try:
            while part := os.read(own, 65536):
                shown += part
        except OSError:  # the other end is closed
            pass
        os.close(own)
        self.assertEqual(process.wait(), 0)
        self.assertIn(b"\rt = ", shown)
        log = self.log()
        self.assertNotRegex(log, r"[^\S\n ]|[\x00-\x09\x0b-\x1f]")
        # Head and end are the same; of the line that changes the file has the last state.
        lines = [line.split("\r")[-1].rstrip() for line in re.sub("\r+\n", "\n", shown.decode()).split("\n")]
        self.assertEqual([line.rstrip() for line in log.split("\n")], lines)


whole_runs.main()
