#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Licence line, header guard named after part and file, a source includes its own header."""
import re

import common

LICENCE = "SPDX-License-Identifier: LGPL-2.1-or-later"
WITH_LICENCE = (".h", ".cc", ".py", ".sh", ".cmake", ".h.in", "CMakeLists.txt")


def guard_of(path):
    """softgrain_<part>_<name>_h of include/softgrain/<part>/<name>.h and of bpm/include/softgrain/bpm/<name>.h."""
    pieces = path.parts[path.parts.index("softgrain"):]
    return re.sub(r"\W", "_", "_".join(pieces[:-1] + (path.stem,))) + "_h"


def header_of(path):
    """How the header of a source is included: source/<part>/<name>.cc has softgrain/<part>/<name>.h."""
    if path.parts[0] == "source":
        return "/".join(("softgrain",) + path.parts[1:-1] + (path.stem + ".h",))
    if path.parts[:2] == ("bpm", "source"):
        return "/".join(("softgrain", "bpm") + path.parts[2:-1] + (path.stem + ".h",))
    return None


def check(root):
    paths = common.files(root)
    headers = {"/".join(path.parts[path.parts.index("softgrain"):]) for path in paths
               if path.suffix == ".h" and "softgrain" in path.parts}
    for path in paths:
        script = common.is_script(root, path)
        if not script and not path.name.endswith(WITH_LICENCE):
            continue
        lines = common.lines(root, path)
        if not any(LICENCE in line for line in lines[:2]):
            yield f"{path}:1: the first line (the second, after #!) must hold '{LICENCE}'"
        if path.suffix == ".h" and "softgrain" in path.parts[:-1]:
            guard = guard_of(path)
            code = [line.strip() for line in lines if line.strip().startswith("#")]
            if code[:2] != [f"#ifndef {guard}", f"#define {guard}"] or code[-1] != "#endif":
                yield f"{path}: its include guard must be {guard}"
        if path.suffix == ".cc" and header_of(path) in headers:
            if f"#include <{header_of(path)}>" not in lines:
                yield f"{path}: does not include its own header {header_of(path)}"


common.main(check, __doc__)
