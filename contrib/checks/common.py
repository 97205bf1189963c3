# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the checks share: which files there are, and how a finding is reported."""
import argparse
import os
import subprocess
import sys
from pathlib import Path

NOT_OURS = {".git", "__pycache__", ".cache"}  # in any folder
NOT_OURS_AT_ROOT = {"build", "output"}


def files(root, *endings):
    """Paths, relative to root, of the files that are tracked or about to be; of a folder without git, all of them."""
    git = subprocess.run(
        ["git", "-c", "safe.directory=*", "-C", str(root), "ls-files", "-z", "--cached", "--others",
         "--exclude-standard"],
        capture_output=True, check=False) if (Path(root) / ".git").exists() else None
    if git is not None and git.returncode == 0:
        names = [Path(os.fsdecode(name)) for name in git.stdout.split(b"\0") if name]
    else:
        names = []
        for folder, folders, found in os.walk(root):
            folders[:] = [name for name in folders if name not in NOT_OURS
                          and not (Path(folder) == Path(root) and name in NOT_OURS_AT_ROOT)]
            names += [(Path(folder) / name).relative_to(root) for name in found]
    return sorted({name for name in names
                   if (not endings or name.name.endswith(endings)) and (Path(root) / name).is_file()})


def lines(root, path):
    """The lines of a text file; none of a binary one."""
    try:
        return (Path(root) / path).read_text(encoding="utf-8").splitlines()
    except UnicodeDecodeError:
        return []


def is_script(root, path):
    """A program without an ending that starts with a shebang, such as quickstart."""
    with open(Path(root) / path, "rb") as stream:
        return path.suffix == "" and stream.read(2) == b"#!"


def main(check, description):
    """Runs check(root), prints what it found, and ends with status 1 when that is anything."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2], help="folder to check")
    arguments = parser.parse_args()
    findings = list(check(arguments.root.resolve()))
    for finding in findings:
        print(finding)
    print(f"{len(findings)} finding(s)")
    sys.exit(1 if findings else 0)
