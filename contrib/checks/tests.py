#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every test program has what it is expected to print, every expectation a program, and every folder is registered."""
import re

import common

# A number may be off by more than this share of itself only where the word before says that it is a bound.
LARGEST_SHARE = 0.01
BOUNDS = ("below", "above", "to", "within")
# Numbers that much smaller than the absolute tolerance are what rounding has left of zero.
ROUNDING = 1e-5
LARGEST_RELATIVE_TOLERANCE = 0.05


def loose_numbers(text):
    """Numbers of an expectation that a wrong one would pass for, with the tolerance that lets it."""
    everywhere, columns = (1e-9, 1e-7), {}
    for column, absolute, relative in re.findall(r"^# tolerance(?: of column (\d+))?: (\S+) (\S+)$", text, re.MULTILINE):
        if column:
            columns[int(column)] = float(absolute), float(relative)
        else:
            everywhere = float(absolute), float(relative)
    for line in re.sub(r"^# tolerance.*\n", "", text, flags=re.MULTILINE).splitlines():
        words = [word for word in re.split(r"[ \t=,:;<>\[\](){}^']+", line) if word]
        for column, (before, word) in enumerate(zip(["", *words], words), 1):
            absolute, relative = columns.get(column, everywhere)
            try:
                size = abs(float(word))
            except ValueError:
                continue
            if relative > LARGEST_RELATIVE_TOLERANCE:
                yield word, relative
            elif before not in BOUNDS and ROUNDING * absolute < size < absolute / LARGEST_SHARE:
                yield word, absolute


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
                for number, tolerance in loose_numbers((root / path).read_text(encoding="utf-8")):
                    yield f"{path}: the tolerance {tolerance:g} lets {number} be anything; give the file or the column its own"
            if path.suffix == ".cc" and not any(
                    other.suffix == ".output" and other.name.split(".")[0] == name for other in here):
                yield f"{path}: no {name}.output beside it"


common.main(check, __doc__)
