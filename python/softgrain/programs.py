# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts the program for one run."""

import functools
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
from dataclasses import replace

from .errors import InputError, RunFailed
from .folder import Run
from .made_by import Origins, digest_of, entries_of, why_not, write_origin

ERROR = "softgrain: error: "  # before every message of the program
GRACE = 60.0  # seconds that a run has to save its state
HERE = pathlib.Path(__file__).resolve().parent


def find_program(program=None):
    """
    The program softgrain: the one that is named, that of the environment variable SOFTGRAIN, that
    which this package was installed or built with, or the first in PATH.
    """
    named = program or os.environ.get("SOFTGRAIN")
    if named:
        found = shutil.which(named)
        if not found:
            raise InputError(f"the program {named} cannot be started")
        return found
    # In a wheel, PREFIX/share/softgrain/python/softgrain, or python/softgrain in the sources.
    places = [HERE / "program" / "bin" / "softgrain"]
    places += [
        folder / "bin" / "softgrain"
        for folder in HERE.parents
        if (folder / "share" / "softgrain").is_dir()
    ]
    places += sorted(
        HERE.parents[1].glob("build/*/bin/softgrain"), key=lambda path: path.parts[-3] != "release"
    )
    for place in places:
        if os.access(place, os.X_OK) and place.is_file():
            return str(place)
    found = shutil.which("softgrain")
    if found:
        return found
    raise InputError(
        "the program softgrain is not in PATH: set the environment variable SOFTGRAIN to it, or say"
        " program=..."
    )


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
    What the program said when it ended, in one line; of a wrong input it may be several, one for
    each mistake.

    >>> last_errors("step 1\\nsoftgrain: error: a.prm:1: no\\n"
    ...             "softgrain: error: a.prm:2: nor that\\n")
    'a.prm:1: no; a.prm:2: nor that'
    """
    found = []
    for line in reversed(text.strip().splitlines()):
        if not line.startswith(ERROR):
            break
        found.append(line.strip().removeprefix(ERROR))
    return "; ".join(reversed(found))


def error_of(text, code):
    """The program's own line about why it ended, of all that it printed."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    own = [number for number, line in enumerate(lines) if line.startswith(ERROR)]
    if own:
        return last_errors("\n".join(lines[: own[-1] + 1]))
    return f"ended by signal {-code}" if code < 0 else f"ended with status {code}"


def call(words, timeout=None):
    """
    Starts the program; returns what it printed. Of a run that takes too long, or that Ctrl-C ends,
    the state is saved.
    """
    process = subprocess.Popen(
        words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    try:
        printed, errors = process.communicate(timeout=timeout)
    except (subprocess.TimeoutExpired, KeyboardInterrupt) as error:
        process.terminate()
        try:
            process.communicate(timeout=GRACE)
        finally:
            process.kill()
            process.wait()
        if isinstance(error, KeyboardInterrupt):
            raise
        raise RunFailed(f"over {timeout} s") from error
    if process.returncode != 0:
        said = (
            last_errors(errors)
            or (errors.strip().splitlines() or [f"ended with status {process.returncode}"])[-1]
        )
        raise (InputError if process.returncode == 2 else RunFailed)(said)
    return printed


@functools.lru_cache(maxsize=None)
def knows(program, option):
    """Whether the command `run` of a program has an option."""
    return option in call((program, "run", "--help"))


def run(
    scene,
    set=None,
    output=None,
    threads=None,
    program=None,
    timeout=None,
    again=None,
    restart=False,
    overwrite=False,
    verbose=False,
):
    """
    Runs a parameter file, or a Scene, with some parameters changed and returns the finished run.

    @set: {"Section/Name": value}. @output: folder of the results (default: that of the file). A run
    that is there already is an error unless something is said: of one that is finished, again=False
    opens it only and again=True runs it again; restart=True goes on with one that is not, from its
    newest checkpoint, and overwrite=True loses either. restart=FILE goes on from that checkpoint.
    @timeout: seconds. @verbose prints the command first. What the program prints is kept in the
    attribute `log` of the run. InputError and RunFailed tell what the program said.

    >>> run(example_scene, set={"Stop/Axial strain": 0.005}, output=scratch + "/quick").finished
    True
    """
    if hasattr(scene, "write"):
        return scene.run(
            output,
            set=set,
            threads=threads,
            program=program,
            timeout=timeout,
            again=again,
            restart=restart,
            overwrite=overwrite,
            verbose=verbose,
        )
    program = find_program(program)
    changes = {name: text_of(value) for name, value in (set or {}).items()}
    if not os.path.exists(scene):
        raise InputError(f"{scene}: there is no such file")
    if restart and overwrite:
        raise InputError("restart and overwrite exclude each other")
    origin = with_start(Origins(scene, program).of(changes), restart)
    folder = os.fspath(output) if output is not None else output_of(scene, changes)
    finished = again is not None and os.path.isdir(folder) and Run(folder).finished
    if finished and not again:
        return run_that_is_there(folder, origin)
    overwrite = overwrite or (finished and not restart)
    words = [program, "run", os.fspath(scene)]
    for name, value in changes.items():
        words += ["--set", f"{name}={value}"]
    words += ["--output", folder] if output is not None else []
    words += ["--threads", str(threads)] if threads is not None else []
    if restart:
        words += ["--restart"] if restart is True else ["--restart", os.fspath(restart)]
    # A program without this option loses an unfinished run without being told to.
    words += ["--overwrite"] if overwrite and knows(program, "--overwrite") else []
    if verbose:
        print("#", shlex.join(words), file=sys.stderr, flush=True)
    log = call(words, timeout)
    write_origin(folder, origin)
    result = Run(folder)
    result.log = log
    return result


def with_start(origin, restart):
    """What makes a run that goes on from a checkpoint of another one, if it does."""
    if restart in (False, True, None) or not os.path.isfile(restart):
        return origin
    return replace(origin, files={**origin.files, "restart": digest_of(restart)})


def run_that_is_there(folder, origin):
    """The finished run in a folder, if it was made by all that is asked for."""
    said = why_not(folder, origin)
    if said is None:
        raise InputError(
            f"{folder} holds a run that was not started from Python, so that nobody knows whether"
            " it is this one: softgrain.open() opens it, again=True makes it anew"
        )
    if said:
        raise InputError(
            f"{folder} holds another run, with {said}: name another folder, or say again=True to"
            " lose it"
        )
    found = Run(folder)
    found.log = None
    return found


def output_of(scene, changes):
    """The folder into which the program writes when it is not told."""
    text, folder = entries_of(os.fspath(scene)).get("Output directory", ("", ""))
    named = changes.get("Output directory") or (os.path.join(folder, text) if text else "")
    return named or os.path.join("output", pathlib.Path(scene).stem)


def name_of(changes):
    """
    A folder name that tells what was changed.

    >>> name_of({"Contact/Friction": 0.3, "Packing/Seed": 2})
    'Friction=0.3_Seed=2'
    """
    text = "_".join(f"{key.rsplit('/', 1)[-1]}={text_of(value)}" for key, value in changes.items())
    return "".join(c if c.isalnum() or c in "=._+-" else "-" for c in text) or "run"


def folder_name(changes, origin):
    """A folder name that tells what was changed, and that no run of another origin has."""
    return f"{name_of(changes)[:80]}-{origin.digest[:8]}"


def measure(directory, program=None):
    """
    The values of all measures at the snapshots of a run, worked out by the program; nothing is
    written into the folder.
    """
    from .tables import read_table

    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "measures.csv")
        call([find_program(program), "measure", os.fspath(directory), "--output", path])
        return read_table(path)
