# SPDX-License-Identifier: LGPL-2.1-or-later
"""A series of runs of a scene with some parameters changed."""

import hashlib
import itertools
import os
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Optional

import numpy as np

from .errors import InputError, RunFailed
from .folder import Run
from .made_by import Origins
from .programs import find_program, folder_name, text_of
from .runner import (
    COMPLETED,
    FAILED,
    NOT_RUN,
    TOO_LONG,
    Job,
    Lock,
    Runner,
    check_jobs,
    heeding_signals,
    is_finished,
    is_pending,
    read_record,
    write_record,
)
from .tables import Table, as_frame

MOST_CHECKS = 5.0  # seconds spent on looking at scenes before the first is run
BAD_INPUT = 2
TOLD = 3  # messages of runs that failed


@dataclass
class Row:
    """One run of a sweep."""

    changes: dict  # {"Section/Name": value}
    folder: str
    status: str  # 'completed', 'failed', 'too long'
    error: str  # what the program said, '' of a run that is completed
    wall_seconds: float
    cpu_seconds: float
    run: Optional[Run]  # None unless it is completed


class Sweep:
    """
    The runs of a sweep. `rows` has one Row for each combination. The sweep itself is the list of
    the runs that are completed, each with its `changes`; `failures` are the other rows.
    """

    def __init__(self, rows):
        self.rows = rows
        self.runs = [row.run for row in rows if row.run is not None]
        self.failures = [row for row in rows if row.run is None]

    def __repr__(self):
        return f"<sweep: {len(self.runs)} of {len(self.rows)} runs completed>"

    def __len__(self):
        return len(self.runs)

    def __getitem__(self, number):
        return self.runs[number]

    def __iter__(self):
        return iter(self.runs)

    def collect(self, function=lambda run: {}):
        """
        One row per combination: what was changed, the numbers {name: value} that function(run)
        gives, status, error and seconds; a pandas.DataFrame when pandas is installed. Numbers of
        runs that failed are NaN.
        """
        rows = [
            {**row.changes, **(function(row.run) if row.run is not None else {})}
            for row in self.rows
        ]
        names = list(dict.fromkeys(name for row in rows for name in row))
        columns = {name: np.array([row.get(name, np.nan) for row in rows]) for name in names}
        for name in ("status", "error", "wall_seconds", "cpu_seconds"):
            columns.setdefault(name, np.array([getattr(row, name) for row in self.rows]))
        return as_frame(Table(columns, "sweep"))


def cores():
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def combinations_of(over):
    """
    What is changed in each run.

    >>> combinations_of({"Packing/Seed": [1, 2], "Contact/Friction": [0.5]})
    [{'Packing/Seed': 1, 'Contact/Friction': 0.5}, {'Packing/Seed': 2, 'Contact/Friction': 0.5}]
    """
    if isinstance(over, Mapping):
        return [
            dict(zip(over, values))
            for values in itertools.product(*(list(over[name]) for name in over))
        ]
    return [dict(changes) for changes in over]


def tell(line):
    print(line, file=sys.stderr, flush=True)


def sweep(
    scene,
    over=None,
    output=None,
    set=None,
    jobs=None,
    threads=1,
    program=None,
    timeout=None,
    again=False,
    retry=False,
    say=tell,
):
    """
    Runs a scene, a parameter file or a Scene, once for every combination of the values of @over
    {"Section/Name": values}, or for every item of a list of {"Section/Name": value}. Several scenes
    are a dict {name: scene}; their name is then the change "scene". @set is changed in all runs.
    @jobs run at a time, by default as many as there are cores for @threads each.

    Each run has a folder in @output, named by what is changed and by all that makes the run: the
    scene with its includes, the files that it names, what is changed, the program. Runs that are
    there already are not repeated, those that were interrupted go on. What failed, or took longer
    than @timeout [s], is a row with its message and does not stop the others; retry=True runs it
    again, again=True all. After Ctrl-C the runs save their state, and the same call goes on. @say
    gets a line when a run has ended.
    """
    if not output:
        raise InputError("a sweep needs a folder: say output=")
    program = find_program(program)
    jobs = jobs if jobs is not None else max(1, cores() // max(1, threads))
    if jobs < 1:
        raise InputError(f"jobs is {jobs}; it must be at least 1")
    todo, changes = jobs_of(scene, combinations_of(over or {}), output, set or {}, program)
    with Lock(output), heeding_signals():
        if not again:
            say_what_is_there(todo, say)
        refuse_before(todo, program, say)
        runner = Runner(program, threads, timeout or 0.0, say)
        whole = runner.run_all(todo, jobs, "all" if again else "failed" if retry else "nothing")
    rows = [row_of(job, own) for job, own in zip(todo, changes)]
    if not whole:
        raise KeyboardInterrupt(
            f"{sum(row.run is not None for row in rows)} of {len(rows)} runs are there; the same"
            " call goes on"
        )
    found = Sweep(rows)
    if rows and not found.runs:
        told = "; ".join(dict.fromkeys(row.error for row in rows[:TOLD]))
        kind = (
            InputError
            if all(read_record(job.folder).get("exit_code") == BAD_INPUT for job in todo)
            else RunFailed
        )
        raise kind(f"all {len(rows)} runs failed: {told}")
    return found


def file_of(scene, output):
    """
    The parameter file of a scene; a Scene is written into the folder of the sweep, by a name of its
    own.
    """
    if hasattr(scene, "write"):
        name = hashlib.sha256(repr((scene.text, scene.grains)).encode()).hexdigest()[:8]
        return scene.write(os.path.join(output, f"scene-{name}.prm"), check=False)
    if not os.path.exists(scene):
        raise InputError(f"{scene}: there is no such file")
    return os.fspath(scene)


def jobs_of(scene, combinations, output, changes, program):
    """The Job of every combination, and what is changed in it."""
    found, all_changes = [], []
    for name, one in scene.items() if isinstance(scene, Mapping) else [(None, scene)]:
        path = file_of(one, output)
        origins = Origins(path, program)
        for own in combinations:
            texts = {key: text_of(value) for key, value in {**changes, **own}.items()}
            origin = origins.of(texts)
            own = own if name is None else {"scene": name, **own}
            label = (
                ", ".join(f"{key} = {text_of(value)}" for key, value in own.items()) or "the scene"
            )
            found.append(
                Job(path, os.path.join(output, folder_name(own, origin)), label, texts, origin)
            )
            all_changes.append(own)
    folders = [job.folder for job in found]
    if len(dict.fromkeys(folders)) < len(folders):
        raise InputError(
            "two combinations of the sweep are the same run, "
            f"{found[folders.index(max(folders, key=folders.count))].label}: give every value once"
        )
    return found, all_changes


def refuse_before(jobs, program, say):
    """
    Scenes that the program refuses are failures before anything is run. A name that it does not
    know is wrong in all of them.
    """
    for job, said in check_jobs(
        program, [job for job in jobs if read_record(job.folder)["status"] == NOT_RUN], MOST_CHECKS
    ):
        if "unknown parameter" in said:
            raise InputError(said)
        write_record(
            job.folder,
            job.changes,
            {
                "status": FAILED,
                "error": said,
                "exit_code": BAD_INPUT,
                "wall_seconds": 0.0,
                "cpu_seconds": 0.0,
            },
        )
        say(f"{job.label}: failed, {said}")


def say_what_is_there(jobs, say):
    """A line on runs that are not made again, where there are any."""
    done = sum(not is_pending(job) for job in jobs)
    failed = sum(read_record(job.folder)["status"] in (FAILED, TOO_LONG) for job in jobs)
    if done:
        say(
            f"{done} of {len(jobs)} runs are there"
            + (f", {failed} of them failed (retry=True runs them again)" if failed else "")
        )


def row_of(job, changes):
    """What has become of a job."""
    record = read_record(job.folder)
    run = None
    if record["status"] == COMPLETED and is_finished(job):
        run = Run(job.folder)
        run.changes = changes
    return Row(
        changes,
        job.folder,
        record["status"],
        record.get("error", ""),
        record.get("wall_seconds", np.nan),
        record.get("cpu_seconds", np.nan),
        run,
    )
