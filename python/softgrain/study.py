# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A study: a scene with all values of some parameters, its errors, and what they cost.

    findings = softgrain.run_study("line_contact_study.prm", "output/studies/line_contact")
    for one in findings.results:
        print(one.point.label, one.differences["force"].error, one.cost("cpu_seconds"))
"""

import os
import subprocess
import time

from .errors import InputError
from .programs import call, find_program, last_errors
from .study_file import read_study
from .study_points import points_of
from .study_results import evaluate
from .study_runs import NOT_RUN, Lock, Runner, read_record
from .study_tables import write_csv, write_json

MOST_CHECKS = 20.  # seconds spent on looking at points before the first is run


def default_folder(path):
    return os.path.join("output", "studies", os.path.splitext(os.path.basename(path))[0])


def check_points(study, tasks, program):
    """
    Lets the program read points that have not been run, so that every value is seen once before anything is computed; of
    scenes that take long to build only some.
    """
    seen, begin = set(), time.monotonic()
    for task in tasks:
        new = set(task.values.items()) - seen
        if not new and seen:
            continue
        words = [program, "check", study.scene]
        for name, value in task.changes.items():
            words += ["--set", f"{name}={value}"]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode == 2:
            raise InputError(explain(study, task, last_errors(done.stderr) or done.stderr.strip()))
        seen |= set(task.values.items()) or {None}
        if time.monotonic() - begin > MOST_CHECKS:
            return


def explain(study, task, said):
    """The program's own line, behind the line of the study file that it is about."""
    places = {name: item.where for name, item in study.settings.items()}
    places |= {knob.parameter: knob.named_at if "unknown parameter" in said else knob.where
               for knob in study.knobs if knob.parameter}
    said = said.removeprefix("--set: ")
    about = [name for name in places if f"'{name}'" in said]
    where = places[max(about, key=len)] if about else study.path
    point = task.words(study.knobs)
    return f"{where}: {said} (at {point})"


class Session:
    """A study in its folder, between reading the file and telling what was found."""

    def __init__(self, path, output=None, changes=None, program=None):
        self.program = find_program(program)
        self.study = read_study(path, changes)
        self.output = output or default_folder(path)
        version = call((self.program, "--version")).strip()
        self.points = points_of(self.study, version)
        self.tasks = [task for point in self.points for task in point.tasks]

    def statuses(self):
        return [(task, read_record(self.output, task)["status"]) for task in self.tasks]

    def run(self, jobs=1, threads=1, again=False, say=print):
        """Runs what has not ended; False when a signal came first."""
        pending = [task for task, status in self.statuses() if status == NOT_RUN]
        if pending:
            check_points(self.study, pending, self.program)
        return Runner(self.study, self.output, self.program, threads, say).run_all(self.tasks, jobs, again)

    def lock(self):
        return Lock(self.output)

    def findings(self):
        """What there is, written as study.csv and study.json, too."""
        found = evaluate(self.study, self.points, self.output)
        write_csv(found, os.path.join(self.output, "study.csv"))
        write_json(found, os.path.join(self.output, "study.json"), self.output)
        return found


def run_study(path, output=None, set=None, jobs=1, threads=1, program=None, again=False):
    """
    Runs a study file as `softgrain study` does and returns its Findings; study.csv and study.json are written into @output.
    @set: {"Section/Name": value} for all runs; @again repeats those that failed.
    """
    session = Session(path, output, set, program)
    with session.lock():
        session.run(jobs, threads, again, say=lambda line: None)
        return session.findings()
