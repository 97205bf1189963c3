# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of this folder share: a scene is run with some parameters changed, and what it wrote is read."""
import csv
import json
import math
import pathlib
import shlex
import subprocess
import sys

PARAMETERS = pathlib.Path(__file__).resolve().parents[2] / "parameters"


class RunFailed(Exception):
    """A run that ended with an error, or not in time; the text says which."""


def read_run(folder):
    """summary.json, and history.csv as a list of rows {column: number, nan where there is none}."""
    folder = pathlib.Path(folder)
    with open(folder / "summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    with open(folder / "history.csv", encoding="utf-8") as file:
        rows = [{key: float(value) if value else math.nan for key, value in row.items()} for row in csv.DictReader(file)]
    return summary, rows


def run(program, scene, folder, changes, threads=0, limit=None, again=True):
    """Runs @scene (below parameters/) with @changes {"Section/Name": value} into @folder; summary and history as
    read_run(). With again=False a run that is there already is only read. @limit: seconds it may take."""
    if again or not (pathlib.Path(folder) / "summary.json").exists():
        command = [str(program), "run", str(PARAMETERS / scene), "--output", str(folder), "--threads", str(threads)]
        for key, value in changes.items():
            command += ["--set", f"{key}={value}"]
        print("#", shlex.join(command), file=sys.stderr, flush=True)
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
        except subprocess.TimeoutExpired as error:
            raise RunFailed(f"over {limit} s") from error
        if done.returncode != 0:
            raise RunFailed((done.stderr.strip().splitlines() or [f"ended with status {done.returncode}"])[-1])
        pathlib.Path(folder, "log").write_text(done.stdout, encoding="utf-8")
    return read_run(folder)
