#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every header compiles alone. Takes the flags of a build; --header checks only that one."""
import argparse
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import common

ROOT = Path(__file__).resolve().parents[2]


def flags_of(build):
    """Flags of a source of base/, without its precompiled header."""
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        if "/source/base/" in entry["file"]:
            words = shlex.split(entry["command"])
            start = max(number for number, word in enumerate(words[:8]) if re.search(r"(\+\+|clang)", word))
            kept = [word for word in words[start:] if word not in (entry["file"], "-c")]
            for option in ("-o", "-include"):  # both with what follows
                while option in kept:
                    del kept[kept.index(option):kept.index(option) + 2]
            return kept
    sys.exit("no source of base/ in compile_commands.json")


def headers():
    """All of them: a source that includes its header first proves little when a precompiled header comes before."""
    return [ROOT / path for path in common.files(ROOT, ".h") if "softgrain" in path.parts[:-1]]


def compiles(flags, header):
    run = subprocess.run([*flags, "-fsyntax-only", "-Wno-pragma-once-outside-header", "-x", "c++", str(header)],
                         cwd=ROOT, capture_output=True, text=True, check=False)
    return run.returncode == 0, run.stderr


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--build", type=Path, required=True, help="folder with compile_commands.json")
parser.add_argument("--header", type=Path, action="append", help="check this one")
arguments = parser.parse_args()
compiler = flags_of(arguments.build)

with tempfile.TemporaryDirectory() as place:
    sample = Path(place) / "sample.h"
    sample.write_text("inline std::vector<int> nothing() { return {}; }\n", encoding="utf-8")
    if compiles(compiler, sample)[0]:
        sys.exit("a header that lacks <vector> compiles: this check cannot fail")

wrong = 0
chosen = arguments.header or headers()
with ThreadPoolExecutor(max(1, (os.cpu_count() or 2) // 2)) as pool:
    for path, (good, said) in zip(chosen, pool.map(lambda header: compiles(compiler, header), chosen)):
        if not good:
            wrong += 1
            print(f"{path}: does not compile alone\n{said}")
print(f"{len(chosen)} headers, {wrong} of them do not compile alone")
sys.exit(1 if wrong else 0)
