#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""quickstart on a pretended machine: stand-ins for apt, cmake and ctest write down how they are called."""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = ("bash", "env", "readlink", "dirname", "basename", "awk", "sed", "grep", "nproc", "find", "sort", "cat", "mkdir",
        "touch", "python3")
STAND_INS = {
    # Knows every package but those named in MISSING.
    "dpkg-query": 'for p in "$@"; do case "$p" in -*) ;; *) case " $MISSING " in *" $p "*) ;;'
                  ' *) echo "installed $p" ;; esac ;; esac; done',
    # Knows every package but those named in UNKNOWN.
    "apt-cache": 'case " $UNKNOWN " in *" $3 "*) exit 100 ;; esac',
    "apt-get": 'echo "apt-get $* [$DEBIAN_FRONTEND]" >>"$LOG"',
    "sudo": 'echo "sudo" >>"$LOG"; exec "$@"',
    "id": 'echo "$USER_ID"',
    "cmake": 'echo "cmake $*" >>"$LOG"',
    "ctest": 'echo "ctest $*" >>"$LOG"; exit 7',
}


class Machine:
    """A copy of quickstart in a folder whose name has blanks, and a PATH with stand-ins."""

    def __init__(self, folder):
        self.root = Path(folder) / "soft grain"
        self.log = Path(folder) / "log"
        programs = Path(folder) / "bin"
        (self.root / "cmake").mkdir(parents=True)
        programs.mkdir()
        for name in ("quickstart", "cmake/packages.txt"):
            shutil.copy(ROOT / name, self.root / name)
        for name, text in STAND_INS.items():
            (programs / name).write_text(f"#!/bin/sh\n{text}\n")
            (programs / name).chmod(0o755)
        for name in KEPT:
            (programs / name).symlink_to(shutil.which(name))
        softgrain = self.root / "build/release/bin/softgrain"
        softgrain.parent.mkdir(parents=True)
        softgrain.write_text('#!/bin/sh\necho "softgrain $*" >>"$LOG"\n'
                             'case "$1" in render) mkdir -p "$2" && touch "$2/last.png" ;; esac\n')
        softgrain.chmod(0o755)
        self.environment = {"PATH": str(programs), "LOG": str(self.log)}

    def run(self, *arguments, missing="", unknown="", user=0):
        self.log.write_text("")
        done = subprocess.run([self.root / "quickstart", *arguments], stdin=subprocess.DEVNULL, cwd="/",
                              env={**self.environment, "MISSING": missing, "UNKNOWN": unknown, "USER_ID": str(user)},
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr, self.log.read_text()


failures = 0


def expect(what, condition, *shown):
    global failures
    print(("ok      " if condition else "WRONG   ") + what)
    if not condition:
        failures += 1
        print(*shown, sep="\n---\n")


with tempfile.TemporaryDirectory() as place:
    machine = Machine(place)

    status, said, log = machine.run("build")
    expect("nothing missing: apt is left alone, preset configured, executable built",
           status == 0 and "apt-get" not in log and "--preset release" in log and "softgrain_executable" in log,
           status, said, log)

    status, said, log = machine.run("build", missing="cmake numdiff")
    expect("root: exactly the missing package of the task, unasked, after one update",
           status == 0 and "missing Debian packages: cmake\n" in said and log.count("apt-get update") == 1
           and "apt-get install -y -q --no-install-recommends cmake [noninteractive]" in log and "sudo" not in log,
           status, said, log)

    status, said, log = machine.run("test", missing="numdiff", user=1000)
    expect("user without --yes and without a terminal: nothing is installed",
           status == 1 and "--yes" in said and log == "", status, said, log)

    status, said, log = machine.run("test", "--yes", missing="numdiff", user=1000)
    expect("user with --yes: through sudo; the tests' status is passed on",
           status == 7 and "sudo" in log and "--no-install-recommends numdiff [" in log, status, said, log)
    expect("only the quick tests, in parallel, and no tests is an error",
           "-L ^quick$" in log and "--no-tests=error" in log and "-j" in log, log)

    status, said, log = machine.run("test", missing="clang-format-14")
    expect("the version that a check needs is installed where the release has it",
           "--no-install-recommends clang-format-14 [" in log, status, said, log)
    status, said, log = machine.run("test", missing="clang-format-14", unknown="clang-format-14")
    expect("a release without it goes without", status == 7 and "apt-get" not in log, status, said, log)
    status, said, log = machine.run("format", missing="clang-format-14 clang-format", unknown="clang-format-14")
    expect("of two names the one that the release has is installed",
           "--no-install-recommends clang-format [" in log, status, said, log)

    status, said, log = machine.run("test", "--nightly")
    expect("--nightly adds the long tests", "-L ^(quick|nightly)$" in log, log)

    scene = machine.root / "my scene.prm"
    scene.write_text("")
    status, said, log = machine.run("run", str(scene), "--threads", "1")
    output = machine.root / "output/my scene"
    expect("run: options reach softgrain, pictures are drawn and listed",
           status == 0 and f"softgrain run {scene} --threads 1 --output {output}" in log
           and f"softgrain render {output}" in log and f"softgrain plot {output}" in log
           and f"{output}/last.png" in said, status, said, log)

    (output / "parameters.prm").write_text("")
    (output / "summary.json").write_text('{\n  "status": "interrupted",\n')
    status, said, log = machine.run("run", str(scene))
    expect("run: one that was stopped before its first checkpoint begins anew",
           status == 0 and log.count("--overwrite") == 1 and "--restart" not in log, status, said, log)
    (output / "state-000000012.h5").write_text("")
    status, said, log = machine.run("run", str(scene))
    expect("run: one that was stopped goes on",
           status == 0 and f"softgrain run {scene} --output {output} --restart" in log and "going on" in said,
           status, said, log)
    status, said, log = machine.run("run", str(scene), "--overwrite")
    expect("run: unless it shall begin anew", status == 0 and "--restart" not in log, status, said, log)
    (output / "summary.json").write_text('{\n  "status": "completed",\n')
    status, said, log = machine.run("run", str(scene))
    expect("run: one that has ended is not computed again, but drawn",
           status == 0 and "softgrain run" not in log and f"softgrain render {output}" in log and "has ended" in said,
           status, said, log)
    status, said, log = machine.run("run", str(scene), "--overwrite")
    expect("run: unless it shall begin anew, too",
           status == 0 and f"softgrain run {scene} --overwrite --output {output}" in log, status, said, log)

    status, said, log = machine.run("run", "nowhere.prm")
    expect("run: a file that is not there is named before anything is built",
           status == 1 and "nowhere.prm" in said and log == "", status, said, log)

    status, said, log = machine.run("--help")
    expect("--help", status == 0 and "usage:" in said and log == "", status, said, log)
    status, said, log = machine.run("dance")
    expect("unknown task", status == 2 and log == "", status, said, log)

sys.exit(1 if failures else 0)
