# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Runs some scenes, several at a time: those of a study or of a sweep. What a run cost is kept beside
its folder, so that it is not lost when all is interrupted: finished runs are used again,
interrupted ones go on, failed ones are recorded.
"""

import concurrent.futures
import contextlib
import fcntl
import glob
import json
import os
import re
import signal
import subprocess
import threading
import time
from dataclasses import dataclass
from typing import Any, Set

from .errors import InputError
from .folder import Run
from .made_by import Origin, why_not, write_origin
from .programs import GRACE, error_of, last_errors

NOT_RUN, COMPLETED, FAILED, INTERRUPTED, TOO_LONG = (
    "not run",
    "completed",
    "failed",
    "interrupted",
    "too long",
)
ENDED = (COMPLETED, FAILED, TOO_LONG)  # not begun again without being asked to
PROGRESS = re.compile(
    r"([\d.]+) %\s+left (.+?)\s*$", re.MULTILINE
)  # of a line of the program's log


@dataclass
class Job:
    """One run: its folder, which is named by what makes it, and what the scene is changed in."""

    scene: str  # its parameter file
    folder: str
    label: str
    changes: dict  # {"Section/Name": text}
    origin: Origin


def record_path(folder):
    return folder + ".json"


def read_record(folder):
    """
    What is known of a run: status, error, seconds; a run of which nothing is known has not begun.
    """
    try:
        with open(record_path(folder), encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        return {"status": NOT_RUN}
    except ValueError:
        return {"status": INTERRUPTED}  # the computer stopped while it was written


def write_record(folder, changes, record):
    path = record_path(folder)
    temporary = f"{path}.part"
    with open(temporary, "w", encoding="utf-8") as file:
        json.dump({"changes": changes, **record}, file, indent=1)
    os.replace(temporary, path)


class Lock:
    """
    One study or sweep at a time in a folder; the system frees it whatever happens to the process.
    """

    def __init__(self, output):
        os.makedirs(output, exist_ok=True)
        self.file = open(
            os.path.join(output, ".lock"), "w", encoding="utf-8"
        )  # noqa: SIM115  (open as long as the lock)
        try:
            fcntl.flock(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            self.file.close()
            raise InputError(f"another study or sweep is running in {output}") from error

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()


@contextlib.contextmanager
def heeding_signals():
    """
    Within it the signals of a scheduler or of a lost terminal are heeded as Ctrl-C is: runs save
    their state.
    """
    usual = {}
    if threading.current_thread() is threading.main_thread():
        usual = {number: signal.getsignal(number) for number in (signal.SIGTERM, signal.SIGHUP)}
        for number, handler in usual.items():
            if handler == signal.SIG_DFL:
                signal.signal(number, signal.default_int_handler)
    try:
        yield
    finally:
        for number, handler in usual.items():
            signal.signal(number, handler)


class Runner:
    """
    Starts runs. @longest: seconds that one may take, 0: no limit. @say gets a line when one has
    ended, and of those that go on every minute; @look, which may raise an InputError, the Run of
    each that is completed.
    """

    every = 60.0  # seconds between lines on a run that goes on

    def __init__(self, program, threads=1, longest=0.0, say=print, look=lambda run: None):
        self.program, self.threads, self.longest, self.say, self.look = (
            program,
            threads,
            longest,
            say,
            look,
        )
        self.stopping, self.printing = threading.Event(), threading.Lock()
        self.done, self.total, self.at_once, self.spent = 0, 0, 1, 0.0

    def run_all(self, jobs, at_once, again="nothing"):
        """
        Runs the jobs that have not ended, so many @at_once; with @again = 'failed' what has failed,
        too, with 'all' every one anew. True when all have ended, False when a signal came first.
        """
        pending = [job for job in jobs if is_pending(job, again)]
        self.total, self.at_once = len(pending), min(at_once, len(pending))
        for job in pending:
            os.makedirs(os.path.dirname(job.folder) or ".", exist_ok=True)
        with concurrent.futures.ThreadPoolExecutor(max_workers=at_once) as pool:
            futures = [pool.submit(self.run_one, job, again == "all") for job in pending]
            try:
                for future in futures:
                    future.result()
            except BaseException as error:
                self.stopping.set()
                for future in futures:
                    future.cancel()
                if not isinstance(error, KeyboardInterrupt):
                    raise
        return not self.stopping.is_set()

    def words_of(self, job, anew):
        words = [self.program, "run", job.scene]
        for name, value in job.changes.items():
            words += ["--set", f"{name}={value}"]
        words += ["--output", job.folder]
        if "Threads" not in job.changes:
            words += ["--threads", str(self.threads)]
        begun = (
            glob.glob(os.path.join(glob.escape(job.folder), "state-*.h5"))
            and not Run(job.folder).finished
        )
        return [
            *words,
            "--overwrite" if anew or not begun or why_not(job.folder, job.origin) else "--restart",
        ]

    def run_one(self, job, anew):
        if self.stopping.is_set():
            return
        words = self.words_of(job, anew)
        earlier = earlier_cost(job.folder) if words[-1] == "--restart" else {}
        write_record(job.folder, job.changes, {"status": INTERRUPTED, **earlier})
        begin = time.monotonic()
        with open(job.folder + ".log", "a" if earlier else "w", encoding="utf-8") as log:
            process = subprocess.Popen(
                words, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT
            )
            code, usage, too_long = self.wait(process, begin, job)
        record = {"status": self.status_of(code, too_long), "exit_code": code}
        for name, value in (
            ("wall_seconds", time.monotonic() - begin),
            ("cpu_seconds", usage.ru_utime + usage.ru_stime),
        ):
            record[name] = round(value + earlier.get(name, 0.0), 3)
        if record["status"] == FAILED:
            with open(job.folder + ".log", encoding="utf-8", errors="replace") as log:
                record["error"] = error_of(log.read(), code)
        elif record["status"] == TOO_LONG:
            record["error"] = f"not finished after {self.longest:g} s"
        write_origin(job.folder, job.origin)
        write_record(job.folder, job.changes, record)
        if record["status"] == COMPLETED:
            self.look(Run(job.folder))
        with self.printing:
            self.tell(job, record, time.monotonic() - begin)

    def tell(self, job, record, seconds):
        """A line on a run that has ended, with what the others may take."""
        self.done, self.spent = self.done + 1, self.spent + seconds
        left = self.spent / self.done * (self.total - self.done) / self.at_once
        self.say(
            f"[{self.done}/{self.total}] {job.label}: {record['status']}"
            f"{', ' + record['error'] if 'error' in record else ''}, {record['wall_seconds']:.1f} s"
            + (f", left about {left:.0f} s" if left >= 1.0 and not self.stopping.is_set() else "")
        )

    def tell_progress(self, job):
        """A line on a run that goes on, of what it says itself."""
        with open(job.folder + ".log", encoding="utf-8", errors="replace") as log:
            found = PROGRESS.findall(log.read())
        if found:
            with self.printing:
                self.say(f"{job.label}: {found[-1][0]} %, left {found[-1][1]}")

    def wait(self, process, begin, job):
        """
        (exit code, resources, whether it took too long) once it has ended, told to end or by
        itself.
        """
        told, too_long, pause, said = None, False, 0.005, begin
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = os.waitstatus_to_exitcode(status)
                return process.returncode, usage, too_long
            now = time.monotonic()
            too_long = too_long or 0 < self.longest < now - begin
            if told is None and (too_long or self.stopping.is_set()):
                process.send_signal(signal.SIGTERM)
                told = now
            elif told is not None and now - told > GRACE:
                process.kill()
            if now - said > self.every:
                said = now
                self.tell_progress(job)
            time.sleep(pause)
            pause = min(0.1, 1.3 * pause)

    def status_of(self, code, too_long):
        if code == 0:
            return COMPLETED
        if too_long:
            return TOO_LONG
        # 3: a signal stopped it. Below 0: a signal killed it, that of a user's key among them.
        return INTERRUPTED if code == 3 or self.stopping.is_set() else FAILED


def earlier_cost(folder):
    """
    What a run cost before it was interrupted. When this process was killed, too, nobody wrote it
    down: then it is what its summary says, that of the last checkpoint.
    """
    record = read_record(folder)
    known = {name: record[name] for name in ("wall_seconds", "cpu_seconds") if name in record}
    if known:
        return known
    summary = Run(folder).summary or {}
    seconds = float(summary.get("wall_seconds", 0.0))
    return {
        "wall_seconds": seconds,
        "cpu_seconds": float(summary.get("processor_seconds", seconds)),
    }


def check_jobs(program, jobs, seconds):
    """
    Lets the program read scenes before the first is run; of many, or of those that take long to
    build, only some: until every value was seen once, or @seconds have passed. Gives (job, what the
    program said) for each that it refuses.
    """
    seen: Set[Any] = set()
    begin = time.monotonic()
    for job in jobs:
        own = {("", job.scene), *job.changes.items()}
        new = own - seen
        if not new:
            continue
        words = [program, "check", job.scene, "--output", job.folder]
        for name, value in job.changes.items():
            words += ["--set", f"{name}={value}"]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode == 2:
            yield job, (last_errors(done.stderr) or done.stderr.strip()).removeprefix("--set: ")
        seen |= own
        if time.monotonic() - begin > seconds:
            return


def is_pending(job, again="nothing"):
    """Whether a run is still to be made."""
    status = read_record(job.folder)["status"]
    if status == COMPLETED and not is_finished(job):
        return True  # its folder was removed, or another run was put there
    return again == "all" or status not in ENDED or (again == "failed" and status != COMPLETED)


def is_finished(job):
    """
    Whether the run is there. Its folder has a name of its own, so that only what was put there
    since can be another one.
    """
    return (
        os.path.isdir(job.folder)
        and Run(job.folder).finished
        and not why_not(job.folder, job.origin)
    )
