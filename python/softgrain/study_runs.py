# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Runs the points of a study, some at a time. What a run cost is kept beside its folder, so that it is not lost with the
study: finished runs are used again, interrupted ones go on, failed ones are recorded.
"""

import concurrent.futures
import fcntl
import glob
import json
import os
import signal
import subprocess
import threading
import time

from .errors import InputError
from .folder import Run
from .programs import ERROR, last_errors
from .study_points import folder_of
from .study_quantities import check_columns

NOT_RUN, COMPLETED, FAILED, INTERRUPTED, TOO_LONG = "not run", "completed", "failed", "interrupted", "too long"
ENDED = (COMPLETED, FAILED, TOO_LONG)  # not begun again without being asked to
GRACE = 60.  # seconds that a run has to save its state


def record_path(output, task):
    return folder_of(output, task) + ".json"


def read_record(output, task):
    """What is known of a run: status, error, seconds; a run of which nothing is known has not begun."""
    try:
        with open(record_path(output, task), encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        return {"status": NOT_RUN}
    except ValueError:
        return {"status": INTERRUPTED}  # the computer stopped while it was written


def write_record(output, task, record):
    path = record_path(output, task)
    temporary = f"{path}.part"
    with open(temporary, "w", encoding="utf-8") as file:
        json.dump({"changes": task.changes, **record}, file, indent=1)
    os.replace(temporary, path)


class Lock:
    """One study at a time in a folder; the system frees it whatever happens to the process."""

    def __init__(self, output):
        os.makedirs(os.path.join(output, "runs"), exist_ok=True)
        self.file = open(os.path.join(output, ".lock"), "w", encoding="utf-8")  # noqa: SIM115  (open as long as the lock)
        try:
            fcntl.flock(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            self.file.close()
            raise InputError(f"another study is running in {output}") from error

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()


class Runner:
    """Starts the runs of a study; `say` gets a line when one has ended."""

    def __init__(self, study, output, program, threads=1, say=print):
        self.study, self.output, self.program, self.threads, self.say = study, output, program, threads, say
        self.stopping, self.done, self.total = threading.Event(), 0, 0
        self.printing = threading.Lock()

    def run_all(self, tasks, jobs, again=False):
        """
        Runs what has not ended; with @again what has failed, too. True when all have ended, False when a signal came
        first.
        """
        pending = []
        for task in tasks:
            status = read_record(self.output, task)["status"]
            if status == COMPLETED and not is_finished(folder_of(self.output, task)):
                status = NOT_RUN  # its folder was removed
            if status not in ENDED or (again and status != COMPLETED):
                pending.append(task)
        self.total = len(pending)
        with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
            futures = [pool.submit(self.run_one, task) for task in pending]
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

    def words_of(self, task, folder):
        words = [self.program, "run", self.study.scene]
        for name, value in task.changes.items():
            words += ["--set", f"{name}={value}"]
        words += ["--output", folder]
        if "Threads" not in task.changes:
            words += ["--threads", str(self.threads)]
        if glob.glob(os.path.join(glob.escape(folder), "state-*.h5")) and not is_finished(folder):
            return [*words, "--restart"]
        return [*words, "--overwrite"]

    def run_one(self, task):
        if self.stopping.is_set():
            return
        folder = folder_of(self.output, task)
        words = self.words_of(task, folder)
        earlier = self.earlier_cost(task, folder) if words[-1] == "--restart" else {}
        write_record(self.output, task, {"status": INTERRUPTED, **earlier})
        begin = time.monotonic()
        with open(folder + ".log", "a" if earlier else "w", encoding="utf-8") as log:
            process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)
            code, usage, too_long = self.wait(process, begin)
        record = {"status": self.status_of(code, too_long)}
        for name, value in (("wall_seconds", time.monotonic() - begin),
                            ("cpu_seconds", usage.ru_utime + usage.ru_stime)):
            record[name] = round(value + earlier.get(name, 0.), 3)
        if record["status"] == FAILED:
            record["error"] = error_of(folder + ".log", code)
        elif record["status"] == TOO_LONG:
            record["error"] = f"not finished after {self.study.longest_run:g} s"
        write_record(self.output, task, record)
        if record["status"] == COMPLETED:
            check_columns(Run(folder), self.study.quantities)  # before all others are run for nothing
        with self.printing:
            self.done += 1
            self.say(f"[{self.done}/{self.total}] {task.words(self.study.knobs)}: {record['status']}"
                     f"{', ' + record['error'] if 'error' in record else ''}, {record['wall_seconds']:.1f} s")

    def earlier_cost(self, task, folder):
        """
        What a run cost before it was interrupted. When this process was killed, too, nobody wrote it down: then it is the
        time of the last checkpoint, and as much of the processor.
        """
        record = read_record(self.output, task)
        known = {name: record[name] for name in ("wall_seconds", "cpu_seconds") if name in record}
        if known:
            return known
        seconds = float((Run(folder).summary or {}).get("wall_seconds", 0.))
        return {"wall_seconds": seconds, "cpu_seconds": seconds}

    def wait(self, process, begin):
        """(exit code, resources, whether it took too long) once it has ended, told to end or by itself."""
        told, too_long, pause = None, False, 0.005
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = os.waitstatus_to_exitcode(status)
                return process.returncode, usage, too_long
            now = time.monotonic()
            too_long = too_long or 0 < self.study.longest_run < now - begin
            if told is None and (too_long or self.stopping.is_set()):
                process.send_signal(signal.SIGTERM)
                told = now
            elif told is not None and now - told > GRACE:
                process.kill()
            time.sleep(pause)
            pause = min(0.1, 1.3 * pause)

    def status_of(self, code, too_long):
        if code == 0:
            return COMPLETED
        if too_long:
            return TOO_LONG
        # 3: a signal stopped it. Below 0: a signal killed it, that of a user's key among them.
        return INTERRUPTED if code == 3 or self.stopping.is_set() else FAILED


def is_finished(folder):
    return os.path.isdir(folder) and Run(folder).finished


def error_of(path, code):
    """The program's own line."""
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = [line.strip() for line in file if line.strip()]
    own = [number for number, line in enumerate(lines) if line.startswith(ERROR)]
    return last_errors("\n".join(lines[:own[-1] + 1])) if own else f"ended by signal {-code}" if code < 0 else f"ended with status {code}"
