#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""No notes to oneself, no paths of one's own machine, no conflict markers, no file too long to read in one go."""
import re

import common

MOST_LINES = 500
READ_IN_ONE_GO = (".h", ".cc", ".py", ".sh", ".cmake", ".md", "CMakeLists.txt")
NOTES = re.compile(r"\b(" + "|".join(("TO" + "DO", "FIX" + "ME", "X" + "XX", "HA" + "CK")) + r")\b")
# Folders that are one person's or one machine's; a colon or word before the slash makes it part of an address.
MACHINE = re.compile(r"(?<![\w.:~$})/-])/(home|root|work|Users|tmp|mnt|scratch)/\w")
CONFLICT = re.compile(r"^(<{7}|>{7})( |$)")


def check(root):
    for path in common.files(root):
        if path.name == "LICENSE":
            continue
        lines = common.lines(root, path)
        for number, line in enumerate(lines, 1):
            if note := NOTES.search(line):
                yield f"{path}:{number}: '{note[0]}': do it, or describe the limit in the documentation"
            if place := MACHINE.search(line):
                yield f"{path}:{number}: a path of one machine: {place[0]}..."
            if CONFLICT.match(line):
                yield f"{path}:{number}: conflict marker"
        if len(lines) > MOST_LINES and (path.name.endswith(READ_IN_ONE_GO) or common.is_script(root, path)):
            yield f"{path}: {len(lines)} lines, at most {MOST_LINES}: cut it where its subject changes"


common.main(check, __doc__)
