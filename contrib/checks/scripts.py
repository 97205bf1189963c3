#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Scripts can be read: Python parses, shell scripts pass bash -n, and shellcheck where it is installed. What names its interpreter can be
called by its name. Modules of the Python package import each other in no circle, not even inside of functions, and neither they nor the
tools have lines above a hundred columns.
"""
import ast
import os
import shutil
import subprocess

import common


PACKAGE = "python/softgrain"
COLUMNS = 100


def imports_of(root, path, modules):
    """The modules of the package that a module of it imports."""
    for node in ast.walk(ast.parse((root / path).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.level:
            folder = path.parents[node.level - 1]
            place = folder.joinpath(*(node.module or "").split("."))
            for name in (place, *(place / alias.name for alias in node.names)):
                if name.with_suffix(".py") in modules:
                    yield name.with_suffix(".py")


def circles(root, paths):
    """Modules that come back to themselves by what they import."""
    modules = {path for path in paths if path.suffix == ".py" and path.as_posix().startswith(PACKAGE + "/")}
    imported = {path: set(imports_of(root, path, modules)) for path in modules}
    for start in sorted(modules):
        reached, ahead = set(), set(imported[start])
        while ahead:
            reached |= ahead
            ahead = set().union(*(imported[path] for path in ahead)) - reached
        if start in reached:
            yield f"{start}: imports itself by way of {' and '.join(str(path) for path in sorted(imported[start] & reached))}"


def check(root):
    broken = False
    for path in common.files(root):
        first = (common.lines(root, path)[:1] or [""])[0]
        if first.startswith("#!") and not os.access(root / path, os.X_OK):
            yield f"{path}: begins with '{first}' and cannot be executed: chmod +x"
        if path.suffix == ".py" or (first.startswith("#!") and "python" in first):
            if path.parts[0] == "python":
                yield from (f"{path}:{number}: {len(line)} columns, at most {COLUMNS}"
                            for number, line in enumerate(common.lines(root, path), 1) if len(line) > COLUMNS)
            try:
                ast.parse((root / path).read_text(encoding="utf-8"), str(path))
            except SyntaxError as error:
                broken = True
                yield f"{path}:{error.lineno}: {error.msg}"
        elif path.suffix == ".sh" or (first.startswith("#!") and first.endswith("sh")):
            commands = [["bash", "-n", str(path)]]
            if shutil.which("shellcheck"):
                commands.append(["shellcheck", "--format=gcc", str(path)])
            for command in commands:
                run = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
                if run.returncode != 0:
                    yield (run.stdout + run.stderr).strip()
    if not broken:
        yield from circles(root, common.files(root, ".py"))


common.main(check, __doc__)
