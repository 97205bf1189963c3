# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Right values of whole runs: those that are held, and those that are still owed.

    value_test.py PROGRAM FOLDER CASE.py

A case is a Python file with three functions. `measure(start)` runs scenes and returns what the run came to;
`is_right(found)` says whether that is the right value. A case in `held` must be right. A case in `owed` is known to be wrong:
its third function, `is_known(found)`, says whether it is wrong in the way that is known. An owed case passes when it is wrong
in that way alone. When its right value appears, the test fails until the file is moved to `held`; when the run ends in any other
way, the test fails because of that.
"""
import csv
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys

SCENES = pathlib.Path(__file__).resolve().parent / "scenes"
PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "python"


class Wrong(Exception):
    """Why a test fails."""


class Run:
    """What a run of the program came to."""

    def __init__(self, code, error, folder):
        self.code = code    # exit code
        self.error = error  # the line on stderr, empty without one
        self.folder = folder

    @property
    def summary(self):
        return json.loads((self.folder / "summary.json").read_text())

    @property
    def history(self):
        """Columns of history.csv: lists of numbers, None where a cell is empty."""
        with open(self.folder / "history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return {name: [float(row[name]) if row[name] else None for row in rows] for name in rows[0]}

    @property
    def states(self):
        """Snapshots, as softgrain.open() reads them; the last is the last good state."""
        sys.path.insert(0, str(PACKAGE))
        import softgrain
        return softgrain.open(str(self.folder))

    def __repr__(self):
        return f"exit code {self.code}" + (f", '{self.error}'" if self.error else "")


class Starter:
    """start(scene, "Section/Key=value", ...) runs a scene of the folder `scenes` with one thread."""

    def __init__(self, program, work):
        self.program, self.work, self.number = program, work, 0

    def __call__(self, scene, *settings, codes=(0, 1), words=()):
        """@param codes exit codes that the case can judge; any other, and a run that is killed, fails the test."""
        path = SCENES / scene
        if not path.exists():
            raise Wrong(f"there is no scene {path}")
        self.number += 1
        folder = self.work / f"{self.number:02d}"
        threads = () if "--threads" in words else ("--threads", "1")
        command = [self.program, "run", path, "--output", folder, *threads, *words]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        lines = done.stderr.splitlines()
        if done.returncode not in codes:
            raise Wrong(f"{scene} ends with exit code {done.returncode}, the case knows {codes}: {done.stderr[:1000]}")
        if done.returncode and (len(lines) != 1 or not lines[0].startswith("softgrain: error: ")):
            raise Wrong(f"{scene} ends with exit code {done.returncode} and not one clear line: {done.stderr[:1000]}")
        return Run(done.returncode, lines[0] if done.returncode else "", folder)


def load(path):
    spec = importlib.util.spec_from_file_location("case", path)
    case = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(case)
    if not (case.__doc__ or "").strip():
        raise Wrong(f"{path} says in no docstring what is right and why that is known")
    return case


def judge(path, program, work):
    """What there is to say of a case that passes. Throws Wrong for one that does not."""
    state = path.parent.name
    if state not in ("owed", "held"):
        raise Wrong(f"{path} lies neither in 'owed' nor in 'held'")
    case = load(path)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    found = case.measure(Starter(program, work))
    if case.is_right(found):
        if state == "owed":
            raise Wrong(f"the right value has appeared: {found}; move {path.name} from 'owed' to 'held'")
        return f"held: {found}"
    if state == "held":
        raise Wrong(f"not right: {found}")
    if not case.is_known(found):
        raise Wrong(f"wrong, and not in the way that is known: {found}")
    return f"owed: {found}"


def main():
    program, work, path = (pathlib.Path(word) for word in sys.argv[1:])
    try:
        print(judge(path, program, work))
    except Wrong as wrong:
        sys.exit(f"{path.stem}: {wrong}")


if __name__ == "__main__":
    main()
