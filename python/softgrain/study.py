# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A study: a scene with all values of some parameters, its errors, and what they cost.

    findings = softgrain.run_study("line_contact_study.prm", "output/studies/line_contact")
    for one in findings.results:
        print(one.point.label, one.differences["force"].error, one.cost("cpu_seconds"))
"""

import os

from .errors import InputError
from .made_by import Origins
from .programs import find_program
from .runner import NOT_RUN, Job, Lock, Runner, check_jobs, heeding_signals, read_record
from .study_file import read_study
from .study_points import folder_of, points_of
from .study_quantities import check_columns
from .study_results import evaluate
from .study_tables import write_csv, write_json

MOST_CHECKS = 20.0  # seconds spent on looking at points before the first is run


def default_folder(path):
    return os.path.join("output", "studies", os.path.splitext(os.path.basename(path))[0])


def check_points(study, jobs, program):
    """
    Lets the program read points that have not been run, so that every value is seen before anything
    is computed.
    """
    for job, said in check_jobs(program, jobs, MOST_CHECKS):
        raise InputError(explain(study, job, said))


def explain(study, job, said):
    """The program's own line, behind the line of the study file that it is about."""
    places = {name: item.where for name, item in study.settings.items()}
    places |= {
        knob.parameter: knob.named_at if "unknown parameter" in said else knob.where
        for knob in study.knobs
        if knob.parameter
    }
    about = [name for name in places if f"'{name}'" in said]
    where = places[max(about, key=len)] if about else study.path
    return f"{where}: {said} (at {job.label})"


class Session:
    """A study in its folder, between reading the file and telling what was found."""

    def __init__(self, path, output=None, changes=None, program=None):
        self.program = find_program(program)
        self.study = read_study(path, changes)
        self.output = output or default_folder(path)
        self.points = points_of(self.study, Origins(self.study.scene, self.program))
        self.tasks = [task for point in self.points for task in point.tasks]
        self.jobs = [
            Job(
                self.study.scene,
                folder_of(self.output, task),
                task.words(self.study.knobs),
                task.changes,
                task.origin,
            )
            for task in self.tasks
        ]

    def statuses(self):
        return [
            (task, read_record(job.folder)["status"]) for task, job in zip(self.tasks, self.jobs)
        ]

    def run(self, jobs=1, threads=1, again=False, say=print):
        """Runs what has not ended; False when a signal came first."""
        new = [job for job in self.jobs if read_record(job.folder)["status"] == NOT_RUN]
        check_points(self.study, new, self.program)
        runner = Runner(
            self.program,
            threads,
            self.study.longest_run,
            say,
            lambda run: check_columns(run, self.study.quantities),
        )  # before all others are run for nothing
        return runner.run_all(self.jobs, jobs, "failed" if again else "nothing")

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
    Runs a study file as `softgrain study` does and returns its Findings; study.csv and study.json
    are written into @output. @set: {"Section/Name": value} for all runs; @again repeats those that
    failed.
    """
    session = Session(path, output, set, program)
    with session.lock(), heeding_signals():
        session.run(jobs, threads, again, say=lambda line: None)
        return session.findings()
