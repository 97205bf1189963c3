#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every test program has what it is expected to print, every expectation a program, and every folder is registered."""
import re

import common

# Of all columns of an expectation at once; a number below it could be anything.
LARGEST_ABSOLUTE_TOLERANCE = 1e-6


def check(root):
    listed = (root / "cmake/targets.cmake").read_text(encoding="utf-8")
    parts = set(re.search(r"set\(SOFTGRAIN_PARTS ([^)]*)\)", listed)[1].split())
    listed = (root / "tests/CMakeLists.txt").read_text(encoding="utf-8")
    extras = set(re.search(r"foreach\(extra ([^)]*)\)", listed)[1].split())
    paths = [path for path in common.files(root) if path.parts[0] == "tests" and len(path.parts) > 2]
    for folder in sorted({path.parts[1] for path in paths}):
        here = [path for path in paths if path.parts[1] == folder]
        own_list = root / "tests" / folder / "tests.cmake"
        registered = own_list.read_text(encoding="utf-8") if own_list.exists() else ""
        if folder not in parts | extras and any(path.suffix == ".cc" for path in here):
            yield f"tests/{folder}: nobody runs it; its name must be a part or in the last loop of tests/CMakeLists.txt"
        if folder not in parts:
            continue
        programs = {path.stem for path in here if path.suffix == ".cc" and len(path.parts) == 3}
        for path in here:
            if len(path.parts) != 3 or path.suffix not in (".cc", ".output"):
                continue
            name = path.name.split(".")[0]
            if path.suffix == ".output" and name not in programs and name not in registered \
                    and ".output" not in registered:
                yield f"{path}: there is no {name}.cc that prints it"
            if path.suffix == ".output" and (root / path).stat().st_size == 0:
                yield f"{path}: expects nothing, so the test cannot fail"
            if path.suffix == ".output":
                tolerance = re.match(r"# tolerance: (\S+)", (root / path).read_text(encoding="utf-8"))
                if tolerance and not float(tolerance[1]) <= LARGEST_ABSOLUTE_TOLERANCE:
                    yield f"{path}: the absolute tolerance {tolerance[1]} is above {LARGEST_ABSOLUTE_TOLERANCE:g} and " \
                          "would let small numbers be anything; give the column its own"
            if path.suffix == ".cc" and not any(
                    other.suffix == ".output" and other.name.split(".")[0] == name for other in here):
                yield f"{path}: no {name}.output beside it"


common.main(check, __doc__)
