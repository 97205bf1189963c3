#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Runs the storm of random scenes (doc/storm.md) and writes its page, doc/results/storm.md, and doc/results/data/storm.csv.

    storm.py PROGRAM [--seeds 1-500] [--jobs 2] [--work storm-500]

What is in the work folder already is not run again, so that an interrupted storm goes on.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "doc/results/storm.md"
BEGIN, END = "<!-- table of contrib/results/storm.py -->\n", "<!-- end of the table -->\n"


def table_of_failures(scenes):
    """A row per failure, those of one relation and kind together."""
    rows = {}
    for scene in scenes:
        for relation, kind, _ in scene["fails"]:
            rows.setdefault((relation, kind), []).append(scene)
    lines = ["| relation | kind | scenes | schemes | first seeds |", "|---|---|---|---|---|"]
    for (relation, kind), found in sorted(rows.items(), key=lambda item: -len(item[1])):
        schemes = sorted({scene["scheme"] for scene in found})
        seeds = ", ".join(str(scene["seed"]) for scene in found[:6])
        lines.append(f"| {relation} | {kind} | {len(found)} | {', '.join(schemes)} | {seeds} |")
    return "\n".join(lines) + "\n"


def write_rows(scenes, path):
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["seed", "family", "model", "scheme", "seconds", "asked", "bifurcations", "fails"])
        for scene in scenes:
            table.writerow([scene["seed"], scene["family"], scene["model"], scene["scheme"], scene["seconds"],
                            "; ".join(dict.fromkeys(scene["asked"])), "; ".join(scene["bifurcations"]),
                            "; ".join(f"{relation} / {kind}" for relation, kind, _ in scene["fails"])])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--seeds", default="1-500")
    parser.add_argument("--jobs", default="2")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("storm-500"))
    options = parser.parse_args()
    storm = [sys.executable, str(ROOT / "tests/storm/storm.py"), "--program", str(options.program), "--seeds", options.seeds,
             "--jobs", options.jobs, "--output", str(options.work), "--owed", str(ROOT / "tests/storm/owed.txt")]
    if subprocess.run(storm, check=False).returncode not in (0, 1):
        return 1
    scenes = json.loads((options.work / "table.json").read_text())["scenes"]
    write_rows(scenes, ROOT / "doc/results/data/storm.csv")
    seconds = sum(scene["seconds"] for scene in scenes)
    mean = f"{len(scenes)} scenes, {seconds / len(scenes):.1f} s of processor time a scene in the mean.\n\n"
    text = PAGE.read_text()
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    found = mean + (options.work / "table.md").read_text() + "\n" + table_of_failures(scenes)
    PAGE.write_text(before + BEGIN + "\n" + found + "\n" + END + after)
    return 0


if __name__ == "__main__":
    sys.exit(main())
