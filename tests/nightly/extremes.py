# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Parameters at their limits: every case gives a right result, or one clear line with the last good state saved.

    extremes.py PROGRAM FOLDER [--quick] [--table FILE] [NAME...]

`--quick` takes the cases of the quick suite, names take single cases, `--table` writes doc/results/data/extremes.csv.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

from extreme_cases import CASES

LIMIT = 300  # seconds of processor time of one case; ten times that on the clock, for other programs run too


def finite_rows(folder):
    """Rows of the history as numbers; None when one of them is none."""
    with open(folder / "history.csv", newline="") as file:
        rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(file)]
    good = all(math.isfinite(value) for row in rows for key, value in row.items()
               if key not in ("axial_strain", "packing_fraction"))  # there is none without walls
    return rows if good else None


def judge_result(case, folder):
    """Energy, momentum, penetration and residual of a run that came to its end, and what is wrong with it."""
    summary = json.loads((folder / "summary.json").read_text())
    rows = finite_rows(folder)
    if rows is None:
        return {}, "a number in history.csv is not finite"
    # A balance that cannot be formed, for all of its terms are rounding, is null.
    seen = {"energy": summary["energy_balance_error"] or 0., "momentum": summary["momentum_error"] or 0.,
            "penetration": summary["max_penetration_m"] / case.length, "residual": summary["max_contact_residual"]}
    for name, value in seen.items():
        if not value <= case.limits.get(name, {"energy": 0.05, "momentum": 1e-6, "penetration": 0.02,
                                              "residual": 1e-3}[name]):
            return seen, f"{name} {value:.1e}"
    for what, right in case.checks.items():
        if not right(rows):
            return seen, f"not so: {what}"
    return seen, ""


def judge(case, done, folder):
    """Verdict ("right", "refused", "stopped" or what is wrong) and numbers of a case."""
    if done is None or done.returncode == 3:
        return f"no end within {LIMIT} s", {}
    if done.returncode == 0:
        seen, wrong = judge_result(case, folder)
        return wrong or "right", seen
    if done.returncode not in (1, 2):
        return f"exit code {done.returncode}", {}
    lines = done.stderr.splitlines()
    if len(lines) != 1 or not re.match(r"softgrain: error: \S.{15,}", lines[0]) or len(lines[0]) > 1500:
        return "not one clear line: " + done.stderr[:300], {}
    if re.search(r"\bnan\b|deal\.?ii|terminate|assert", lines[0], re.IGNORECASE):
        return "not a line for users: " + lines[0], {}
    if done.returncode == 2:
        return "refused", {}
    saved = re.search(r"the last good state is saved in (\S+)", lines[0])
    if not saved or not (folder / pathlib.Path(saved[1]).name).exists():
        return "nothing saved: " + lines[0], {}
    return "stopped", {}


def run(case, program, work):
    folder = work / re.sub(r"\W+", "_", case.name)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "scene.prm").write_text(case.scene)
    for name, text in case.files.items():
        (folder / name).write_text(text)
    words = [program, "run", "scene.prm", "--threads", "1", "--output", "out"]
    for setting in case.settings:
        words += ["--set", setting]
    try:
        # Programs that end and begin at once take the shared folder of Open MPI away from each other.
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, timeout=10 * LIMIT,
                              env={**os.environ, "TMPDIR": str(folder)},
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 60)))
    except subprocess.TimeoutExpired:
        done = None
    verdict, seen = judge(case, done, folder / "out")
    if case.warning:
        verdict = not_warned(case, program, folder) or verdict
    return verdict, seen, done.stderr.strip() if done else ""


def not_warned(case, program, folder):
    """What `check` should have said before the run, and did not."""
    words = [program, "check", "scene.prm", *(word for setting in case.settings for word in ("--set", setting))]
    said = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, timeout=LIMIT).stdout
    warned = any(line.startswith("warning: ") and case.warning in line for line in said.splitlines())
    return "" if warned else f"check does not warn: {case.warning}"


def table_row(case, verdict, seen, message):
    numbers = [f"{seen[key]:.0e}" if key in seen else "" for key in ("energy", "momentum", "penetration", "residual")]
    said = message.removeprefix("softgrain: error: ").split("; the last good state")[0]
    said = re.sub(r"[^ ]*scene\.prm:?\d*: ", "", said)
    cell = verdict if not message or verdict == "right" else f"{verdict}: {said[:150]}"
    return [case.name, *numbers, cell]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    words = parser.parse_args()
    program = words.program.resolve()
    wrong, rows = 0, []
    for case in CASES:
        if words.quick and not case.quick or words.names and not any(name in case.name for name in words.names):
            continue
        verdict, seen, message = run(case, program, words.folder.resolve())
        good = verdict in case.expected
        wrong += not good
        rows.append(table_row(case, verdict, seen, message))
        print("" if good else f"WRONG (expected {' or '.join(case.expected)}): ", " | ".join(rows[-1]), flush=True)
        if not good and message:
            print("   ", message)
    if words.table:
        with open(words.table, "w", encoding="utf-8", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["case", "energy", "momentum", "penetration", "residual", "verdict"])
            table.writerows(rows)
    print(f"{len(rows)} cases, {wrong} wrong")
    sys.exit(1 if wrong else 0)


main()
