# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts the program: one run, or a series of runs with all combinations of some parameters."""

import concurrent.futures
import functools
import itertools
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

from .errors import InputError, RunFailed
from .folder import Run
from .tables import Table, as_frame

ERROR = "softgrain: error: "  # before every message of the program
HERE = pathlib.Path(__file__).resolve().parent


def find_program(program=None):
    """
    The program softgrain: the one that is named, that of the environment variable SOFTGRAIN, that which this package
    was installed or built with, or the first in PATH.
    """
    named = program or os.environ.get("SOFTGRAIN")
    if named:
        found = shutil.which(named)
        if not found:
            raise InputError(f"the program {named} cannot be started")
        return found
    # PREFIX/share/softgrain/python/softgrain, or python/softgrain in the sources.
    places = [folder / "bin" / "softgrain" for folder in HERE.parents if (folder / "share" / "softgrain").is_dir()]
    places += sorted(HERE.parents[1].glob("build/*/bin/softgrain"), key=lambda path: path.parts[-3] != "release")
    for place in places:
        if os.access(place, os.X_OK) and place.is_file():
            return str(place)
    found = shutil.which("softgrain")
    if found:
        return found
    raise InputError("the program softgrain is not in PATH: set the environment variable SOFTGRAIN to it, or say "
                     "program=...")


def text_of(value):
    """
    A value as the parameter file has it.

    >>> text_of(True), text_of(0.3), text_of((0, 1e-3)), text_of("gel")
    ('true', '0.3', '0, 0.001', 'gel')
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ", ".join(text_of(item) for item in value)
    return str(value)


def last_errors(text):
    """
    What the program said when it ended, in one line; of a wrong input it may be several, one for each mistake.

    >>> last_errors("step 1\\nsoftgrain: error: a.prm:1: no\\nsoftgrain: error: a.prm:2: nor that\\n")
    'a.prm:1: no; a.prm:2: nor that'
    """
    found = []
    for line in reversed(text.strip().splitlines()):
        if not line.startswith(ERROR):
            break
        found.append(line.strip().removeprefix(ERROR))
    return "; ".join(reversed(found))


def call(words, timeout=None):
    """Starts the program; returns what it printed."""
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired as error:
        raise RunFailed(f"over {timeout} s") from error
    if done.returncode != 0:
        said = last_errors(done.stderr) or (done.stderr.strip().splitlines() or [f"ended with status {done.returncode}"])[-1]
        raise (InputError if done.returncode == 2 else RunFailed)(said)
    return done.stdout


@functools.lru_cache(maxsize=None)
def knows(program, option):
    """Whether the command `run` of a program has an option."""
    return option in call((program, "run", "--help"))


def run(scene, set=None, output=None, threads=None, program=None, timeout=None, again=None, restart=False,
        overwrite=False, verbose=False):
    """
    Runs a parameter file with some parameters changed and returns the finished run.

    @set: {"Section/Name": value}. @output: folder of the results (default: that of the file). A run that is there
    already is an error unless something is said: of one that is finished, again=False opens it only and again=True runs it
    again; restart=True goes on with one that is not, from its newest checkpoint, and overwrite=True loses either.
    restart=FILE goes on from that checkpoint. @timeout: seconds. @verbose prints the command first.
    What the program prints is kept in the attribute `log` of the run. InputError and RunFailed tell what the program said.

    >>> run(example_scene, set={"Stop/Axial strain": 0.005}, output=scratch + "/quick").finished
    True
    """
    finished = again is not None and output is not None and os.path.isdir(output) and Run(output).finished
    if finished and not again:
        found = Run(output)
        found.log = None
        return found
    overwrite = overwrite or (finished and not restart)
    if not os.path.exists(scene):
        raise InputError(f"{scene}: there is no such file")
    if restart and overwrite:
        raise InputError("restart and overwrite exclude each other")
    words = [find_program(program), "run", os.fspath(scene)]
    for name, value in (set or {}).items():
        words += ["--set", f"{name}={text_of(value)}"]
    words += ["--output", os.fspath(output)] if output is not None else []
    words += ["--threads", str(threads)] if threads is not None else []
    if restart:
        words += ["--restart"] if restart is True else ["--restart", os.fspath(restart)]
    # A program without this option loses an unfinished run without being told to.
    words += ["--overwrite"] if overwrite and knows(words[0], "--overwrite") else []
    if verbose:
        print("#", shlex.join(words), file=sys.stderr, flush=True)
    log = call(words, timeout)
    result = Run(output if output is not None else output_of(scene, set or {}, words[0]))
    result.log = log
    return result


def output_of(scene, changes, program):
    """The folder into which the program writes when it is not told."""
    if "Output directory" in changes:
        return str(changes["Output directory"])
    from .parameters import read_entries
    entries = read_entries(scene)
    named = entries.get(("Output directory",))
    return named or os.path.join("output", pathlib.Path(scene).stem)


def name_of(changes):
    """
    A folder name that tells what was changed.

    >>> name_of({"Contact/Friction": 0.3, "Packing/Seed": 2})
    'Friction=0.3_Seed=2'
    """
    text = "_".join(f"{key.rsplit('/', 1)[-1]}={text_of(value)}" for key, value in changes.items())
    return "".join(c if c.isalnum() or c in "=._+-" else "-" for c in text) or "run"


class Sweep:
    """The runs of a sweep: a list of runs, each with `changes`, and what is worked out of all of them as a table."""

    def __init__(self, runs):
        self.runs = runs

    def __len__(self):
        return len(self.runs)

    def __getitem__(self, number):
        return self.runs[number]

    def __iter__(self):
        return iter(self.runs)

    def collect(self, function):
        """
        One row per run: what was changed, and the numbers {name: value} that function(run) gives; a pandas.DataFrame
        when pandas is installed.
        """
        import numpy as np
        rows = [{**run.changes, **function(run)} for run in self.runs]
        names = list(dict.fromkeys(name for row in rows for name in row))
        return as_frame(Table({name: np.array([row.get(name, np.nan) for row in rows]) for name in names}, "sweep"))


def sweep(scene, over, output, set=None, jobs=1, threads=1, program=None, timeout=None, again=False):
    """
    Runs a scene once for every combination of the values of @over {"Section/Name": values}, @jobs at a time, each into a
    folder of @output named after its values. @set is changed in all runs. Runs that are finished already are not
    repeated unless again=True, those that are not finished begin anew. A run that fails does not stop the others; all failures are told at the end.
    """
    names = list(over)
    combinations = [dict(zip(names, values)) for values in itertools.product(*(list(over[name]) for name in names))]
    folders = [os.path.join(output, name_of(changes)) for changes in combinations]
    if len(dict.fromkeys(folders)) < len(folders):
        raise InputError("two combinations of the sweep have the same folder: give every value once")
    program = find_program(program)

    def one(changes, folder):
        return run(scene, {**(set or {}), **changes}, folder, threads, program, timeout, again, overwrite=True)

    runs, failures = [], []
    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        futures = [pool.submit(one, changes, folder) for changes, folder in zip(combinations, folders)]
        for changes, folder, future in zip(combinations, folders, futures):
            try:
                found = future.result()
                found.changes = changes
                runs.append(found)
            except (InputError, RunFailed) as error:
                failures.append(f"{folder}: {error}")
    if failures:
        raise RunFailed(f"{len(failures)} of {len(combinations)} runs failed; " + "; ".join(failures))
    return Sweep(runs)


def measure(directory, program=None):
    """
    The values of all measures at the snapshots of a run, worked out by the program; nothing is written into the folder.
    """
    from .tables import read_table
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "measures.csv")
        call([find_program(program), "measure", os.fspath(directory), "--output", path])
        return read_table(path)
