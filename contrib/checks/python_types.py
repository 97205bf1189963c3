#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types of the Python package and of its tools agree, as mypy sees them with the settings of python/pyproject.toml."""
import shutil
import subprocess
import tempfile

import common


def check(root):
    if shutil.which("mypy") is None:
        print("not checked: mypy is not installed: Debian's package mypy")
        return
    with tempfile.TemporaryDirectory() as cache:
        done = subprocess.run(["mypy", "--cache-dir", cache, "--no-error-summary"], cwd=root / "python", capture_output=True, text=True,
                              check=False)
    if done.returncode != 0:
        yield from (done.stdout + done.stderr).splitlines()


common.main(check, __doc__)
