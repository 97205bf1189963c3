#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""C++ files are laid out as .clang-format says, by the clang-format it is written for."""
import shutil
import subprocess
from pathlib import Path

import common

VERSION = "14"
RELEASES = ("12", )  # of Debian, with that version; others lay out some lines in another way


def release():
    """Number of this Debian release; None on other systems."""
    try:
        lines = Path("/etc/os-release").read_text().splitlines()
    except OSError:
        return None
    words = dict(line.replace('"', "").split("=", 1) for line in lines if "=" in line)
    return words.get("VERSION_ID") if words.get("ID") == "debian" else None


def check(root):
    program = shutil.which(f"clang-format-{VERSION}") or shutil.which("clang-format")
    if shutil.which(f"clang-format-{VERSION}") is None and release() not in RELEASES:
        print(f"not checked: this system has no clang-format {VERSION}")
        return
    if program is None:
        yield f"clang-format is not installed: Debian's package clang-format-{VERSION}"
        return
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    if f"version {VERSION}." not in version:
        yield f"clang-format {VERSION} is needed, found: {version.strip()}"
        return
    paths = [str(path) for path in common.files(root, ".h", ".cc")]
    for first in range(0, len(paths), 50):
        run = subprocess.run([program, "--dry-run", "-Werror", "--style=file", *paths[first:first + 50]],
                             cwd=root, capture_output=True, text=True, check=False)
        wrong = [line.split(": error:")[0] for line in run.stderr.splitlines() if ": error:" in line]
        yield from (f"{place}: not formatted; ./quickstart format" for place in wrong)
        if run.returncode != 0 and not wrong:
            yield run.stderr.strip()


common.main(check, __doc__)
