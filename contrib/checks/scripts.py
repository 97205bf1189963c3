#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripts can be read: Python parses, shell scripts pass bash -n, and shellcheck where it is installed. What names its interpreter can be
called by its name."""
import ast
import os
import shutil
import subprocess

import common


def check(root):
    for path in common.files(root):
        first = (common.lines(root, path)[:1] or [""])[0]
        if first.startswith("#!") and not os.access(root / path, os.X_OK):
            yield f"{path}: begins with '{first}' and cannot be executed: chmod +x"
        if path.suffix == ".py" or (first.startswith("#!") and "python" in first):
            try:
                ast.parse((root / path).read_text(encoding="utf-8"), str(path))
            except SyntaxError as error:
                yield f"{path}:{error.lineno}: {error.msg}"
        elif path.suffix == ".sh" or (first.startswith("#!") and first.endswith("sh")):
            commands = [["bash", "-n", str(path)]]
            if shutil.which("shellcheck"):
                commands.append(["shellcheck", "--format=gcc", str(path)])
            for command in commands:
                run = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
                if run.returncode != 0:
                    yield (run.stdout + run.stderr).strip()


common.main(check, __doc__)
