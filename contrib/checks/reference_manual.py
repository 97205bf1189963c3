#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Doxygen builds the manual without a warning, and its pages have no broken links. First both checks must find a mistake of a
sample.
"""
import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import manual_links

ROOT = Path(__file__).resolve().parents[2]


def doxygen(folder, output, **changes):
    """Status and warnings with doc/Doxyfile and some of its settings changed."""
    settings = (ROOT / "doc/Doxyfile").read_text(encoding="utf-8")
    changes = {"OUTPUT_DIRECTORY": output, **changes}
    for name, value in changes.items():
        values = value if isinstance(value, list) else [value]
        settings += f"{name} = " + " ".join(f'"{one}"' for one in values) + "\n"
    Path(output).mkdir(parents=True, exist_ok=True)
    done = subprocess.run(["doxygen", "-"], input=settings, cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", type=Path, required=True, help="where the manual goes")
arguments = parser.parse_args()

with tempfile.TemporaryDirectory() as place:
    (Path(place) / "a.h").write_text("/// Doubles.\n/// @param y is not there\nint twice(int x);\n", encoding="utf-8")
    status, said = doxygen(place, place, INPUT="a.h", USE_MDFILE_AS_MAINPAGE="")
    if status == 0 or "argument 'y'" not in said:
        print("doxygen does not find the wrong comment of the sample:", said)
        sys.exit(1)

with tempfile.TemporaryDirectory() as place:
    if not manual_links.self_test(place):
        print("the links of the sample are not mended")
        sys.exit(1)

names = next(line for line in (ROOT / "doc/Doxyfile").read_text(encoding="utf-8").splitlines()
             if line.startswith("INPUT ")).partition("=")[2].split()
names = [name for name in names if (ROOT / name).exists()]
with tempfile.TemporaryDirectory() as place:
    folder = ROOT
    if " " in str(ROOT):  # doxygen 1.9 cuts links between pages at a blank of the folder's name: let it see a copy
        folder = Path(place)
        for name in names:
            (shutil.copytree if (ROOT / name).is_dir() else shutil.copy)(ROOT / name, folder / name)
    status, said = doxygen(folder, arguments.output.resolve(), INPUT=names)
    said = said.replace(f"{folder}/", "")
if status == 0:
    manual_links.mend(ROOT, arguments.output.resolve() / "html")
    said += "".join(f"{line}\n" for line in manual_links.broken(arguments.output.resolve() / "html"))
print(said or f"no warnings; {arguments.output.resolve()}/html/index.html")
sys.exit(1 if status != 0 or said.strip() else 0)
