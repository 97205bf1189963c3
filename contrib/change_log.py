#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the change log of this version, made of the files in doc/changes: contrib/change_log.py > CHANGELOG.md"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
KINDS = {"New": "New", "Changed": "Changed: what to do about it is said", "Fixed": "Fixed"}


def entries():
    """(kind, date, text) of every file, newest first."""
    for path in sorted((ROOT / "doc/changes").glob("2*_*"), reverse=True):
        kind, _, text = path.read_text(encoding="utf-8").partition(":")
        if kind not in KINDS:
            sys.exit(f"{path}: the first word must be one of {', '.join(KINDS)}, with a colon")
        yield kind, path.name[:8], " ".join(text.split())


def main():
    version = re.search(r"SOFTGRAIN_VERSION (\S+)\)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    found = list(entries())
    dates = [date for _, date, _ in found]
    print(f"# softgrain {version}\n\nMade by `contrib/change_log.py` from `doc/changes`, "
          f"{dates[-1][:4]}-{dates[-1][4:6]}-{dates[-1][6:]} to {dates[0][:4]}-{dates[0][4:6]}-{dates[0][6:]}.")
    for kind, heading in KINDS.items():
        texts = [text for one, _, text in found if one == kind]
        if texts:
            print(f"\n## {heading}\n")
            print("\n".join(f"- {text[0].upper()}{text[1:]}" for text in texts))


main()
