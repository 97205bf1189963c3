# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of a program: with limits of time, and what they leave behind as arrays."""
import csv
import dataclasses
import functools
import json
import math
import os
import pathlib
import resource
import shutil
import subprocess

import h5py
import numpy

from kinds import UNITS


@dataclasses.dataclass
class Run:
    folder: pathlib.Path
    code: int
    message: str
    seconds: float

    @property
    def out(self):
        return self.folder / "out"

    def history(self):
        """Columns of the history as arrays; empty cells are not numbers."""
        with open(self.out / "history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return {name: numpy.array([float(row[name]) if row[name] else math.nan for row in rows]) for name in rows[0]}

    def snapshots(self):
        return [read_snapshot(path) for path in sorted((self.out / "snapshots").glob("*.h5"))]


def read_snapshot(path):
    """All arrays of a snapshot by name, and the unit of each by its name and "unit of "."""
    arrays = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset):
            arrays[name] = item[()]
            unit = item.attrs.get("units")
            if unit is not None:
                arrays["unit of " + name] = unit.decode() if isinstance(unit, bytes) else str(unit)

    with h5py.File(path, "r") as file:
        arrays["time_s"], arrays["step"] = float(file.attrs["time_s"]), int(file.attrs["step"])
        file.visititems(visit)
    return arrays


def texts(array):
    return [value.decode() if isinstance(value, bytes) else str(value) for value in array]


def by_name(snapshot, group, array):
    """Rows of an array of bodies, walls or obstacles by the names of these."""
    if f"{group}/name" not in snapshot:
        return {}
    return dict(zip(texts(snapshot[f"{group}/name"]), snapshot[f"{group}/{array}"]))


def outlines(snapshot):
    """Of each body its rings."""
    places = snapshot["outlines/points_m"]
    ring, body = snapshot["outlines/ring_offsets"], snapshot["outlines/body_offsets"]
    return [[places[ring[r]:ring[r + 1]] for r in range(body[b], body[b + 1])] for b in range(len(body) - 1)]


def unit_of(text):
    return UNITS[text]


@functools.lru_cache
def linear_solvers(path):
    """Those that a program was built with."""
    printed = subprocess.run([path, "parameters", "--format", "json", "--model", "mpm"], check=True, capture_output=True,
                             text=True).stdout
    return json.loads(printed)["Linear solver"]["Type"]["allowed"].removeprefix("one of ").split(", ")


class Program:
    """A program under test. Counts the processor time of all its runs."""

    def __init__(self, path, limit=60):
        self.path, self.limit = pathlib.Path(path).resolve(), limit
        self.seconds, self.n = 0.0, 0

    def fitted(self, scene):
        """A scene whose linear solver this program was built without takes the default; the answer is the same."""
        solver = scene.get("Linear solver/Type")
        if solver and solver not in linear_solvers(self.path):
            scene.values = {path: value for path, value in scene.values.items() if not path.startswith("Linear solver/")}
        return scene

    def run(self, scene, folder, threads=1, more=(), keep=False, limit=0):
        """Runs a scene in a folder of its own. Code 124 says that it did not end. @param limit: where it may take longer"""
        limit = max(limit, self.limit)
        if not keep:
            shutil.rmtree(folder, ignore_errors=True)
            scene.save(folder)
        words = [str(self.path), "run", "scene.prm", "--threads", str(threads), "--output", "out", *more]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, timeout=10 * limit,
                                  env={**os.environ, "TMPDIR": str(folder), "OPENBLAS_NUM_THREADS": "1"},
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
            code, message = done.returncode, done.stderr.strip()
        except subprocess.TimeoutExpired:
            code, message = 124, ""
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if code in (3, -24, -9):  # SIGXCPU is a warning before a limit: the run saves its state and ends
            code = 124
        self.seconds, self.n = self.seconds + seconds, self.n + 1
        return Run(folder, code, message, seconds)
