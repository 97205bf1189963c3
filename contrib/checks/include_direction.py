#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts include only the parts they may know; contact/ headers are free of deal.II."""
import re

import common

# doc/architecture: who may include whom. Every part may include itself.
MAY_INCLUDE = {
    "base": set(),
    "parameters": {"base"},
    "linear": {"base"},
    "contact": {"base"},
    "constitutive": {"base"},
    "geometry": {"base", "parameters"},
    "analysis": {"base", "geometry"},
    "packing": {"base", "parameters", "contact"},
    "scene": {"base", "parameters", "geometry", "packing"},
    "model": {"base", "analysis", "scene"},
    "output": {"base", "parameters", "scene", "analysis", "model"},
    "driving": {"base", "parameters", "geometry", "scene", "analysis", "model"},
    "mpm": {
        "base", "parameters", "linear", "contact", "constitutive", "geometry", "scene", "analysis", "model", "driving",
    },
    "bpm": {"base", "parameters", "contact", "geometry", "packing", "scene", "analysis", "model", "driving"},
    "app": {
        "base", "parameters", "contact", "constitutive", "geometry", "analysis", "packing", "scene", "model", "output", "driving", "mpm",
        "bpm",
    },
}
INCLUDE = re.compile(r'^\s*#\s*include\s*(<([^>]+)>|"([^"]+)")')


def part_of(path):
    """The part a header or source belongs to, or None for files outside the parts (tests, plugins)."""
    pieces = path.parts
    if pieces[0] == "bpm":
        return "bpm"
    if pieces[0] == "source" and len(pieces) > 2:
        return pieces[1]
    if pieces[:2] == ("include", "softgrain") and len(pieces) > 3:
        return pieces[2]
    return None


def check(root):
    for path in common.files(root, ".h", ".cc"):
        part = part_of(path)
        if part is None:
            continue
        if part not in MAY_INCLUDE:
            yield f"{path}: '{part}' is not a part; add it to contrib/checks/include_direction.py"
            continue
        for number, line in enumerate(common.lines(root, path), 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            if found[3]:
                yield f'{path}:{number}: write <softgrain/...> instead of "{found[3]}"'
                continue
            pieces = found[2].split("/")
            if pieces[0] == "softgrain" and pieces[1] != part and pieces[1] not in MAY_INCLUDE[part]:
                yield f"{path}:{number}: {part} may not include {pieces[1]}: {found[2]}"
            if pieces[0] == "deal.II" and part == "contact" and path.suffix == ".h":
                yield f"{path}:{number}: headers of contact/ know nothing of deal.II: {found[2]}"


common.main(check, __doc__)
