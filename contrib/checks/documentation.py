#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Links of the manual lead somewhere, parameter files it names exist, citations are in doc/references.bib, and every shipped
scene is in the gallery.
"""
import re
from urllib.parse import unquote

import common

LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)<>\s]+)>?(?:\s+\"[^\"]*\")?\s*\)")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")
PARAMETER_FILE = re.compile(r"(?<![\w*{}<>$-])([\w./-]+\.prm)\b(?!\.)")
CITATION = re.compile(r"[@\\]cite\s+([\w:-]+)")
# Names that stand for a file of the user, and the file that every output folder holds.
STAND_INS = re.compile(r"(^|/)([A-Z_]+|parameters|my_?\w*|your_?\w*|other|scene|run|a|b)\.prm$")


def prose(lines):
    """Numbered lines outside fenced code."""
    fenced = False
    for number, line in enumerate(lines, 1):
        if line.lstrip().startswith(("```", "~~~")):
            fenced = not fenced
        elif not fenced:
            yield number, line


def anchors(lines):
    """Names that GitHub gives to the headings of a page."""
    names = set(re.findall(r'<a (?:id|name)="([^"]+)"', "\n".join(lines)))
    for _, line in prose(lines):
        if heading := HEADING.match(line):
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).lower()
            slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            count = 0
            while (slug if count == 0 else f"{slug}-{count}") in names:
                count += 1
            names.add(slug if count == 0 else f"{slug}-{count}")
    return names


def check_links(root, path, lines):
    for number, line in prose(lines):
        for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
            if re.match(r"[a-z][a-z0-9+.-]*:", target):
                continue
            name, _, anchor = unquote(target).partition("#")
            place = (root / path.parent / name).resolve() if name else root / path
            if not place.exists():
                yield f"{path}:{number}: link to nothing: {target}"
            elif anchor and place.suffix == ".md" and anchor not in anchors(common.lines(root, place)):
                yield f"{path}:{number}: no heading #{anchor} in {place.name}"


def check(root):
    paths = common.files(root)
    scenes = [path for path in paths if path.suffix == ".prm"]
    bibliography = root / "doc/references.bib"
    keys = set(re.findall(r"^@\w+\{([^,]+),", bibliography.read_text(encoding="utf-8"), re.M)
               if bibliography.exists() else [])
    for path in paths:
        lines = common.lines(root, path) if path.name.endswith((".md", ".h", ".cc")) else []
        if path.suffix == ".md":
            yield from check_links(root, path, lines)
        made = set(re.findall(r"> *([\w./-]+\.prm)\b", "\n".join(lines)))  # by a command of the page: cat > name.prm
        for number, line in enumerate(lines, 1):
            for key in CITATION.findall(line):
                if key not in keys:
                    yield f"{path}:{number}: not in doc/references.bib: {key}"
            for name in PARAMETER_FILE.findall(line) if path.suffix == ".md" else []:
                known = any(f"/{scene}".endswith("/" + name.lstrip("./")) for scene in scenes)
                if not known and name not in made and not STAND_INS.search(name):
                    yield f"{path}:{number}: no such parameter file: {name}"


    yield from check_gallery(root, scenes)


def check_gallery(root, scenes):
    """Every scene of parameters/ has a row with a picture; studies have pages of their own."""
    page = root / "doc/gallery.md"
    rows = [line for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("| ![")] \
        if page.exists() else []
    for scene in scenes:
        if scene.parts[0] == "parameters" and scene.parts[1] != "studies" and not any(f"`{scene.name}`" in row for row in rows):
            yield f"doc/gallery.md: {scene} has no row with a picture"


common.main(check, __doc__)
